/* The firmware's sine and cosine against the C library's in long double, in units of the last place: over the range that they are for,
 * near multiples of pi/2, and outside of it. */
#include "mathematics.h"

#include <stdint.h>
#include <stdio.h>

/* Half from the sum of the polynomial, the rest from r, which is rounded twice. */
static const long double most[4] = {2.5L, 2.5L, 1.6L, 1.6L};

static long double ulps(long double x, long double exact, int digits) {
  int e;
  frexpl(exact, &e);
  return fabsl(x - exact) / ldexpl(1.0L, e - digits);
}

static long double worst[4];

static void look(int which, long double x, long double exact, int digits) {
  worst[which] = fmaxl(worst[which], ulps(x, exact, digits));
}

static void at(double x) {
  const float single = (float)x;
  look(0, (long double)sinf(single), sinl((long double)single), 24);
  look(1, (long double)cosf(single), cosl((long double)single), 24);
  look(2, (long double)sin(x), sinl((long double)x), 53);
  look(3, (long double)cos(x), cosl((long double)x), 53);
}

int main(void) {
  uint64_t random = 1;
  for (int i = 0; i < 300000; i++) {
    random = random * 6364136223846793005ULL + 1442695040888963407ULL;
    const double x = (double)(random >> 11) * 0x1p-52 - 1.0;
    at(8.0 * x);
    at((double)MATHEMATICS_LIMIT * x);
    at((double)(i % 5000) * 0x1.921fb54442d18p0 + x * 0x1p-20);
  }
  const char *const names[4] = {"sinf", "cosf", "sin", "cos"};
  int wrong = 0;
  for (int i = 0; i < 4; i++) {
    printf("%s: wrong by %.3Lg ulp at most\n", names[i], worst[i]);
    wrong |= !(worst[i] <= most[i]);
  }
  const float far = 2.0f * (float)MATHEMATICS_LIMIT;
  wrong |= !isnan(sinf(far)) || !isnan(cosf(-far)) || !isnan(sin((double)far)) || !isnan(cos((double)NAN)) || !isnan(sinf(INFINITY));
  return wrong;
}
