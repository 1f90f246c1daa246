/* A model with its constraint rows written otherwise: repeated, scaled, in another order. The motion is the same. */
#ifndef TEST_REARRANGED_H
#define TEST_REARRANGED_H

#include "eom/model.h"

enum { REARRANGED_MOST = 16 };

/* Parameters of rearranged_model. */
typedef struct rearranged {
  const eom_model *model; /* with one holonomic function and no others */
  const void *params;     /* of the model */
  int rows;
  int from[REARRANGED_MOST]; /* row i is row from[i] of the model's */
  double scale[REARRANGED_MOST];
} rearranged;

/* The model of r, which must outlive it; it has calls only. */
eom_model rearranged_model(const rearranged *r, eom_function *constraint);

#endif
