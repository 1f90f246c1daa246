/* Model "damper" on truncated Taylor series, printed by tlgen from damper.c. Do not edit. */
#include "damper_tl.h"

#include "taylor/taylor.h"

#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/sincos_array.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* a loop that is not worth a vector */
#endif

/* damper_lagrangian, damper.c:4. */
static void damper_lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 3);
  if (!frame) return;
  tl_real *const tmp0 = frame;
  tl_real *const tmp1 = frame + nc;
  tl_real *const tmp2 = frame + 2*nc;
  /* damper.c:4: double damper_lagrangian(const double *q, const double *qd) { return 0.5 * (qd[0] * qd[0] - q[0] * q[0]); } */
  cx->line = 4;
  tl_mul(cx, tmp1, qd, qd);
  tl_mul(cx, tmp2, q, q);
  tl_sub(cx, tmp0, tmp1, tmp2);
  tl_scale(cx, result, tmp0, TL_C(0.5));
  tl_pop(cx, 3);
}

/* damper_loss, damper.c:6. */
static void damper_loss_tl(tl_ctx *cx, tl_real *result, const tl_real *qd)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 4);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  tl_real *const tmp1 = frame + 2*nc;
  tl_real *const tmp2 = frame + 3*nc;
  /* damper.c:8: const double speed = fabs(qd[0]); */
  cx->line = 8;
  tl_real *const speed = frame;
  tl_fabs(cx, speed, qd);
  /* damper.c:9: return 0.2 * speed * speed * speed / 3.0; */
  cx->line = 9;
  tl_scale(cx, tmp2, speed, TL_C(0.2));
  tl_mul(cx, tmp1, tmp2, speed);
  tl_mul(cx, tmp0, tmp1, speed);
  tl_divc(cx, result, tmp0, TL_C(3.0));
  tl_pop(cx, 4);
}

static void damper_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)t;
  (void)params;
  damper_lagrangian_tl(cx, out, q, qd);
}

static void damper_dissipation_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)q;
  (void)t;
  (void)params;
  damper_loss_tl(cx, out, qd);
}

/* Whether the parameters have the sizes that the functions below are for. */
static int damper_fits(const void *params)
{
  (void)params;
  return 1;
}

int damper_simulate(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const eom_parts *out, tl_real *restrict work)
{
  (void)t, (void)work;
  if (!damper_fits(params)) return EOM_MOTION_SIZE;
  int outside1 = 0;
  tl_real *const restrict M = out->M;
  tl_real *const restrict Q = out->Q;
  outside1 |= qd[0] == TL_C(0.0);
  M[0] = TL_C(1.0);
  /* damper.c:8: const double speed = fabs(qd[0]); */
  const tl_real speed = TL_LIBM(fabs)(qd[0]);
  Q[0] = -q[0] - TL_C(0.2) * speed * speed * TL_LIBM(copysign)(TL_C(1.0), qd[0]);
  if (outside1) return 1;
  if (!tl_finite_array(1, M)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(1, Q)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int damper_linearise(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const tl_real *restrict qdd, const tl_real *restrict lambda, tl_real *restrict r_y, tl_real *restrict g_y, tl_real *restrict work)
{
  (void)q, (void)t, (void)qdd, (void)lambda, (void)g_y, (void)work;
  if (!damper_fits(params)) return EOM_MOTION_SIZE;
  int outside1 = 0;
  outside1 |= qd[0] == TL_C(0.0);
  r_y[0] = TL_C(1.0);
  /* damper.c:8: const double speed = fabs(qd[0]); */
  const tl_real t1 = TL_LIBM(copysign)(TL_C(1.0), qd[0]);
  r_y[1] = TL_C(0.4) * TL_LIBM(fabs)(qd[0]) * t1 * t1;
  if (outside1) return 1;
  if (!tl_finite_array(2, r_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int damper_acceleration(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict work)
{
  (void)t, (void)work;
  if (!damper_fits(params)) return EOM_MOTION_SIZE;
  tl_real M[8];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  int outside1 = 0;
  outside1 |= qd[0] == TL_C(0.0);
  M[0*8 + 0] = TL_C(1.0);
  /* damper.c:8: const double speed = fabs(qd[0]); */
  const tl_real speed = TL_LIBM(fabs)(qd[0]);
  Q[0] = -q[0] - TL_C(0.2) * speed * speed * TL_LIBM(copysign)(TL_C(1.0), qd[0]);
  if (outside1) return 1;
  const tl_real pivot = tl_ldl_factor_solve(1, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 1; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(1) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  if (!tl_finite_array(1, qdd)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int damper_jacobian(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict qdd_y, tl_real *restrict work)
{
  (void)t, (void)work;
  if (!damper_fits(params)) return EOM_MOTION_SIZE;
  tl_real B[8];
  tl_real M[8];
  tl_real Q[8];
  tl_real qdd[8];
  tl_real dinv[16];
  int outside1 = 0;
  outside1 |= qd[0] == TL_C(0.0);
  M[0*8 + 0] = TL_C(1.0);
  /* damper.c:8: const double speed = fabs(qd[0]); */
  const tl_real speed = TL_LIBM(fabs)(qd[0]);
  const tl_real t1 = TL_LIBM(copysign)(TL_C(1.0), qd[0]);
  /* damper.c:9: return 0.2 * speed * speed * speed / 3.0; */
  const tl_real t2 = speed * t1;
  Q[0] = -q[0] - TL_C(0.2) * speed * t2;
  if (outside1) return 1;
  const tl_real pivot = tl_ldl_factor_solve(1, qdd, M, 8, dinv, Q);
  for (int i = 0; i < 1; ++i) solved[i] = qdd[i];
  if (!(pivot * EOM_MOTION_LEAST_PIVOT(1) < TL_C(1.0))) return EOM_MOTION_PIVOT;
  B[0*8 + 0] = TL_C(1.0);
  B[0*8 + 1] = TL_C(0.4) * t1 * t2;
  if (outside1) return 1;
  tl_ldl_solve_negated(1, 2, qdd_y, B, 8, M, 8, dinv);
  if (!tl_finite_array(1, qdd)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, qdd_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

static const eom_site damper_sites[] = {
  {TL_FN_fabs, "damper.c", 8},
};

const eom_motion damper_motion = {
  .n = 1,
  .m1 = 0,
  .m2 = 0,
  .fits = damper_fits,
  .work = 0,
  .autonomous = 1,
  .constant_mass = 1,
  .sites = damper_sites,
  .nsite = 1,
  .simulate = damper_simulate,
  .linearise = damper_linearise,
  .acceleration = damper_acceleration,
  .jacobian = damper_jacobian,
};

static const eom_motion *const damper_motions[] = {&damper_motion};

static int damper_dof(const void *params)
{
  (void)params;
  return 1;
}

static size_t damper_lagrangian_frame(const void *params)
{
  (void)params;
  return 3;
}

static int damper_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

static size_t damper_dissipation_frame(const void *params)
{
  (void)params;
  return 4;
}

static int damper_dissipation_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model damper_model = {
  .name = "damper",
  .dof = damper_dof,
  .params_size = 0,
  .lagrangian = {"damper_lagrangian", "damper.c:4", damper_lagrangian_jet, damper_lagrangian_rows, damper_lagrangian_frame},
  .force = {0},
  .dissipation = {"damper_loss", "damper.c:6", damper_dissipation_jet, damper_dissipation_rows, damper_dissipation_frame},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
  .motion = damper_motions,
  .nmotion = 1,
};

const eom_description damper_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), sizeof(eom_motion), &damper_model, NULL, 0, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &damper_description;
}
#endif
