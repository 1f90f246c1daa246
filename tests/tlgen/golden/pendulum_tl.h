/* Model "pendulum" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#ifndef PENDULUM_TL_H
#define PENDULUM_TL_H

#include "eom/description.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model pendulum_model;
extern const eom_description pendulum_description;

#ifdef __cplusplus
}
#endif

#endif
