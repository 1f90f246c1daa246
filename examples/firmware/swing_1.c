/* One pole: the cart's acceleration a = k (E - E_up) cos(theta) theta' - (cart's position and speed) pumps it up, for
 * dE/dt = -m l cos(theta) theta' a/2 (Astrom and Furuta 2000); the push is the one that gives a, as qdd is affine in the push. */
#include "swing.h"

#include "taylor/sincos_number.h"

control_mode swing_choose(controller *c) {
  const tl_real up[D] = {0};
  return controller_within(c->y, up, TL_C(0.3)) ? CONTROL_HOLD : CONTROL_SWING;
}

int swing_push(controller *c, tl_real *push) {
  const tl_real up[D] = {0}, *y = c->y;
  tl_real energy, energy_up;
  int status = plant_pole_energy(&energy, &c->params, y);
  if (status == 0) status = plant_pole_energy(&energy_up, &c->params, up);
  if (status != 0) return status;
  const tl_real drive = TL_C(15.0) * (energy - energy_up) * y[N + 1] * tl_sincos_number(y[1]).cosine;
  const tl_real a = controller_clamp(drive, TL_C(6.0)) - TL_C(4.0) * y[0] - TL_C(2.0) * y[N];
  *push = c->params.push + (a - c->model.qdd[0]) / c->model.qdd_push[0];
  return 0;
}
