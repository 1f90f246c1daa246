/* The machine: a cart with one pole or, with -DPLANT_POLES=2, a chain of two, in the functions that tlgen has printed of it. */
#ifndef PLANT_H
#define PLANT_H

#ifndef PLANT_POLES
#define PLANT_POLES 1
#endif

#if PLANT_POLES == 1
#include "cart_pole_tl.h"
#define PLANT(function) cart_pole_##function
typedef cart_pole plant_params;
#else
#include "double_cart_pole_tl.h"
#define PLANT(function) double_cart_pole_##function
typedef struct double_cart_pole plant_params;
#endif

enum { N = PLANT_POLES + 1, D = 2 * N }; /* coordinates: cart, m, poles' angles from the upward vertical, rad; numbers of a state */

/* The linear model qdd + qdd_y dy + qdd_push dpush at one state y = (q,qd) and push, all exact derivatives of the Lagrangian. */
typedef struct plant_model {
  tl_real qdd[N];       /* m/s^2, rad/s^2 */
  tl_real qdd_y[N * D]; /* d qdd/d y */
  tl_real qdd_push[N];  /* d qdd/d push */
} plant_model;

/* The machine that this program has. */
plant_params plant_default(void);

/* *model at (y, params->push). Returns 0, or the status of the model's functions (eom/motion.h). */
int plant_linearise(plant_model *model, const plant_params *params, const tl_real *y);

/* The energy of the poles alone, J: that of the machine with its cart at rest. Status as above. */
int plant_pole_energy(tl_real *energy, const plant_params *params, const tl_real *y);

#endif
