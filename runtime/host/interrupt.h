/* Ctrl-C: a flag that a driver looks at between two rows. */
#ifndef HOST_INTERRUPT_H
#define HOST_INTERRUPT_H

#include <stdbool.h>

/* From now on Ctrl-C, a request to end and the end of the terminal (but for nohup's) only set the flag, and a closed pipe is an error
 * of the write, not the end of the program. */
void watch_interrupts(void);

/* Whether the user wants the program to end. Safe from any thread. */
bool interrupted(void);

#endif
