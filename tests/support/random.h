/* A small deterministic random generator (splitmix64): the same numbers on every machine. How many of them a test takes. */
#ifndef TEST_RANDOM_H
#define TEST_RANDOM_H

#include <stdint.h>

typedef struct rng {
  uint64_t state; /* any start value */
} rng;

uint64_t rng_bits(rng *r);

/* Uniform in [lo, hi). */
double rng_uniform(rng *r, double lo, double hi);

/* Uniform in 0..n-1. */
int rng_below(rng *r, int n);

/* +1 or -1. */
double rng_sign(rng *r);

/* 2^u with u uniform in [lo, hi): uniform in the exponent. */
double rng_exponent(rng *r, double lo, double hi);

/* How much a test tries, points or seconds of motion: usual, or at most the number in the environment's TEST_TRIES, which is for
 * valgrind: it is fifty times slower, and sees the same code at each point. */
int test_tries(int usual);

#endif
