/* The equations of motion in the central field, derived by hand: what the jets must reproduce (eqs 67-71). */
#ifndef CENTRAL_FIELD_CLOSED_FORM_H
#define CENTRAL_FIELD_CLOSED_FORM_H

#include "central_field.h"

typedef enum kinetic { KINETIC_FULL, KINETIC_REDUCED } kinetic;

/* M qdd = Q + A' lambda, A qdd = b in q = (r, u1, u2, u3). */
typedef struct equations {
  double M[16]; /* 4 x 4, row-major */
  double Q[4];
  double A[4]; /* 1 x 4 */
  double b[1];
  double qdd[4];
} equations;

/* At q = (r, u), r > 0, u not zero, and qd = (rd, ud); both need not satisfy the constraint. */
equations closed_form(kinetic kind, const double *q, const double *qd, const struct central_field *p);

#endif
