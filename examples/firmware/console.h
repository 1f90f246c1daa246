/* Text and a counter of instructions: console_host.c or console_board.c. */
#ifndef CONSOLE_H
#define CONSOLE_H

#include <stdint.h>

void console_write(const char *text);

/* Counts instructions in the emulator, modulo 2^24 ticks; stands still on a host. */
uint32_t console_ticks(void);

/* Instructions from one value of console_ticks to another. */
uint32_t console_instructions(uint32_t from, uint32_t to);

#endif
