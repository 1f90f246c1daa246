/* Model "pendulum_rows" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#include "pendulum_rows_tl.h"

#include "taylor/taylor.h"

#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/sincos_array.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* a loop that is not worth a vector */
#endif

struct pendulum {
  int n;
  tl_real g;
  tl_real mass[64];
  tl_real length[64];
};

/* pendulum_lagrangian, pendulum.c:6. */
static void pendulum_lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd, const tl_real *t, const struct pendulum *p)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 10);
  if (!frame) return;
  tl_real *const tmp0 = frame + 7*nc;
  tl_real *const tmp1 = frame + 8*nc;
  tl_real *const tmp2 = frame + 9*nc;
  /* pendulum.c:7: double vx = 0.0, vy = 0.0; */
  cx->line = 7;
  tl_real *const vx = frame;
  tl_const(cx, vx, TL_C(0.0));
  tl_real *const vy = frame + nc;
  tl_const(cx, vy, TL_C(0.0));
  /* pendulum.c:8: double height = 0.0; */
  cx->line = 8;
  tl_real *const height = frame + 2*nc;
  tl_const(cx, height, TL_C(0.0));
  /* pendulum.c:9: double T = 0.0, V = 0.0; */
  cx->line = 9;
  tl_real *const T = frame + 3*nc;
  tl_const(cx, T, TL_C(0.0));
  tl_real *const V = frame + 4*nc;
  tl_const(cx, V, TL_C(0.0));
  (void)t[0];
  for (int k = 0; k < p->n; k++) {
    /* pendulum.c:13: double s = sin(q[k]), c = cos(q[k]); */
    cx->line = 13;
    tl_real *const s = frame + 5*nc;
    tl_real *const c = frame + 6*nc;
    tl_sincos(cx, s, c, q + k*nc);
    /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
    cx->line = 15;
    tl_scale(cx, tmp0, c, p->length[k]);
    tl_muladd(cx, vx, tmp0, qd + k*nc);
    /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
    cx->line = 16;
    tl_scale(cx, tmp0, s, p->length[k]);
    tl_muladd(cx, vy, tmp0, qd + k*nc);
    /* pendulum.c:17: height -= p->length[k] * c; */
    cx->line = 17;
    tl_axpy(cx, height, -p->length[k], c);
    /* pendulum.c:18: T += 0.5 * p->mass[k] * (vx * vx + vy * vy); */
    cx->line = 18;
    tl_mul(cx, tmp1, vx, vx);
    tl_mul(cx, tmp2, vy, vy);
    tl_add(cx, tmp0, tmp1, tmp2);
    tl_axpy(cx, T, TL_C(0.5) * p->mass[k], tmp0);
    /* pendulum.c:19: V += p->mass[k] * p->g * height; */
    cx->line = 19;
    tl_axpy(cx, V, p->mass[k] * p->g, height);
  }
  /* pendulum.c:21: return T - V; */
  cx->line = 21;
  tl_sub(cx, result, T, V);
  tl_pop(cx, 10);
}

static void pendulum_rows_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  pendulum_lagrangian_tl(cx, out, q, qd, t, params);
}

/* Whether the parameters have the sizes that the functions below are for. */
static int pendulum_rows_fits(const void *params)
{
  const struct pendulum *const p = params;
  return p->n == 6;
}

int pendulum_rows_simulate(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const eom_parts *out, tl_real *restrict work)
{
  (void)t;
  const struct pendulum *const p = params;
  if (!pendulum_rows_fits(params)) return EOM_MOTION_SIZE;
  tl_real *const restrict M_rows = work + 0;
  tl_real sums[6];
  tl_real tape[6];
  tl_real tape2[6];
  TL_ALIGNED tl_real row[8] = {0};
  TL_ALIGNED tl_real row2[8] = {0};
  tl_real *const restrict M = out->M;
  tl_real *const restrict Q = out->Q;
  tl_real c1 = TL_C(0.0);
  for (long i2 = 5; i2 >= 0; --i2) {
    /* pendulum.c:18: T += 0.5 * p->mass[k] * (vx * vx + vy * vy); */
    const tl_real t1 = p->mass[i2] + c1;
    sums[i2] = t1;
    c1 = t1;
  }
  tl_real sines[6], cosines[6];
  tl_sincos_array(6, q, sines, cosines);
  for (long i2 = 0; i2 < 6; ++i2) {
    /* pendulum.c:18 */
    const tl_real t2 = sums[i2];
    const tl_real t3 = p->length[i2] * cosines[i2] * t2;
    const tl_real t4 = p->length[i2] * sines[i2] * t2;
    row[i2] = t3;
    row2[i2] = t4;
  }
  tl_real c2 = TL_C(0.0);
  tl_real c3 = TL_C(0.0);
  for (long i2 = 0; i2 < 6; ++i2) {
    /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
    const tl_real t5 = c2 - p->length[i2] * sines[i2] * qd[i2] * qd[i2];
    tape[i2] = t5;
    /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
    const tl_real t6 = c3 + p->length[i2] * cosines[i2] * qd[i2] * qd[i2];
    tape2[i2] = t6;
    c2 = t5;
    c3 = t6;
  }
  tl_real c4 = TL_C(0.0);
  tl_real c5 = TL_C(0.0);
  tl_real c6 = TL_C(0.0);
  for (long i2 = 5; i2 >= 0; --i2) {
    /* pendulum.c:15 */
    const tl_real t7 = p->length[i2] * cosines[i2];
    /* pendulum.c:16 */
    const tl_real t8 = p->length[i2] * sines[i2];
    for (long b = (i2) / TL_ROW_PAD * TL_ROW_PAD; b < 6; b += TL_ROW_PAD)
      TL_INDEPENDENT
      for (long c = b; c < b + TL_ROW_PAD; ++c) {
        (M_rows + (i2) * 8)[c] = t7 * row[c] + t8 * row2[c];
      }
    /* pendulum.c:18 */
    const tl_real t9 = c5 + p->mass[i2] * tape2[i2];
    const tl_real t10 = c4 + p->mass[i2] * tape[i2];
    /* pendulum.c:19: V += p->mass[k] * p->g * height; */
    const tl_real t11 = p->g * p->mass[i2];
    Q[i2] = -(t8 * t9 + (t7 * t10 + t8 * (t11 - c6)));
    c4 = t10;
    c5 = t9;
    c6 -= t11;
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) M[i*6 + j] = M_rows[i*8 + j];
  for (int i = 1; i < 6; ++i)
    for (int j = 0; j < i; ++j) M[i*6 + j] = M[j*6 + i];
  if (!tl_finite_array(36, M)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(6, Q)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_rows_acceleration(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict work)
{
  (void)t;
  const struct pendulum *const p = params;
  if (!pendulum_rows_fits(params)) return EOM_MOTION_SIZE;
  tl_real *const restrict M = work + 0;
  tl_real *const restrict Q = work + 48;
  tl_real *const restrict qdd = work + 56;
  tl_real *const restrict dinv = work + 64;
  tl_real sums[6];
  tl_real tape[6];
  tl_real tape2[6];
  TL_ALIGNED tl_real row[8] = {0};
  TL_ALIGNED tl_real row2[8] = {0};
  tl_real c1 = TL_C(0.0);
  for (long i2 = 5; i2 >= 0; --i2) {
    /* pendulum.c:18: T += 0.5 * p->mass[k] * (vx * vx + vy * vy); */
    const tl_real t1 = p->mass[i2] + c1;
    sums[i2] = t1;
    c1 = t1;
  }
  tl_real sines[6], cosines[6];
  tl_sincos_array(6, q, sines, cosines);
  for (long i2 = 0; i2 < 6; ++i2) {
    /* pendulum.c:18 */
    const tl_real t2 = sums[i2];
    const tl_real t3 = p->length[i2] * cosines[i2] * t2;
    const tl_real t4 = p->length[i2] * sines[i2] * t2;
    row[i2] = t3;
    row2[i2] = t4;
  }
  tl_real c2 = TL_C(0.0);
  tl_real c3 = TL_C(0.0);
  for (long i2 = 0; i2 < 6; ++i2) {
    /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
    const tl_real t5 = c2 - p->length[i2] * sines[i2] * qd[i2] * qd[i2];
    tape[i2] = t5;
    /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
    const tl_real t6 = c3 + p->length[i2] * cosines[i2] * qd[i2] * qd[i2];
    tape2[i2] = t6;
    c2 = t5;
    c3 = t6;
  }
  tl_real c4 = TL_C(0.0);
  tl_real c5 = TL_C(0.0);
  tl_real c6 = TL_C(0.0);
  for (long i2 = 5; i2 >= 0; --i2) {
    /* pendulum.c:15 */
    const tl_real t7 = p->length[i2] * cosines[i2];
    /* pendulum.c:16 */
    const tl_real t8 = p->length[i2] * sines[i2];
    for (long b = (i2) / TL_ROW_PAD * TL_ROW_PAD; b < 6; b += TL_ROW_PAD)
      TL_INDEPENDENT
      for (long c = b; c < b + TL_ROW_PAD; ++c) {
        (M + (i2) * 8)[c] = t7 * row[c] + t8 * row2[c];
      }
    /* pendulum.c:18 */
    const tl_real t9 = c5 + p->mass[i2] * tape2[i2];
    const tl_real t10 = c4 + p->mass[i2] * tape[i2];
    /* pendulum.c:19: V += p->mass[k] * p->g * height; */
    const tl_real t11 = p->g * p->mass[i2];
    Q[i2] = -(t8 * t9 + (t7 * t10 + t8 * (t11 - c6)));
    c4 = t10;
    c5 = t9;
    c6 -= t11;
  }
  const tl_real pivot = tl_ldl_factor_solve(6, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 6; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(6) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  if (!tl_finite_array(6, qdd)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

const eom_motion pendulum_rows_motion = {
  .n = 6,
  .m1 = 0,
  .m2 = 0,
  .fits = pendulum_rows_fits,
  .work = 80,
  .autonomous = 1,
  .simulate = pendulum_rows_simulate,
  .acceleration = pendulum_rows_acceleration,
};

static const eom_motion *const pendulum_rows_motions[] = {&pendulum_rows_motion};

static int pendulum_rows_dof(const void *params)
{
  return (int)((const struct pendulum *)params)->n;
}

static size_t pendulum_rows_lagrangian_frame(const void *params)
{
  (void)params;
  return 10;
}

static int pendulum_rows_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model pendulum_rows_model = {
  .name = "pendulum_rows",
  .dof = pendulum_rows_dof,
  .params_size = sizeof(struct pendulum),
  .lagrangian = {"pendulum_lagrangian", "pendulum.c:6", pendulum_rows_lagrangian_jet, pendulum_rows_lagrangian_rows, pendulum_rows_lagrangian_frame},
  .force = {0},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
  .motion = pendulum_rows_motions,
  .nmotion = 1,
};

static const eom_parameter pendulum_rows_member[] = {
  EOM_MEMBER_UP_TO(struct pendulum, n, 64, INTEGER, "number of links, 1..PENDULUM_MAX_LINKS"),
  EOM_MEMBER(struct pendulum, g, REAL, "gravity, m/s^2"),
  EOM_MEMBER_ARRAY(struct pendulum, mass, 64, REAL, "mass at the end of each link, kg"),
  EOM_MEMBER_ARRAY(struct pendulum, length, 64, REAL, "length of each link, m"),
};

const eom_description pendulum_rows_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), sizeof(eom_motion), &pendulum_rows_model, pendulum_rows_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &pendulum_rows_description;
}
#endif
