/* One control step: correct the estimate, linearise there, choose the push, predict. */
#include "controller.h"

#include "matrix.h"

#include <taylor/config.h>
#include TL_MATH_HEADER

static const tl_real PI = TL_C(3.14159265358979323846);

/* Covariances: of a measurement, and what a period adds to the square of a velocity. */
#define NOISE_OF(resolution) ((resolution) * (resolution) / TL_C(2.0))
#define DRIFT TL_C(1e-6)

void controller_init(controller *c, const plant_params *params, const tl_real *y) {
  *c = (controller){.params = *params, .mode = CONTROL_SWING};
  for (int i = 0; i < D; i++) {
    c->y[i] = y[i];
    c->P[D * i + i] = TL_C(1e-2);
  }
}

/* Each measured coordinate by itself: K = P e_i/(P_ii + r), y += K (z - y_i), P -= K e_i' P. */
static void correct(controller *c, const tl_real *measured) {
  for (int i = 0; i < N; i++) {
    const tl_real below = c->P[D * i + i] + NOISE_OF(i == 0 ? SENSOR_CART : SENSOR_POLE), miss = measured[i] - c->y[i];
    tl_real column[D];
    for (int a = 0; a < D; a++) column[a] = c->P[D * i + a];
    for (int a = 0; a < D; a++) {
      const tl_real gain = column[a] / below;
      c->y[a] += gain * miss;
      for (int b = a; b < D; b++) c->P[D * b + a] = c->P[D * a + b] -= gain * column[b];
    }
  }
}

/* A = I + hF + (hF)^2/2 and B = (h + h^2 F/2) (0, qdd_push) with F = [0 I; qdd_y]: what a period leaves out is of order h^3. */
static void discretise(controller *c) {
  const tl_real h = CONTROL_PERIOD;
  tl_real *F = c->work.W, *F2 = c->work.V1;
  for (int i = 0; i < N; i++)
    for (int j = 0; j < D; j++) {
      F[D * i + j] = j == N + i ? h : TL_C(0.0);
      F[D * (N + i) + j] = h * c->model.qdd_y[D * i + j];
    }
  matrix_multiply(D, F2, F, F);
  for (int i = 0; i < D; i++) {
    tl_real FB = TL_C(0.0);
    for (int j = 0; j < N; j++) FB += F[D * i + N + j] * c->model.qdd_push[j];
    c->B[i] = h * (FB / 2 + (i < N ? TL_C(0.0) : c->model.qdd_push[i % N]));
    for (int j = 0; j < D; j++) c->A[D * i + j] = F[D * i + j] + F2[D * i + j] / 2 + (i == j ? TL_C(1.0) : TL_C(0.0));
  }
}

/* y - (0, .., 0), angles between -pi and pi. */
static void away(tl_real *e, const tl_real *y) {
  for (int i = 0; i < D; i++) e[i] = i >= 1 && i < N ? TL_LIBM(remainder)(y[i], 2 * PI) : y[i];
}

static tl_real clamp(tl_real x, tl_real most) { return x > most ? most : x < -most ? -most : x; }

/* The cart's acceleration a = k (E - E_up) cos(theta) theta' - (cart's position and speed): dE/dt = -m l cos(theta) theta' a/2 (Astrom
 * and Furuta 2000); the push that gives it, as qdd is affine in the push. */
static int swing(controller *c, const tl_real *e, tl_real *push) {
  const tl_real up[D] = {0};
  tl_real energy, energy_up;
  int status = plant_pole_energy(&energy, &c->params, c->y);
  if (status == 0) status = plant_pole_energy(&energy_up, &c->params, up);
  if (status != 0) return status;
  const tl_real drive = TL_C(15.0) * (energy - energy_up) * e[N + 1] * TL_LIBM(cos)(e[1]);
  const tl_real a = clamp(drive, TL_C(6.0)) - TL_C(4.0) * e[0] - TL_C(2.0) * e[N];
  *push = c->params.push + (a - c->model.qdd[0]) / c->model.qdd_push[0];
  return 0;
}

static int hold(controller *c, const tl_real *e, tl_real *push) {
  tl_real weights[D];
  for (int i = 0; i < D; i++) weights[i] = CONTROL_PERIOD * (i == 0 ? TL_C(10.0) : i < N ? TL_C(100.0) : TL_C(1.0));
  if (!riccati_gain(c->K, c->A, c->B, weights, CONTROL_PERIOD * TL_C(0.1), &c->work)) return EOM_MOTION_PIVOT;
  *push = TL_C(0.0);
  for (int i = 0; i < D; i++) *push -= c->K[i] * e[i];
  return 0;
}

/* Held from a cone around the upright position on, and until it has left a wider one. */
static control_mode choose(control_mode mode, const tl_real *e) {
  const tl_real cone = mode == CONTROL_HOLD ? TL_C(0.8) : TL_C(0.3);
  for (int i = 1; i < N; i++)
    if (!(e[i] < cone && e[i] > -cone)) return CONTROL_SWING;
  return CONTROL_HOLD;
}

/* y += h f + h^2 F f/2 with f = (qd, qdd), and P <- A P A' + drift. */
static void predict(controller *c) {
  const tl_real h = CONTROL_PERIOD;
  tl_real f[D];
  for (int i = 0; i < N; i++) {
    f[i] = c->y[N + i];
    f[N + i] = c->model.qdd[i];
  }
  for (int i = 0; i < N; i++) {
    tl_real Ff = TL_C(0.0);
    for (int j = 0; j < D; j++) Ff += c->model.qdd_y[D * i + j] * f[j];
    c->y[i] += h * (f[i] + h / 2 * f[N + i]);
    c->y[N + i] += h * (f[N + i] + h / 2 * Ff);
  }
  matrix_multiply(D, c->work.V1, c->A, c->P);
  for (int i = 0; i < D * D; i++) c->P[i] = TL_C(0.0);
  for (int i = N; i < D; i++) c->P[D * i + i] = DRIFT;
  matrix_add_symmetric(D, c->P, c->work.V1, c->A);
}

int controller_step(controller *c, const tl_real *measured) {
  tl_real e[D], push = TL_C(0.0);
  correct(c, measured);
  int status = plant_linearise(&c->model, &c->params, c->y);
  if (status == 0) {
    discretise(c);
    away(e, c->y);
    c->mode = choose(c->mode, e);
    status = c->mode == CONTROL_HOLD ? hold(c, e, &push) : swing(c, e, &push);
  }
  if (status != 0) push = TL_C(0.0);
  push = clamp(push, CONTROL_MOST_PUSH);
  if (status == 0) {
    for (int i = 0; i < N; i++) c->model.qdd[i] += c->model.qdd_push[i] * (push - c->params.push);
    predict(c);
  }
  c->params.push = push;
  return status;
}
