/* What each contender of bench/algebra offers: operations on jets that are given, in a shape. */
#ifndef BENCH_ALGEBRA_CONTENDER_H
#define BENCH_ALGEBRA_CONTENDER_H

#include "taylor/shape.h"

#ifdef __cplusplus
extern "C" {
#endif

/* pow is that with the constant exponent ALGEBRA_EXPONENT; sincos has two results. */
enum { ALGEBRA_MUL, ALGEBRA_DIV, ALGEBRA_SQRT, ALGEBRA_EXP, ALGEBRA_SINCOS, ALGEBRA_POW, ALGEBRA_OPERATIONS };
#define ALGEBRA_EXPONENT 2.5

typedef struct algebra_task {
  const tl_shape *shape;
  const int *exponents; /* ncoef x (nvar+1): the power of s in each monomial, then those of the variables */
  int operation;
  const double *a, *b; /* the operands, shape->ncoef numbers each; b for mul and div only */
} algebra_task;

typedef struct algebra_contender {
  const char *name;
  /* Makes ready to run this task again and again; 0 where it can. The task lives until the next one. */
  int (*prepare)(const algebra_task *task);
  void (*run)(void);
  /* The largest difference between what run has computed and c (ncoef numbers, or twice as many), relative to the largest number. */
  double (*difference)(const double *c);
} algebra_contender;

/* Exported by the shared objects of rivals: fills *contender; argument is what the command line has behind '='. 0 where all is there.
 */
typedef int algebra_open_function(const char *argument, algebra_contender *contender);
int algebra_open(const char *argument, algebra_contender *contender);

#ifdef __cplusplus
}
#endif

#endif
