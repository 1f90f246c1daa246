/* Model "kepler" on truncated Taylor series, printed by tlgen from kepler.c. Do not edit. */
#include "kepler_tl.h"

#include "taylor/taylor.h"

#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/sincos_array.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* a loop that is not worth a vector */
#endif

/* kepler_lagrangian, kepler.c:6. */
static void kepler_lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 6);
  if (!frame) return;
  tl_real *const tmp0 = frame;
  tl_real *const tmp1 = frame + nc;
  tl_real *const tmp2 = frame + 2*nc;
  tl_real *const tmp3 = frame + 3*nc;
  tl_real *const tmp4 = frame + 4*nc;
  tl_real *const tmp5 = frame + 5*nc;
  /* kepler.c:7: return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]); */
  cx->line = 7;
  tl_mul(cx, tmp2, qd, qd);
  tl_mul(cx, tmp3, qd + nc, qd + nc);
  tl_add(cx, tmp1, tmp2, tmp3);
  tl_scale(cx, tmp0, tmp1, TL_C(0.5));
  tl_hypot(cx, tmp5, q, q + nc);
  tl_rdiv(cx, tmp4, TL_C(1.0), tmp5);
  tl_add(cx, result, tmp0, tmp4);
  tl_pop(cx, 6);
}

static void kepler_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)t;
  (void)params;
  kepler_lagrangian_tl(cx, out, q, qd);
}

/* Whether the parameters have the sizes that the functions below are for. */
static int kepler_fits(const void *params)
{
  (void)params;
  return 1;
}

int kepler_simulate(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const eom_parts *out, tl_real *restrict work)
{
  (void)qd, (void)t, (void)work;
  if (!kepler_fits(params)) return EOM_MOTION_SIZE;
  int outside1 = 0, outside2 = 0;
  tl_real *const restrict M = out->M;
  tl_real *const restrict Q = out->Q;
  /* kepler.c:7: return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]); */
  const tl_real t1 = TL_LIBM(hypot)(q[0], q[1]);
  const int t2 = t1 == TL_C(0.0);
  outside1 |= t2;
  outside2 |= t2;
  M[3] = TL_C(1.0);
  M[0] = TL_C(1.0);
  M[1] = TL_C(0.0);
  const tl_real t3 = TL_C(1.0) / t1;
  const tl_real t4 = t3 * (t3 * t3);
  Q[1] = -q[1] * t4;
  Q[0] = -q[0] * t4;
  if (outside1 | outside2) return outside1 ? 1 : 2;
  for (int i = 1; i < 2; ++i)
    for (int j = 0; j < i; ++j) M[i*2 + j] = M[j*2 + i];
  if (!tl_finite_array(4, M)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, Q)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int kepler_linearise(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const tl_real *restrict qdd, const tl_real *restrict lambda, tl_real *restrict r_y, tl_real *restrict g_y, tl_real *restrict work)
{
  (void)qd, (void)t, (void)qdd, (void)lambda, (void)g_y, (void)work;
  if (!kepler_fits(params)) return EOM_MOTION_SIZE;
  int outside1 = 0, outside2 = 0;
  /* kepler.c:7: return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]); */
  const tl_real t1 = TL_LIBM(hypot)(q[0], q[1]);
  const int t2 = t1 == TL_C(0.0);
  outside1 |= t2;
  outside2 |= t2;
  const tl_real t3 = TL_C(1.0) / t1;
  const tl_real t4 = t3 * (t3 * t3);
  const tl_real t5 = TL_C(3.0) * t3 * (t3 * t4);
  const tl_real t6 = q[1] * t5;
  const tl_real t7 = -q[0] * t6;
  r_y[4] = t7;
  r_y[5] = t4 - q[1] * t6;
  r_y[6] = TL_C(0.0);
  r_y[7] = TL_C(0.0);
  r_y[0] = t4 - q[0] * q[0] * t5;
  r_y[1] = t7;
  r_y[2] = TL_C(0.0);
  r_y[3] = TL_C(0.0);
  if (outside1 | outside2) return outside1 ? 1 : 2;
  if (!tl_finite_array(8, r_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int kepler_acceleration(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict work)
{
  (void)qd, (void)t, (void)work;
  if (!kepler_fits(params)) return EOM_MOTION_SIZE;
  tl_real M[16];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  int outside1 = 0, outside2 = 0;
  /* kepler.c:7: return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]); */
  const tl_real t1 = TL_LIBM(hypot)(q[0], q[1]);
  const int t2 = t1 == TL_C(0.0);
  outside1 |= t2;
  outside2 |= t2;
  M[1*8 + 1] = TL_C(1.0);
  M[0*8 + 0] = TL_C(1.0);
  M[0*8 + 1] = TL_C(0.0);
  const tl_real t3 = TL_C(1.0) / t1;
  const tl_real t4 = t3 * (t3 * t3);
  Q[1] = -q[1] * t4;
  Q[0] = -q[0] * t4;
  if (outside1 | outside2) return outside1 ? 1 : 2;
  const tl_real pivot = tl_ldl_factor_solve(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  if (!tl_finite_array(2, qdd)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int kepler_jacobian(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict qdd_y, tl_real *restrict work)
{
  (void)qd, (void)t, (void)work;
  if (!kepler_fits(params)) return EOM_MOTION_SIZE;
  tl_real B[16];
  tl_real M[16];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  int outside1 = 0, outside2 = 0;
  /* kepler.c:7: return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]); */
  const tl_real t1 = TL_LIBM(hypot)(q[0], q[1]);
  const int t2 = t1 == TL_C(0.0);
  outside1 |= t2;
  outside2 |= t2;
  M[1*8 + 1] = TL_C(1.0);
  M[0*8 + 0] = TL_C(1.0);
  M[0*8 + 1] = TL_C(0.0);
  const tl_real t3 = TL_C(1.0) / t1;
  const tl_real t4 = t3 * t3;
  const tl_real t5 = t3 * t4;
  const tl_real t6 = q[1] * t5;
  Q[1] = -t6;
  const tl_real t7 = q[0] * t5;
  Q[0] = -t7;
  if (outside1 | outside2) return outside1 ? 1 : 2;
  const tl_real pivot = tl_ldl_factor_solve(2, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 2; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(2) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  const tl_real t8 = TL_C(3.0) * t4;
  const tl_real t9 = t6 * t8;
  const tl_real t10 = -q[0] * t9;
  B[1*8 + 0] = t10;
  B[1*8 + 1] = t5 - q[1] * t9;
  B[1*8 + 2] = TL_C(0.0);
  B[1*8 + 3] = TL_C(0.0);
  B[0*8 + 0] = t5 - q[0] * t8 * t7;
  B[0*8 + 1] = t10;
  B[0*8 + 2] = TL_C(0.0);
  B[0*8 + 3] = TL_C(0.0);
  if (outside1 | outside2) return outside1 ? 1 : 2;
  tl_ldl_solve_negated(2, 4, qdd_y, B, 8, M, 8, dinv);
  if (!tl_finite_array(2, qdd)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(8, qdd_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

static const eom_site kepler_sites[] = {
  {TL_FN_div, "kepler.c", 7},
  {TL_FN_hypot, "kepler.c", 7},
};

const eom_motion kepler_motion = {
  .n = 2,
  .m1 = 0,
  .m2 = 0,
  .fits = kepler_fits,
  .work = 0,
  .autonomous = 1,
  .constant_mass = 1,
  .sites = kepler_sites,
  .nsite = 2,
  .simulate = kepler_simulate,
  .linearise = kepler_linearise,
  .acceleration = kepler_acceleration,
  .jacobian = kepler_jacobian,
};

static const eom_motion *const kepler_motions[] = {&kepler_motion};

static int kepler_dof(const void *params)
{
  (void)params;
  return 2;
}

static size_t kepler_lagrangian_frame(const void *params)
{
  (void)params;
  return 6;
}

static int kepler_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model kepler_model = {
  .name = "kepler",
  .dof = kepler_dof,
  .params_size = 0,
  .lagrangian = {"kepler_lagrangian", "kepler.c:6", kepler_lagrangian_jet, kepler_lagrangian_rows, kepler_lagrangian_frame},
  .force = {0},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
  .motion = kepler_motions,
  .nmotion = 1,
};

const eom_description kepler_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), sizeof(eom_motion), &kepler_model, NULL, 0, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &kepler_description;
}
#endif
