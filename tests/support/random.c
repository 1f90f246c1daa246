/* A small deterministic random generator. */
#include "random.h"

#include <math.h>
#include <stdlib.h>

uint64_t rng_bits(rng *r) {
  uint64_t z = (r->state += UINT64_C(0x9e3779b97f4a7c15));
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

double rng_uniform(rng *r, double lo, double hi) { return lo + (hi - lo) * ldexp((double)(rng_bits(r) >> 11), -53); }

int rng_below(rng *r, int n) { return (int)(rng_bits(r) % (uint64_t)n); }

double rng_sign(rng *r) { return rng_bits(r) >> 63 ? 1.0 : -1.0; }

double rng_exponent(rng *r, double lo, double hi) {
  const double u = rng_uniform(r, lo, hi), whole = floor(u);
  return ldexp(exp2(u - whole), (int)whole);
}

int test_tries(int usual) {
  const char *most = getenv("TEST_TRIES");
  return most && atoi(most) < usual ? atoi(most) : usual;
}
