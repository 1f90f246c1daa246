/* The computed equations beside the closed form: at one state as numbers, at many as the largest relative error. */
#ifndef CENTRAL_FIELD_AGREEMENT_H
#define CENTRAL_FIELD_AGREEMENT_H

#include <eom/eom.h>

#include "closed_form.h"

/* The generated model of that kinetic energy. */
const eom_model *model_of(kinetic kind);

/* Prints M, Q, A, b and the acceleration at one state of the manifold, computed and by hand. Returns 0, or -1 after a message. */
int print_agreement(kinetic kind);

/* Compares at the given number of random states, half of them off the manifold, with random parameters, for W chosen by the library and
 * for W = 1e-8, 1e-6, .., 1e8. Prints the largest relative error of each of M, Q, A, b, qdd: the largest difference of two entries over
 * the largest entry. Returns 0 where all are at most agreement_bound, or -1 after a message. */
int print_errors(kinetic kind, int states);

/* 1e-13: 500 times the rounding of one operation, for some fifty operations and the condition of the orbit plane. */
extern const double agreement_bound;

#endif
