/* Follows the branches of the instrumented C (-fsanitize-coverage=trace-pc calls one function in each basic block), and takes the place
 * of the quad library's functions that have a kink or a jump, so that their side counts as a branch too. */
#include "path.h"

#include <stddef.h>

/* Basic blocks of one evaluation: ten times what a program of this size may need. */
enum { MAX_LENGTH = 20000 };

static uint64_t path;
static int length;
static jmp_buf *escape;

static void follow(uint64_t step) {
  path = (path ^ step) * UINT64_C(0x9E3779B97F4A7C15) + 1;
  if (escape && ++length > MAX_LENGTH) longjmp(*escape, 1);
}

void path_start(jmp_buf *give_up) {
  path = 0;
  length = 0;
  escape = give_up;
}

void path_stop(void) { escape = NULL; }
uint64_t path_taken(void) { return path; }

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void) { follow((uint64_t)(uintptr_t)__builtin_return_address(0)); }

static __float128 magnitude(__float128 x) { return x < 0 ? -x : x; }

/* The integer towards zero; what is as large as that in quad precision has no fraction. */
static __float128 whole(__float128 x) { return magnitude(x) < 1e18Q ? (__float128)(long long)x : x; }

static __float128 step(__float128 level) {
  follow((uint64_t)(long long)level);
  return level;
}

#define KINK1(name) __float128 name(__float128 x)
#define KINK2(name) __float128 name(__float128 x, __float128 y)

KINK1(fabsq);
KINK1(floorq);
KINK1(ceilq);
KINK1(truncq);
KINK1(roundq);
KINK2(fminq);
KINK2(fmaxq);
KINK2(fdimq);
KINK2(copysignq);
KINK2(fmodq);

KINK1(fabsq) {
  follow(x < 0);
  return magnitude(x);
}

KINK1(floorq) { return step(whole(x) - (whole(x) > x)); }
KINK1(ceilq) { return step(whole(x) + (whole(x) < x)); }
KINK1(truncq) { return step(whole(x)); }
KINK1(roundq) { return step(whole(x + (x < 0 ? -0.5Q : 0.5Q))); }
KINK2(fminq) {
  follow(x < y);
  return x < y ? x : y;
}

KINK2(fmaxq) {
  follow(x > y);
  return x > y ? x : y;
}

KINK2(fdimq) {
  follow(x > y);
  return x > y ? x - y : 0;
}

KINK2(copysignq) {
  follow((x < 0) ^ (y < 0));
  return y < 0 ? -magnitude(x) : magnitude(x);
}

KINK2(fmodq) { return x - y * step(whole(x / y)); }
