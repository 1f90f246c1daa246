/* Runs one need of the example on an Arm Cortex-M board of qemu-system-arm, and says by semihosting what it returned and how many
 * instructions it took: footprint.py builds it with -DNEED=example_simulate. No C library but memcpy and the like. */
#include <stdint.h>

extern uint32_t board_data[], board_data_end[], board_data_source[], board_bss[], board_bss_end[], board_stack[];

/* An operation of Arm's semihosting. */
static void semihosting(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void say(const char *text) { semihosting(0x04, text); }

static void leave(int code) {
  const uint32_t block[2] = {0x20026, (uint32_t)code}; /* ADP_Stopped_ApplicationExit */
  semihosting(0x20, block);
  for (;;) {
  }
}

/* SysTick counts down, 24 bits, at 25 MHz. */
static volatile uint32_t *const systick = (volatile uint32_t *)0xE000E010;

static void board_start_ticks(void) {
  systick[1] = 0xFFFFFF;
  systick[2] = 0;
  systick[0] = 5;
}

/* Of each of so many runs: -icount shift=6 makes an instruction 64 ns long, a tick is 40 ns. */
static uint32_t instructions_of(uint32_t ticks, uint32_t runs) { return (ticks * 5 + 4 * runs) / (8 * runs); }

#ifdef BOARD_WITHOUT_NEED /* another program's main, which includes this file */
int main(void);
#else
#include "example.h"

enum { RUNS = 10 };

static void say_number(uint32_t x) {
  char digits[12];
  int at = 11;
  digits[at] = '\0';
  do {
    digits[--at] = (char)('0' + x % 10);
    x /= 10;
  } while (x > 0);
  say(digits + at);
}

static int nothing(void) { return 0; }

static uint32_t ticks_of(int (*run)(void), int *status) {
  const uint32_t start = systick[2];
  for (int i = 0; i < RUNS; i++) *status = run();
  return (start - systick[2]) & 0xFFFFFF;
}

#ifdef BOARD_STACK
/* Bytes of stack that a call writes to, of so many painted before. */
enum { PAINTED = 65536 / 4, PAINT = 0x5AFEC0DE };

static uint32_t __attribute__((noinline)) stack_of(int (*volatile run)(void), int *status) {
  uint32_t top, deepest = 0;
  __asm__ volatile("mov %0, sp" : "=r"(top));
  volatile uint32_t *const words = (volatile uint32_t *)top;
  for (int i = 1; i <= PAINTED; i++) words[-i] = PAINT;
  *status = run();
  for (uint32_t i = 1; i <= PAINTED; i++)
    if (words[-(int)i] != PAINT) deepest = i;
  return 4 * deepest;
}
#endif

int main(void) {
  int status = example_start(), none = 0;
#ifdef BOARD_STACK
  if (status == 0) {
    say("stack ");
    say_number(stack_of(NEED, &status));
    say("\n");
  }
#endif
  if (status == 0) {
    board_start_ticks();
    int (*volatile empty)(void) = nothing, (*volatile need)(void) = NEED;
    const uint32_t calls = ticks_of(empty, &none), ticks = ticks_of(need, &status);
    say("instructions ");
    say_number(instructions_of(ticks - calls, RUNS));
    say("\n");
  }
  say("status ");
  say_number((uint32_t)status);
  say("\n");
  return 0;
}
#endif

void board_reset(void); /* board.ld enters here */

void board_reset(void) {
#ifdef __ARM_FP
  *(volatile uint32_t *)0xE000ED88 |= 0xF00000; /* the floating-point unit may be used */
  __asm__ volatile("dsb\nisb");
#endif
  for (uint32_t *to = board_data, *from = board_data_source; to < board_data_end;) *to++ = *from++;
  for (uint32_t *to = board_bss; to < board_bss_end;) *to++ = 0;
  leave(main());
}

static void fault(void) { leave(100); }

typedef union {
  uint32_t *stack;
  void (*handler)(void);
} board_vector;

const board_vector board_vectors[16] __attribute__((section(".vectors"), used)) = {
    {.stack = board_stack}, {.handler = board_reset}, {.handler = fault}, {.handler = fault},
    {.handler = fault},     {.handler = fault},       {.handler = fault}};
