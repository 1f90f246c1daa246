/* One control step: correct the estimate, linearise there, choose the push, predict. */
#include "controller.h"

#include "matrix.h"
#include "swing.h"

#include <taylor/finite.h>

static const tl_real PI = TL_C(3.14159265358979323846);

/* Covariances: of a measurement, and what a period adds to the square of a velocity. */
#define NOISE_OF(resolution) ((resolution) * (resolution) / TL_C(2.0))
#define DRIFT TL_C(1e-6)

void controller_init(controller *c, const plant_params *params, const tl_real *y) {
  *c = (controller){.params = *params, .mode = CONTROL_REST};
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

void controller_away(tl_real *e, const tl_real *y, const tl_real *from) {
  for (int i = 0; i < D; i++) e[i] = i >= 1 && i < N ? TL_LIBM(remainder)(y[i] - from[i], 2 * PI) : y[i] - from[i];
}

int controller_within(const tl_real *y, const tl_real *from, tl_real angle) {
  tl_real e[D];
  controller_away(e, y, from);
  for (int i = 1; i < N; i++)
    if (!(matrix_size(e[i]) < angle)) return 0;
  return 1;
}

/* push = -K (y - to). */
static tl_real feedback(const controller *c, const tl_real *to) {
  tl_real e[D];
  controller_away(e, c->y, to);
  return -matrix_dot(D, c->K, e, 1);
}

int controller_regulate(controller *c, const tl_real *to, tl_real *push) {
  tl_real weights[D];
  for (int i = 0; i < D; i++) weights[i] = CONTROL_WEIGHT(i);
  if (!riccati_gain(c->K, c->A, c->B, weights, CONTROL_WEIGHT_PUSH, &c->work)) return EOM_MOTION_PIVOT;
  *push = feedback(c, to);
  return 0;
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

static void keep(controller *c) {
  for (int i = 0; i < D; i++) c->work.V1[i] = c->y[i];
  for (int i = 0; i < D * D; i++) c->work.V2[i] = c->P[i];
}

static void take_back(controller *c) {
  for (int i = 0; i < D; i++) c->y[i] = c->work.V1[i];
  for (int i = 0; i < D * D; i++) c->P[i] = c->work.V2[i];
}

/* Held from a cone around the upright position on, and until it has left a wider one. */
static int drive(controller *c, tl_real *push) {
  const tl_real up[D] = {0};
  discretise(c);
  if (c->mode != CONTROL_HOLD || !controller_within(c->y, up, TL_C(0.8))) c->mode = swing_choose(c);
  return c->mode == CONTROL_HOLD ? controller_regulate(c, up, push) : swing_push(c, push);
}

/* A step that has no model: sensors correct the estimate, as far as it stays finite, by the covariance of the last step that had one.
 */
static void coast(controller *c, const tl_real *measured) {
  correct(c, measured);
  if (!tl_finite_array(D, c->y)) take_back(c);
  for (int i = 0; i < D * D; i++) c->P[i] = c->work.V2[i];
  for (int i = 0; i < N; i++) c->y[i] += CONTROL_PERIOD * c->y[N + i];
}

int controller_step(controller *c, const tl_real *measured) {
  const tl_real up[D] = {0};
  const control_mode before = c->mode;
  tl_real push = TL_C(0.0);
  keep(c);
  correct(c, measured);
  const int told = plant_linearise(&c->model, &c->params, c->y);
  int status = told;
  if (told != 0) {
    take_back(c);
    status = plant_linearise(&c->model, &c->params, c->y);
  }
  const int modelled = status == 0;
  if (modelled) status = drive(c, &push);
  if (status != 0) push = before == CONTROL_HOLD && c->mode == CONTROL_HOLD ? feedback(c, up) : TL_C(0.0);
  push = controller_clamp(push, CONTROL_MOST_PUSH);
  if (modelled) {
    for (int i = 0; i < N; i++) c->model.qdd[i] += c->model.qdd_push[i] * (push - c->params.push);
    predict(c);
  } else
    coast(c, measured);
  c->params.push = push;
  return told != 0 ? told : status;
}
