/* Constrained models by hand, one for each difficulty. tests/data/constrained_motion.py holds the same functions for the reference. */
#ifndef TEST_CONSTRAINED_MODELS_H
#define TEST_CONSTRAINED_MODELS_H

#include "eom/model.h"

/* Parameters of a point mass with its constraints scaled, repeated or contradicted. */
typedef struct redundancy {
  int rows;
  tl_real factor[12]; /* of each row of phi = factor (x^2 + y^2 - 1) + bend t^2/2 */
  tl_real bend[12];
} redundancy;

extern const eom_model cartesian_pendulum;        /* one constraint */
extern const eom_model cartesian_double_pendulum; /* two constraints, drag */
extern const eom_model central_field;             /* m/2 |d(r u)/dt|^2 + mu m/r: M of rank 3 of 4, |u| = 1 */
extern const eom_model rotating_hoop;             /* explicit t */
extern const eom_model sleigh;                    /* nonholonomic, force with explicit t */
extern const eom_model appell;                    /* nonholonomic, nonlinear in velocity */
extern const eom_model quaternion_top;            /* M of rank 3 of 4 */
extern const eom_model mixed;                     /* holonomic and nonholonomic, configuration-dependent M, terms linear in velocity */
extern const eom_model relativistic;              /* L not quadratic in velocity */
extern const eom_model massless;                  /* a coordinate without mass that a constraint holds */
extern const eom_model redundant;                 /* params: redundancy; L = (x'^2 + y'^2) - 9.81 y */
extern const eom_model saddle;                    /* x^2 - 2 y^2 = 0 written twice, no force */
extern const eom_model floating;                  /* a coordinate without mass that nothing holds: no solution */

/* The models that need no parameters and have a solution, in the order of the reference data. */
extern const eom_model *const constrained_models[];
extern const int nconstrained_models;

#endif
