/* The parameter structs of examples/models, filled for a case of the benchmark. */
#ifndef BENCH_PARAMETERS_H
#define BENCH_PARAMETERS_H

#include "cartesian_pendulum.h"
#include "contender.h"
#include "pendulum.h"
#include "relative_chain.h"

#include <string.h>

static inline struct pendulum pendulum_parameters(const bench_case *problem) {
  struct pendulum p = {.n = problem->n, .g = problem->gravity};
  memcpy(p.mass, problem->mass, (size_t)problem->n * sizeof *p.mass);
  memcpy(p.length, problem->length, (size_t)problem->n * sizeof *p.length);
  return p;
}

static inline struct relative_chain relative_chain_parameters(const bench_case *problem) {
  return (struct relative_chain){.n = problem->n, .gravity = problem->gravity};
}

static inline struct cartesian_pendulum cartesian_pendulum_parameters(const bench_case *problem) {
  struct cartesian_pendulum p = {.links = problem->n, .coordinates = 2 * problem->n, .g = problem->gravity};
  memcpy(p.mass, problem->mass, (size_t)problem->n * sizeof *p.mass);
  memcpy(p.length, problem->length, (size_t)problem->n * sizeof *p.length);
  return p;
}

#endif
