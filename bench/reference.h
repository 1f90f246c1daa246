/* The numbers that every contender is checked against: one block of doubles per (model, n), written by reference.c, read by the timer.
 */
#ifndef BENCH_REFERENCE_H
#define BENCH_REFERENCE_H

#include "contender.h"

#include <stddef.h>

/* One state and what belongs to it; every member is an array inside one block. */
typedef struct bench_state {
  double *q, *qd; /* n each */
  double *w;      /* 2n: a direction (dq, dqd) */
  double *qdd;    /* n */
  double *qdd_y;  /* n x 2n, row-major */
  double *dqdd;   /* n: qdd_y w */
} bench_state;

/* Doubles of a block: gravity, mass, length, then the states. */
static inline size_t bench_block_size(int n) {
  size_t m = (size_t)n;
  return 1 + 2 * m + BENCH_STATES * (6 * m + 2 * m * m);
}

/* State number k of a block. */
static inline bench_state bench_block_state(double *block, int n, int k) {
  size_t m = (size_t)n;
  double *q = block + 1 + 2 * m + (size_t)k * (6 * m + 2 * m * m);
  bench_state s = {q, q + m, q + 2 * m, q + 4 * m, q + 6 * m, q + 5 * m};
  return s;
}

#endif
