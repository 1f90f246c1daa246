/* The path that a function in quad precision took: differences across a jump or a kink mean nothing. */
#ifndef FUZZ_PATH_H
#define FUZZ_PATH_H

#include <setjmp.h>
#include <stdint.h>

/* A new path begins. One that does not come to an end soon jumps there. */
void path_start(jmp_buf *give_up);

/* No path is followed any more. */
void path_stop(void);

/* A number that two evaluations since path_start have in common only where they went the same way. */
uint64_t path_taken(void);

#endif
