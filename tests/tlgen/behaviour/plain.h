/* A model's functions as plain C, by number: the Lagrangian, the force, then the constraints. q, qd: n numbers each; out: the rows. */
#ifndef TEST_PLAIN_H
#define TEST_PLAIN_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "eom/model.h"

void plain_call(int function, double *out, double *q, double *qd, double t);
void quad_call(int function, __float128 *out, __float128 *q, __float128 *qd, __float128 t);

/* The model that tlgen printed, and the parameters that both sides use. */
const eom_model *plain_model(void);
const void *plain_params(void);

#endif
