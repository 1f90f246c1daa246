/* Model "bead" on truncated Taylor series, printed by tlgen from bead.c. Do not edit. */
#include "bead_tl.h"

#include "taylor/taylor.h"

#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/sincos_array.h"

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed" /* a loop that is not worth a vector */
#endif

/* bead_lagrangian, bead.c:8. */
static void bead_lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd, const struct bead *p)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 5);
  if (!frame) return;
  tl_real *const tmp0 = frame;
  tl_real *const tmp1 = frame + nc;
  tl_real *const tmp2 = frame + 2*nc;
  tl_real *const tmp3 = frame + 3*nc;
  tl_real *const tmp4 = frame + 4*nc;
  /* bead.c:9: return 0.5 * p->mass * (qd[0] * qd[0] + qd[1] * qd[1]) - p->mass * p->gravity * q[1]; */
  cx->line = 9;
  tl_mul(cx, tmp2, qd, qd);
  tl_mul(cx, tmp3, qd + nc, qd + nc);
  tl_add(cx, tmp1, tmp2, tmp3);
  tl_scale(cx, tmp0, tmp1, TL_C(0.5) * p->mass);
  tl_scale(cx, tmp4, q + nc, p->mass * p->gravity);
  tl_sub(cx, result, tmp0, tmp4);
  tl_pop(cx, 5);
}

/* bead_drag, bead.c:14. */
static void bead_drag_tl(tl_ctx *cx, const tl_real *qd, const struct bead *p, tl_real *out)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  for (int i = 0; i < 2; i++) {
    /* bead.c:15: for (int i = 0; i < 2; i++) out[i] = -p->drag * qd[i]; */
    cx->line = 15;
    tl_scale(cx, out + i*nc, qd + i*nc, -p->drag);
  }
}

/* bead_wire, bead.c:12. */
static void bead_wire_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *t, const struct bead *p)
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
  /* bead.c:12: double bead_wire(const double *q, double t, const struct bead *p) { return q[1] * cos(p->spin * t) - q[0] * sin(p->spin * t); } */
  cx->line = 12;
  tl_scale(cx, tmp2, t, p->spin);
  tl_cos(cx, tmp1, tmp2);
  tl_mul(cx, tmp0, q + nc, tmp1);
  tl_scale(cx, tmp5, t, p->spin);
  tl_sin(cx, tmp4, tmp5);
  tl_mul(cx, tmp3, q, tmp4);
  tl_sub(cx, result, tmp0, tmp3);
  tl_pop(cx, 6);
}

static void bead_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)t;
  bead_lagrangian_tl(cx, out, q, qd, params);
}

static void bead_force_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)q;
  (void)t;
  bead_drag_tl(cx, qd, params, out);
}

static void bead_holonomic1_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)qd;
  bead_wire_tl(cx, out, q, t, params);
}

/* Whether the parameters have the sizes that the functions below are for. */
static int bead_fits(const void *params)
{
  (void)params;
  return 1;
}

int bead_energy(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict momentum, tl_real *restrict momentum_rate, tl_real *restrict lagrangian, tl_real *restrict energy, tl_real *restrict work)
{
  (void)t, (void)work;
  const struct bead *const p = params;
  if (!bead_fits(params)) return EOM_MOTION_SIZE;
  momentum[1] = p->mass * qd[1];
  momentum[0] = p->mass * qd[0];
  /* bead.c:9: return 0.5 * p->mass * (qd[0] * qd[0] + qd[1] * qd[1]) - p->mass * p->gravity * q[1]; */
  const tl_real t1 = p->mass * p->gravity;
  momentum_rate[1] = -(t1 + qd[1] * p->drag);
  momentum_rate[0] = -qd[0] * p->drag;
  lagrangian[0] = TL_C(0.5) * p->mass * (qd[0] * qd[0] + qd[1] * qd[1]) - q[1] * t1;
  tl_real sum = -lagrangian[0];
  for (int i = 0; i < 2; ++i) sum += momentum[i] * qd[i];
  energy[0] = sum;
  if (!tl_finite_array(2, momentum)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, momentum_rate)) return EOM_MOTION_NOT_FINITE;
  if (!TL_ISFINITE(lagrangian[0]) || !TL_ISFINITE(sum)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int bead_simulate(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const eom_parts *out, tl_real *restrict work)
{
  (void)work;
  const struct bead *const p = params;
  if (!bead_fits(params)) return EOM_MOTION_SIZE;
  tl_real *const restrict M = out->M;
  tl_real *const restrict Q = out->Q;
  tl_real *const restrict phi = out->phi;
  tl_real *const restrict phi_dot = out->phi_dot;
  tl_real *const restrict b_phi = out->b;
  tl_real *const restrict A_phi = out->A;
  M[3] = p->mass;
  M[0] = p->mass;
  M[1] = TL_C(0.0);
  Q[1] = -(p->mass * p->gravity + qd[1] * p->drag);
  Q[0] = -qd[0] * p->drag;
  const tl_real angle = p->spin * t;
  tl_real sine, cosine;
  tl_sincos_array(1, &angle, &sine, &cosine);
  phi[0] = cosine * q[1] - sine * q[0];
  /* bead.c:12: double bead_wire(const double *q, double t, const struct bead *p) { return q[1] * cos(p->spin * t) - q[0] * sin(p->spin * t); } */
  const tl_real t1 = p->spin * sine;
  const tl_real t2 = p->spin * cosine;
  phi_dot[0] = cosine * qd[1] - q[1] * t1 - (qd[0] * sine + q[0] * t2);
  const tl_real t3 = TL_C(0.5) * p->spin;
  b_phi[0] = -TL_C(2.0) * (-qd[1] * t1 - q[1] * t2 * t3 - (qd[0] * t2 - q[0] * t1 * t3));
  A_phi[0] = -sine;
  A_phi[1] = cosine;
  for (int i = 1; i < 2; ++i)
    for (int j = 0; j < i; ++j) M[i*2 + j] = M[j*2 + i];
  if (!tl_finite_array(4, M)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, Q)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(1, out->phi)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(1, out->phi_dot)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, out->A)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(1, out->b)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int bead_linearise(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const tl_real *restrict qdd, const tl_real *restrict lambda, tl_real *restrict r_y, tl_real *restrict g_y, tl_real *restrict work)
{
  (void)q, (void)qd, (void)qdd, (void)lambda, (void)work;
  const struct bead *const p = params;
  if (!bead_fits(params)) return EOM_MOTION_SIZE;
  r_y[4] = TL_C(0.0);
  r_y[5] = TL_C(0.0);
  r_y[6] = TL_C(0.0);
  r_y[7] = p->drag;
  r_y[0] = TL_C(0.0);
  r_y[1] = TL_C(0.0);
  r_y[2] = p->drag;
  r_y[3] = TL_C(0.0);
  const tl_real angle = p->spin * t;
  tl_real sine, cosine;
  tl_sincos_array(1, &angle, &sine, &cosine);
  /* bead.c:12: double bead_wire(const double *q, double t, const struct bead *p) { return q[1] * cos(p->spin * t) - q[0] * sin(p->spin * t); } */
  const tl_real t1 = p->spin * sine;
  g_y[0] = p->spin * t1;
  const tl_real t2 = p->spin * cosine;
  g_y[1] = -p->spin * t2;
  g_y[2] = -TL_C(2.0) * t2;
  g_y[3] = -TL_C(2.0) * t1;
  if (!tl_finite_array(8, r_y)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(4, g_y)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int bead_parameters(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, const tl_real *restrict qdd, const tl_real *restrict lambda, tl_real *restrict r_p, tl_real *restrict g_p, tl_real *restrict work)
{
  (void)q, (void)t, (void)lambda, (void)work;
  const struct bead *const p = params;
  if (!bead_fits(params)) return EOM_MOTION_SIZE;
  r_p[2] = p->gravity + qdd[1];
  r_p[3] = qd[1];
  r_p[0] = qdd[0];
  r_p[1] = qd[0];
  g_p[0] = TL_C(0.0);
  g_p[1] = TL_C(0.0);
  if (!tl_finite_array(4, r_p)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, g_p)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

int bead_constrained(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, tl_real *restrict solved, tl_real *restrict lambda, tl_real *restrict Qc, tl_real *restrict work)
{
  (void)work;
  const struct bead *const p = params;
  if (!bead_fits(params)) return EOM_MOTION_SIZE;
  tl_real inverse[8];
  tl_real growth[8];
  const tl_real angle = p->spin * t;
  tl_real sine, cosine;
  tl_sincos_array(1, &angle, &sine, &cosine);
  /* bead.c:12: double bead_wire(const double *q, double t, const struct bead *p) { return q[1] * cos(p->spin * t) - q[0] * sin(p->spin * t); } */
  const tl_real t1 = TL_C(1.0) / p->mass;
  const tl_real t2 = -sine * t1;
  /* bead.c:15: for (int i = 0; i < 2; i++) out[i] = -p->drag * qd[i]; */
  const tl_real t3 = -qd[0] * p->drag;
  /* bead.c:12 */
  const tl_real t4 = p->spin * sine;
  const tl_real t5 = TL_C(0.5) * p->spin;
  const tl_real t6 = p->spin * cosine;
  const tl_real t7 = cosine * t1;
  const tl_real t8 = -(p->mass * p->gravity + qd[1] * p->drag);
  const tl_real t9 = -t7 * cosine - t2 * -sine;
  const tl_real t10 = TL_C(1.0) / t9;
  const tl_real t11 = (-t2 * t3 - TL_C(2.0) * (-qd[1] * t4 - q[1] * t5 * t6 - (qd[0] * t6 - q[0] * t4 * t5)) - t7 * t8) * t10;
  const tl_real t12 = -(-sine * t11);
  solved[0] = (t12 + t3) * t1;
  const tl_real t13 = -cosine * t11;
  solved[1] = (t13 + t8) * t1;
  lambda[0] = -t11;
  Qc[0] = t12;
  Qc[1] = t13;
  inverse[0] = t1;
  growth[0] = t9 * t10;
  int sound = 1;
  for (int i = 0; i < 1; ++i) sound &= (inverse[i] > TL_C(0.0)) & (inverse[i] <= TL_MAX);
  for (int i = 0; i < 1; ++i) sound &= (growth[i] > TL_C(0.0)) & (growth[i] * EOM_MOTION_SAFE_PIVOT < TL_C(1.0));
  if (!sound) return EOM_MOTION_PIVOT;
  if (!tl_finite_array(2, solved)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(1, lambda)) return EOM_MOTION_NOT_FINITE;
  if (!tl_finite_array(2, Qc)) return EOM_MOTION_NOT_FINITE;
  return 0;
}

static const char *const bead_parameter[] = {
  "p->mass",
  "p->drag",
};

const eom_motion bead_motion = {
  .n = 2,
  .m1 = 1,
  .m2 = 0,
  .fits = bead_fits,
  .work = 0,
  .constant_mass = 1,
  .parameter = bead_parameter,
  .np = 2,
  .energy = bead_energy,
  .simulate = bead_simulate,
  .linearise = bead_linearise,
  .parameters = bead_parameters,
  .constrained = bead_constrained,
};

static const eom_motion *const bead_motions[] = {&bead_motion};

static int bead_dof(const void *params)
{
  (void)params;
  return 2;
}

static size_t bead_lagrangian_frame(const void *params)
{
  (void)params;
  return 5;
}

static int bead_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

static size_t bead_force_frame(const void *params)
{
  (void)params;
  return 0;
}

static size_t bead_holonomic1_frame(const void *params)
{
  (void)params;
  return 6;
}

static int bead_holonomic1_rows(const void *params)
{
  (void)params;
  return 1;
}

static const eom_function bead_holonomic[] = {
  {"bead_wire", "bead.c:12", bead_holonomic1_jet, bead_holonomic1_rows, bead_holonomic1_frame},
};

const eom_model bead_model = {
  .name = "bead",
  .dof = bead_dof,
  .params_size = sizeof(struct bead),
  .lagrangian = {"bead_lagrangian", "bead.c:8", bead_lagrangian_jet, bead_lagrangian_rows, bead_lagrangian_frame},
  .force = {"bead_drag", "bead.c:14", bead_force_jet, bead_dof, bead_force_frame},
  .holonomic = bead_holonomic,
  .nholonomic = 1,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
  .motion = bead_motions,
  .nmotion = 1,
};

static const eom_parameter bead_member[] = {
  EOM_MEMBER(struct bead, mass, REAL, "kg, m/s^2, N s/m, 1/s"),
  EOM_MEMBER(struct bead, gravity, REAL, "kg, m/s^2, N s/m, 1/s"),
  EOM_MEMBER(struct bead, drag, REAL, "kg, m/s^2, N s/m, 1/s"),
  EOM_MEMBER(struct bead, spin, REAL, "kg, m/s^2, N s/m, 1/s"),
};

const eom_description bead_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), sizeof(eom_motion), &bead_model, bead_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &bead_description;
}
#endif
