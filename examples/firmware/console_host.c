/* The console of a host: stdout, and no counter. */
#include "console.h"

#include <stdio.h>

void console_write(const char *text) { fputs(text, stdout); }
uint32_t console_ticks(void) { return 0; }
uint32_t console_instructions(uint32_t from, uint32_t to) { return to - from; }
