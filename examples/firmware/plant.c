/* The machine's parameters, linear model and energy, from the functions that tlgen has printed. */
#include "plant.h"

#include "matrix.h"

plant_params plant_default(void) {
  return (plant_params){
      .cart_mass = TL_C(1.0),
#if PLANT_POLES == 1
      .pole_mass = TL_C(0.2),
      .pole_length = TL_C(0.6),
      .hinge_drag = TL_C(0.001),
#else
      .pole_mass = {TL_C(0.2), TL_C(0.2)},
      .pole_length = {TL_C(0.6), TL_C(0.6)},
      .hinge_drag = {TL_C(0.001), TL_C(0.001)},
#endif
      .gravity = TL_C(9.81),
      .push = TL_C(0.0),
      .cart_drag = TL_C(0.1),
  };
}

int plant_linearise(plant_model *model, const plant_params *params, const tl_real *y) {
  tl_real M[N * N], Q[N];
  const eom_parts parts = {.M = M, .Q = Q};
  int status = PLANT(simulate)(params, y, y + N, TL_C(0.0), &parts, NULL); /* first: it tells what is no number from what is singular */
  if (status == 0) status = PLANT(jacobian)(params, y, y + N, TL_C(0.0), model->qdd, model->qdd_y, NULL);
  if (status == 0) status = PLANT(parameters)(params, y, y + N, TL_C(0.0), model->qdd, NULL, model->qdd_push, NULL, NULL);
  if (status != 0) return status;
  for (int i = 0; i < N; i++) model->qdd_push[i] = -model->qdd_push[i]; /* r = M qdd - Q = 0: M dqdd = -dr/dpush dpush */
  return matrix_solve(N, 1, M, model->qdd_push) ? 0 : EOM_MOTION_PIVOT;
}

int plant_pole_energy(tl_real *energy, const plant_params *params, const tl_real *y) {
  tl_real qd[N], momentum[N], rate[N], lagrangian;
  for (int i = 0; i < N; i++) qd[i] = y[N + i];
  qd[0] = TL_C(0.0);
  return PLANT(energy)(params, y, qd, TL_C(0.0), momentum, rate, &lagrangian, energy, NULL);
}
