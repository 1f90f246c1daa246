/* The planar N-pendulum in absolute angles as a jet model by hand. */
#ifndef TEST_PENDULUM_MODEL_H
#define TEST_PENDULUM_MODEL_H

#include "eom/model.h"

typedef struct pendulum {
  int n;
  tl_real g; /* m/s2; links of 1 m with 1 kg at their ends */
} pendulum;

extern const eom_model pendulum_model; /* params: struct pendulum */

#endif
