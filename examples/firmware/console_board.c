/* The console of a board: semihosting and SysTick, with the startup that every export brings. */
#define BOARD_WITHOUT_NEED
#include "board/board.c"

#include "console.h"

/* errno of the C library's mathematics: its own comes with a kilobyte of other state. */
int *__errno(void);
int *__errno(void) {
  static int number;
  return &number;
}

void console_write(const char *text) { say(text); }

uint32_t console_ticks(void) {
  if (systick[0] == 0) board_start_ticks();
  return systick[2];
}

uint32_t console_instructions(uint32_t from, uint32_t to) { return instructions_of((from - to) & 0xFFFFFF, 1); }
