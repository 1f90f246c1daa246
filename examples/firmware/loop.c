/* The machine under its controller, by Kutta's method of the fourth order with the control period for a step. */
#include "loop.h"

/* y' of y = (q,qd). */
static int rhs(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  for (int i = 0; i < N; i++) ydot[i] = y[N + i];
  return PLANT(acceleration)(user, y, y + N, t, ydot + N, NULL);
}

void loop_init(loop *l, const tl_real *start, uint32_t seed) {
  l->params = plant_default();
  l->random = seed;
  eom_integrator_init(&l->integrator, &eom_rk4, rhs, &l->params, D, TL_C(0.0), start, CONTROL_PERIOD, l->work);
  controller_init(&l->control, &l->params, start);
}

const tl_real *loop_state(const loop *l) { return l->integrator.y; }

/* Marsaglia's xorshift of 32 bits: the same numbers everywhere. */
static uint32_t next_random(uint32_t *state) {
  *state ^= *state << 13;
  *state ^= *state >> 17;
  *state ^= *state << 5;
  return *state;
}

static tl_real sense(tl_real q, tl_real resolution, uint32_t *state) {
  const tl_real noise = (tl_real)(int32_t)(next_random(state) >> 16) / TL_C(32768.0) - TL_C(1.0);
  const tl_real counts = q / resolution + noise;
  return resolution * (tl_real)(int32_t)(counts + (counts < TL_C(0.0) ? TL_C(-0.5) : TL_C(0.5)));
}

void loop_sense(loop *l) {
  for (int i = 0; i < N; i++) l->measured[i] = sense(l->integrator.y[i], i == 0 ? SENSOR_CART : SENSOR_POLE, &l->random);
}

int loop_move(loop *l) {
  l->params.push = l->control.params.push;
  eom_integrator_restart(&l->integrator);
  return (int)eom_integrator_step(&l->integrator);
}
