/* A small deterministic random generator (splitmix64): the same numbers on every machine. */
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

#endif
