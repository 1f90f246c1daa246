/* A model's functions as plain C, by number: the Lagrangian, the force, then the constraints. q, qd: n numbers each; out: the rows. */
#ifndef TEST_PLAIN_H
#define TEST_PLAIN_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "eom/model.h"

void plain_call(int function, double *out, double *q, double *qd, double t);
void quad_call(int function, __float128 *out, __float128 *q, __float128 *qd, __float128 t);

/* The model that tlgen printed, and the parameters that both sides use. */
const eom_model *plain_model(void);
const void *plain_params(void);

/* The relative errors that rounding may leave.
 *   value       a jet's value goes through the same operations as the plain C, in another grouping
 *   derivative  relative to the largest derivative of that order or below, after some tens of operations; the reference is good for
 *               1e-15 at least */
typedef struct plain_errors { double value, derivative; } plain_errors;
extern const plain_errors plain_limits;

#endif
