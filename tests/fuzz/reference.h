/* The equations of motion of a model from its C in quad precision, by differences: shares no code with jets and adjoints. */
#ifndef FUZZ_REFERENCE_H
#define FUZZ_REFERENCE_H

#include "numbers.h"

#include "tlgen/selftest.h"

#include <stdbool.h>

/* What a model is evaluated with. */
typedef struct fuzz_model {
  const tlgen_selftest *test;
  const void *params; /* double */
  void *quad_params;
  const int *parameters; /* np places of numbers in test->params->members, counted through all of them */
  fuzz_sizes sizes;
} fuzz_model;

typedef enum fuzz_smoothness {
  FUZZ_SMOOTH,   /* the numbers hold */
  FUZZ_ROUGH,    /* some evaluation took another path than the centre */
  FUZZ_TOO_LARGE /* a number is not finite, or so large or steep that errors are all there is, or a loop does not end */
} fuzz_smoothness;

/* Fills all groups of numbers, and scale: what the errors of a group are relative to, the largest number of the group or of those that
 * it is a sum of. Fills p->qdd and p->lambda: the solved ones where the mass matrix is safely positive definite and the equations are
 * well-conditioned; else p->trial and what p->lambda holds, and the solved groups are made absent. */
fuzz_smoothness reference_evaluate(const fuzz_model *m, const fuzz_point *p, fuzz_numbers *numbers, double scale[FUZZ_GROUP_COUNT]);

/* Takes most of the truncation error out of numbers of reference_evaluate, at other p->qdd and p->lambda where these are solved. Not
 * smooth: numbers say nothing; FUZZ_TOO_LARGE also where what is left may exceed the tolerance, relative to the scale. */
fuzz_smoothness reference_refine(const fuzz_model *m, const fuzz_point *p, double tolerance, fuzz_numbers *numbers,
                                 double scale[FUZZ_GROUP_COUNT]);

/* How far the numbers of each group move, relative to the scale, with a state that is as far off as the roundings of a program take it.
 * Any way in double may be wrong by that. Not smooth: moves says nothing. */
fuzz_smoothness reference_moves(const fuzz_model *m, const fuzz_point *p, const double scale[FUZZ_GROUP_COUNT],
                                double moves[FUZZ_GROUP_COUNT]);

#endif
