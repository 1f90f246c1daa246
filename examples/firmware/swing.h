/* How the poles come up: swing_1.c for one, swing_2.c for two. */
#ifndef SWING_H
#define SWING_H

#include "controller.h"

/* What to do in this control step, where the poles are not held by the last one. */
control_mode swing_choose(controller *c);

/* The push for c->mode other than CONTROL_HOLD, from c->model, c->A and c->B. Returns 0, or a status as controller_step. */
int swing_push(controller *c, tl_real *push);

#endif
