/* Model "pendulum_lanes" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#include "pendulum_lanes_tl.h"

#include "taylor/taylor.h"

#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/sincos_array.h"
#include "taylor/ldl_lanes.h"
#include "taylor/sincos_lanes.h"

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

static void pendulum_lanes_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  pendulum_lagrangian_tl(cx, out, q, qd, t, params);
}

/* Whether the parameters have the sizes that the functions below are for. */
static int pendulum_lanes_fits(const void *params)
{
  const struct pendulum *const p = params;
  return p->n == 2;
}

int pendulum_lanes_simulate(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const eom_parts *out, tl_real *restrict work)
{
  (void)t, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  tl_real *const restrict M = out->M;
  tl_real *const restrict Q = out->Q;
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t1 = p->length[1] * p->mass[1];
  M[3] = p->length[1] * t1;
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t2 = p->mass[0] + p->mass[1];
  M[0] = p->length[0] * p->length[0] * t2;
  const tl_real angles[2] = {q[0], q[1]};
  tl_real sines[2], cosines[2];
  tl_sincos_array(2, angles, sines, cosines);
  /* pendulum.c:16 */
  const tl_real t3 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_real t4 = sines[1] * t1;
  const tl_real t5 = p->length[0] * cosines[0];
  const tl_real c2 = cosines[1] * t1;
  M[1] = t3 * t4 + t5 * c2;
  const tl_real t6 = p->length[1] * (qd[1] * qd[1]);
  const tl_real t7 = qd[0] * qd[0];
  const tl_real t8 = sines[1] * t6 + t3 * t7;
  /* pendulum.c:16 */
  const tl_real t9 = cosines[1] * t6 + t5 * t7;
  Q[1] = t8 * c2 - p->g * t4 - t9 * t4;
  Q[0] = p->mass[1] * t8 * t5 - t2 * p->g * t3 - p->mass[1] * t9 * t3;
  for (int i = 1; i < 2; ++i)
    for (int j = 0; j < i; ++j) M[i*2 + j] = M[j*2 + i];
  if (!tl_finite_array(4, M)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, Q)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_lanes_linearise(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const tl_real *restrict qdd, const tl_real *restrict lambda, tl_real *restrict r_y, tl_real *restrict g_y, tl_real *restrict work)
{
  (void)t, (void)lambda, (void)g_y, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  const tl_real angles[2] = {q[0], q[1]};
  tl_real sines[2], cosines[2];
  tl_sincos_array(2, angles, sines, cosines);
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t1 = p->length[0] * cosines[0];
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t2 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_real t3 = qd[0] * qd[0];
  const tl_real t4 = qdd[0] * t1 - t2 * t3;
  /* pendulum.c:16 */
  const tl_real t5 = p->length[1] * p->mass[1];
  /* pendulum.c:15 */
  const tl_real t6 = sines[1] * t5;
  /* pendulum.c:16 */
  const tl_real t7 = t1 * t3 + qdd[0] * t2;
  /* pendulum.c:15 */
  const tl_real c2 = cosines[1] * t5;
  r_y[4] = t4 * t6 - t7 * c2;
  const tl_real t8 = p->length[1] * qdd[1];
  const tl_real t9 = p->length[1] * (qd[1] * qd[1]);
  const tl_real t10 = cosines[1] * t8 - sines[1] * t9;
  /* pendulum.c:16 */
  const tl_real t11 = cosines[1] * t9 + sines[1] * t8;
  const tl_real t12 = t7 + t11;
  /* pendulum.c:15 */
  const tl_real t13 = t4 + t10;
  r_y[5] = p->g * c2 + (t10 * t6 + t12 * c2 - (t11 * c2 + t13 * t6));
  /* pendulum.c:16 */
  const tl_real t14 = TL_C(2.0) * t1 * t6;
  /* pendulum.c:15 */
  const tl_real t15 = TL_C(2.0) * t2 * c2;
  r_y[6] = qd[0] * t14 - qd[0] * t15;
  r_y[7] = TL_C(0.0);
  /* pendulum.c:16 */
  const tl_real t16 = p->mass[1] * t2;
  const tl_real t17 = p->mass[1] * t1;
  r_y[0] = p->g * (p->mass[0] + p->mass[1]) * t1 + (t4 * t16 + t12 * t17 - (t7 * t17 + t13 * t16));
  r_y[1] = t10 * t16 - t11 * t17;
  r_y[2] = TL_C(0.0);
  r_y[3] = qd[1] * t15 - qd[1] * t14;
  if (!tl_finite_array(8, r_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_lanes_acceleration(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict work)
{
  (void)t, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  tl_real M[16];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t1 = p->length[1] * p->mass[1];
  M[1*8 + 1] = p->length[1] * t1;
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t2 = p->mass[0] + p->mass[1];
  M[0*8 + 0] = p->length[0] * p->length[0] * t2;
  const tl_real angles[2] = {q[0], q[1]};
  tl_real sines[2], cosines[2];
  tl_sincos_array(2, angles, sines, cosines);
  /* pendulum.c:16 */
  const tl_real t3 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_real t4 = sines[1] * t1;
  const tl_real t5 = p->length[0] * cosines[0];
  const tl_real c2 = cosines[1] * t1;
  M[0*8 + 1] = t3 * t4 + t5 * c2;
  const tl_real t6 = p->length[1] * (qd[1] * qd[1]);
  const tl_real t7 = qd[0] * qd[0];
  const tl_real t8 = sines[1] * t6 + t3 * t7;
  /* pendulum.c:16 */
  const tl_real t9 = cosines[1] * t6 + t5 * t7;
  Q[1] = t8 * c2 - p->g * t4 - t9 * t4;
  Q[0] = p->mass[1] * t8 * t5 - t2 * p->g * t3 - p->mass[1] * t9 * t3;
  const tl_real pivot = tl_ldl_factor_solve(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  if (!tl_finite_array(2, qdd)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_lanes_acceleration_lanes(const void *params, const tl_lanes *restrict q, const tl_lanes *restrict qd, const tl_lanes *restrict t, tl_lanes *restrict solved, tl_lanes *restrict work)
{
  (void)t, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  tl_lanes M[16];
  tl_lanes Q[8];
  tl_lanes qdd[8];
  tl_lanes dinv[16];
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t1 = p->length[1] * p->mass[1];
  M[1*8 + 1] = tl_lanes_of(p->length[1] * t1);
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t2 = p->mass[0] + p->mass[1];
  M[0*8 + 0] = tl_lanes_of(p->length[0] * p->length[0] * t2);
  const tl_lanes angles[2] = {q[0], q[1]};
  tl_lanes sines[2], cosines[2];
  tl_sincos_lanes(2, angles, sines, cosines);
  /* pendulum.c:16 */
  const tl_lanes t3 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_lanes t4 = sines[1] * t1;
  const tl_lanes t5 = p->length[0] * cosines[0];
  const tl_lanes c2 = cosines[1] * t1;
  M[0*8 + 1] = t3 * t4 + t5 * c2;
  const tl_lanes t6 = p->length[1] * (qd[1] * qd[1]);
  const tl_lanes t7 = qd[0] * qd[0];
  const tl_lanes t8 = sines[1] * t6 + t3 * t7;
  /* pendulum.c:16 */
  const tl_lanes t9 = cosines[1] * t6 + t5 * t7;
  Q[1] = t8 * c2 - p->g * t4 - t9 * t4;
  Q[0] = p->mass[1] * t8 * t5 - t2 * p->g * t3 - p->mass[1] * t9 * t3;
  const tl_lanes pivot = tl_ldl_factor_solve_lanes(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!tl_lanes_all(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  if (!tl_lanes_finite(2, qdd)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_lanes_jacobian(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict qdd_y, tl_real *restrict work)
{
  (void)t, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  tl_real B[16];
  tl_real M[16];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t1 = p->length[1] * p->mass[1];
  M[1*8 + 1] = p->length[1] * t1;
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t2 = p->mass[0] + p->mass[1];
  M[0*8 + 0] = p->length[0] * p->length[0] * t2;
  const tl_real angles[2] = {q[0], q[1]};
  tl_real sines[2], cosines[2];
  tl_sincos_array(2, angles, sines, cosines);
  /* pendulum.c:16 */
  const tl_real t3 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_real t4 = sines[1] * t1;
  const tl_real t5 = p->length[0] * cosines[0];
  const tl_real c2 = cosines[1] * t1;
  M[0*8 + 1] = t3 * t4 + t5 * c2;
  const tl_real t6 = p->length[1] * (qd[1] * qd[1]);
  const tl_real t7 = sines[1] * t6;
  const tl_real t8 = qd[0] * qd[0];
  const tl_real t9 = t3 * t8;
  const tl_real t10 = t7 + t9;
  /* pendulum.c:16 */
  const tl_real t11 = cosines[1] * t6;
  const tl_real t12 = t5 * t8;
  const tl_real t13 = t11 + t12;
  Q[1] = t10 * c2 - p->g * t4 - t13 * t4;
  const tl_real t14 = p->mass[1] * t5;
  /* pendulum.c:21: return T - V; */
  const tl_real t15 = t2 * p->g;
  /* pendulum.c:16 */
  const tl_real t16 = p->mass[1] * t3;
  Q[0] = t10 * t14 - t3 * t15 - t13 * t16;
  const tl_real pivot = tl_ldl_factor_solve(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  /* pendulum.c:15 */
  const tl_real t17 = qdd[0] * t5 - t9;
  /* pendulum.c:16 */
  const tl_real t18 = t12 + qdd[0] * t3;
  B[1*8 + 0] = t17 * t4 - t18 * c2;
  /* pendulum.c:15 */
  const tl_real t19 = p->length[1] * qdd[1];
  const tl_real t20 = cosines[1] * t19 - t7;
  /* pendulum.c:16 */
  const tl_real t21 = t11 + sines[1] * t19;
  const tl_real t22 = t18 + t21;
  /* pendulum.c:15 */
  const tl_real t23 = t17 + t20;
  B[1*8 + 1] = p->g * c2 + (t20 * t4 + t22 * c2 - (t21 * c2 + t23 * t4));
  /* pendulum.c:16 */
  const tl_real t24 = TL_C(2.0) * t5 * t4;
  /* pendulum.c:15 */
  const tl_real t25 = TL_C(2.0) * t3 * c2;
  B[1*8 + 2] = qd[0] * t24 - qd[0] * t25;
  B[1*8 + 3] = TL_C(0.0);
  B[0*8 + 0] = t17 * t16 + t22 * t14 - (t18 * t14 + t23 * t16) + t5 * t15;
  B[0*8 + 1] = t20 * t16 - t21 * t14;
  B[0*8 + 2] = TL_C(0.0);
  B[0*8 + 3] = qd[1] * t25 - qd[1] * t24;
  tl_ldl_solve_negated(2, 4, qdd_y, B, 8, M, 8, dinv);
  if (!tl_finite_array(2, qdd)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(8, qdd_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int pendulum_lanes_jacobian_lanes(const void *params, const tl_lanes *restrict q, const tl_lanes *restrict qd, const tl_lanes *restrict t, tl_lanes *restrict solved, tl_lanes *restrict qdd_y, tl_lanes *restrict work)
{
  (void)t, (void)work;
  const struct pendulum *const p = params;
  if (!pendulum_lanes_fits(params)) return EOM_MOTION_SIZE;
  tl_lanes B[16];
  tl_lanes M[16];
  tl_lanes Q[8];
  tl_lanes qdd[8];
  tl_lanes dinv[16];
  /* pendulum.c:16: vy += p->length[k] * s * qd[k]; */
  const tl_real t1 = p->length[1] * p->mass[1];
  M[1*8 + 1] = tl_lanes_of(p->length[1] * t1);
  /* pendulum.c:15: vx += p->length[k] * c * qd[k]; */
  const tl_real t2 = p->mass[0] + p->mass[1];
  M[0*8 + 0] = tl_lanes_of(p->length[0] * p->length[0] * t2);
  const tl_lanes angles[2] = {q[0], q[1]};
  tl_lanes sines[2], cosines[2];
  tl_sincos_lanes(2, angles, sines, cosines);
  /* pendulum.c:16 */
  const tl_lanes t3 = p->length[0] * sines[0];
  /* pendulum.c:15 */
  const tl_lanes t4 = sines[1] * t1;
  const tl_lanes t5 = p->length[0] * cosines[0];
  const tl_lanes c2 = cosines[1] * t1;
  M[0*8 + 1] = t3 * t4 + t5 * c2;
  const tl_lanes t6 = p->length[1] * (qd[1] * qd[1]);
  const tl_lanes t7 = sines[1] * t6;
  const tl_lanes t8 = qd[0] * qd[0];
  const tl_lanes t9 = t3 * t8;
  const tl_lanes t10 = t7 + t9;
  /* pendulum.c:16 */
  const tl_lanes t11 = cosines[1] * t6;
  const tl_lanes t12 = t5 * t8;
  const tl_lanes t13 = t11 + t12;
  Q[1] = t10 * c2 - p->g * t4 - t13 * t4;
  const tl_lanes t14 = p->mass[1] * t5;
  /* pendulum.c:21: return T - V; */
  const tl_real t15 = t2 * p->g;
  /* pendulum.c:16 */
  const tl_lanes t16 = p->mass[1] * t3;
  Q[0] = t10 * t14 - t3 * t15 - t13 * t16;
  const tl_lanes pivot = tl_ldl_factor_solve_lanes(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!tl_lanes_all(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  /* pendulum.c:15 */
  const tl_lanes t17 = qdd[0] * t5 - t9;
  /* pendulum.c:16 */
  const tl_lanes t18 = t12 + qdd[0] * t3;
  B[1*8 + 0] = t17 * t4 - t18 * c2;
  /* pendulum.c:15 */
  const tl_lanes t19 = p->length[1] * qdd[1];
  const tl_lanes t20 = cosines[1] * t19 - t7;
  /* pendulum.c:16 */
  const tl_lanes t21 = t11 + sines[1] * t19;
  const tl_lanes t22 = t18 + t21;
  /* pendulum.c:15 */
  const tl_lanes t23 = t17 + t20;
  B[1*8 + 1] = p->g * c2 + (t20 * t4 + t22 * c2 - (t21 * c2 + t23 * t4));
  /* pendulum.c:16 */
  const tl_lanes t24 = TL_C(2.0) * t5 * t4;
  /* pendulum.c:15 */
  const tl_lanes t25 = TL_C(2.0) * t3 * c2;
  B[1*8 + 2] = qd[0] * t24 - qd[0] * t25;
  B[1*8 + 3] = tl_lanes_of(TL_C(0.0));
  B[0*8 + 0] = t17 * t16 + t22 * t14 - (t18 * t14 + t23 * t16) + t5 * t15;
  B[0*8 + 1] = t20 * t16 - t21 * t14;
  B[0*8 + 2] = tl_lanes_of(TL_C(0.0));
  B[0*8 + 3] = qd[1] * t25 - qd[1] * t24;
  tl_ldl_solve_many_lanes(2, 4, B, 8, M, 8, dinv);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 4; ++j) qdd_y[i*4 + j] = -B[i*8 + j];
  if (!tl_lanes_finite(2, qdd)) return EOM_MOTION_NOT_FINITE;
  if (!tl_lanes_finite(8, qdd_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

const eom_motion pendulum_lanes_motion = {
  .n = 2,
  .m1 = 0,
  .m2 = 0,
  .fits = pendulum_lanes_fits,
  .work = 0,
  .autonomous = 1,
  .lanes = TL_LANES,
  .simulate = pendulum_lanes_simulate,
  .linearise = pendulum_lanes_linearise,
  .acceleration = pendulum_lanes_acceleration,
  .acceleration_lanes = pendulum_lanes_acceleration_lanes,
  .jacobian = pendulum_lanes_jacobian,
  .jacobian_lanes = pendulum_lanes_jacobian_lanes,
};

static const eom_motion *const pendulum_lanes_motions[] = {&pendulum_lanes_motion};

static int pendulum_lanes_dof(const void *params)
{
  return (int)((const struct pendulum *)params)->n;
}

static size_t pendulum_lanes_lagrangian_frame(const void *params)
{
  (void)params;
  return 10;
}

static int pendulum_lanes_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model pendulum_lanes_model = {
  .name = "pendulum_lanes",
  .dof = pendulum_lanes_dof,
  .params_size = sizeof(struct pendulum),
  .lagrangian = {"pendulum_lagrangian", "pendulum.c:6", pendulum_lanes_lagrangian_jet, pendulum_lanes_lagrangian_rows, pendulum_lanes_lagrangian_frame},
  .force = {0},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
  .motion = pendulum_lanes_motions,
  .nmotion = 1,
};

static const eom_parameter pendulum_lanes_member[] = {
  EOM_MEMBER_UP_TO(struct pendulum, n, 64, INTEGER, "number of links, 1..PENDULUM_MAX_LINKS"),
  EOM_MEMBER(struct pendulum, g, REAL, "gravity, m/s^2"),
  EOM_MEMBER_ARRAY(struct pendulum, mass, 64, REAL, "mass at the end of each link, kg"),
  EOM_MEMBER_ARRAY(struct pendulum, length, 64, REAL, "length of each link, m"),
};

const eom_description pendulum_lanes_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), sizeof(eom_motion), &pendulum_lanes_model, pendulum_lanes_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &pendulum_lanes_description;
}
#endif
