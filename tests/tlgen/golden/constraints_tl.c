/* Model "constraints" on truncated Taylor series, printed by tlgen from constraints.c. Do not edit. */
#include "constraints_tl.h"

#include "taylor/taylor.h"

/* square, constraints.c:7. */
static void square_tl(tl_ctx *cx, tl_real *result, const tl_real *x)
{
  /* constraints.c:7: static double square(double x) { return x * x; } */
  cx->line = 7;
  tl_mul(cx, result, x, x);
}

/* energy, constraints.c:9. */
static void energy_tl(tl_ctx *cx, tl_real *result, const struct linkage *p, const tl_real *q, const tl_real *qd)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 3);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  tl_real *const tmp1 = frame + 2*nc;
  /* constraints.c:11: double T = 0.0; */
  cx->line = 11;
  tl_real *const T = frame;
  tl_const(cx, T, TL_C(0.0));
  for (int i = 0; i < p->coordinates; i++) {
    /* constraints.c:12: for (int i = 0; i < p->coordinates; i++) T += 0.5 * square(qd[i]); */
    cx->line = 12;
    square_tl(cx, tmp0, qd + i*nc);
    cx->line = 12;
    tl_axpy(cx, T, TL_C(0.5), tmp0);
  }
  /* constraints.c:13: return T - 9.81 * (q[1] + q[3]); */
  cx->line = 13;
  tl_add(cx, tmp1, q + nc, q + 3*nc);
  tl_scale(cx, tmp0, tmp1, TL_C(9.81));
  tl_sub(cx, result, T, tmp0);
  tl_pop(cx, 3);
}

/* friction, constraints.c:16. */
static void friction_tl(tl_ctx *cx, const tl_real *qd, const struct linkage *p, tl_real *out)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 3);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  tl_real *const tmp1 = frame + 2*nc;
  for (int i = 0; i < p->coordinates; i++) {
    /* constraints.c:18: for (int i = 0; i < p->coordinates; i++) out[i] = 0.0; */
    cx->line = 18;
    tl_const(cx, out + i*nc, TL_C(0.0));
  }
  /* constraints.c:19: out[1] = -0.1 * qd[1]; */
  cx->line = 19;
  tl_scale(cx, out + nc, qd + nc, -TL_C(0.1));
  for (int i = 2; i < p->coordinates; i++) {
    /* constraints.c:21: double speed = sqrt(1.0 + square(qd[i])); */
    cx->line = 21;
    tl_real *const speed = frame;
    square_tl(cx, tmp1, qd + i*nc);
    cx->line = 21;
    tl_shift(cx, tmp0, tmp1, TL_C(1.0));
    tl_sqrt(cx, speed, tmp0);
    /* constraints.c:22: out[i] -= speed * qd[i]; */
    cx->line = 22;
    tl_mul(cx, tmp0, speed, qd + i*nc);
    tl_sub(cx, out + i*nc, out + i*nc, tmp0);
  }
  tl_pop(cx, 3);
}

/* square, constraints.c:7. */
static tl_real square(tl_real x)
{
  return x * x;
}

/* rods, constraints.c:26. */
static void rods_tl(tl_ctx *cx, const tl_real *q, const tl_real *t_in, const struct linkage *p, tl_real *out)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 6);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  tl_real *const tmp1 = frame + 2*nc;
  tl_real *const tmp2 = frame + 3*nc;
  tl_real *const tmp3 = frame + 4*nc;
  tl_real *const tmp4 = frame + 5*nc;
  tl_real *const t = frame;
  tl_copy(cx, t, t_in);
  const tl_real *from = q;
  /* constraints.c:29: out[0] = square(q[0] - 0.1 * t) + square(q[1]) - square(p->length[0]); */
  cx->line = 29;
  cx->line = 29;
  tl_scale(cx, tmp3, t, TL_C(0.1));
  tl_sub(cx, tmp2, q, tmp3);
  square_tl(cx, tmp1, tmp2);
  square_tl(cx, tmp4, q + nc);
  cx->line = 29;
  tl_add(cx, tmp0, tmp1, tmp4);
  tl_shift(cx, out, tmp0, -square(p->length[0]));
  {
    int k = 1;
    for (int again0_ = 0;; again0_ = 1) {
      if (again0_) {
        k++;
        from += 2*nc;
      }
      if (!(k < p->links)) break;
      /* constraints.c:31: *++out = square(from[2] - from[0]) + square(from[3] - from[1]) - square(p->length[k]); */
      cx->line = 31;
      tl_real *const place1_ = (out += nc);
      cx->line = 31;
      tl_sub(cx, tmp2, from + 2*nc, from);
      square_tl(cx, tmp1, tmp2);
      cx->line = 31;
      tl_sub(cx, tmp4, from + 3*nc, from + nc);
      square_tl(cx, tmp3, tmp4);
      tl_add(cx, tmp0, tmp1, tmp3);
      tl_shift(cx, place1_, tmp0, -square(p->length[k]));
    }
  }
  tl_pop(cx, 6);
}

/* ground, constraints.c:34. */
static void ground_tl(tl_ctx *cx, tl_real *result, const tl_real *q)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  /* constraints.c:34: double ground(const double *q) { return q[3] + 0.5; } */
  cx->line = 34;
  tl_shift(cx, result, q + 3*nc, TL_C(0.5));
}

/* rolling, constraints.c:36. */
static void rolling_tl(tl_ctx *cx, const tl_real *q, const tl_real *qd, const tl_real *t_in, const struct linkage *p, tl_real *out)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 5);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  tl_real *const tmp1 = frame + 2*nc;
  tl_real *const tmp2 = frame + 3*nc;
  tl_real *const tmp3 = frame + 4*nc;
  tl_real *const t = frame;
  tl_copy(cx, t, t_in);
  /* constraints.c:38: out[0] = qd[0] * sin(q[1]) - qd[1] * cos(q[1]); */
  cx->line = 38;
  tl_sin(cx, tmp1, q + nc);
  tl_mul(cx, tmp0, qd, tmp1);
  tl_cos(cx, tmp3, q + nc);
  tl_mul(cx, tmp2, qd + nc, tmp3);
  tl_sub(cx, out, tmp0, tmp2);
  /* constraints.c:39: out[1] = qd[2] - p->ratio * qd[3] * exp(q[0]); */
  cx->line = 39;
  tl_scale(cx, tmp1, qd + 3*nc, p->ratio);
  tl_exp(cx, tmp2, q);
  tl_mul(cx, tmp0, tmp1, tmp2);
  tl_sub(cx, out + nc, qd + 2*nc, tmp0);
  /* constraints.c:40: out[2] = 0.0; */
  cx->line = 40;
  tl_const(cx, out + 2*nc, TL_C(0.0));
  /* constraints.c:41: out[2] += t * qd[0]; */
  cx->line = 41;
  tl_mul(cx, tmp0, t, qd);
  tl_add(cx, out + 2*nc, out + 2*nc, tmp0);
  tl_pop(cx, 5);
}

/* sleigh, constraints.c:44. */
static void sleigh_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 2);
  if (!frame) return;
  tl_real *const tmp0 = frame;
  tl_real *const tmp1 = frame + nc;
  /* constraints.c:44: double sleigh(const double *q, const double *qd) { return qd[0] * q[2] - q[0] * qd[2]; } */
  cx->line = 44;
  tl_mul(cx, tmp0, qd, q + 2*nc);
  tl_mul(cx, tmp1, q, qd + 2*nc);
  tl_sub(cx, result, tmp0, tmp1);
  tl_pop(cx, 2);
}

static void constraints_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)t;
  energy_tl(cx, out, params, q, qd);
}

static void constraints_force_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)q;
  (void)t;
  friction_tl(cx, qd, params, out);
}

static void constraints_holonomic1_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)qd;
  rods_tl(cx, q, t, params, out);
}

static void constraints_holonomic2_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)qd;
  (void)t;
  (void)params;
  ground_tl(cx, out, q);
}

static void constraints_nonholonomic1_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  rolling_tl(cx, q, qd, t, params, out);
}

static void constraints_nonholonomic2_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)t;
  (void)params;
  sleigh_tl(cx, out, q, qd);
}

static int constraints_dof(const void *params)
{
  return (int)((const struct linkage *)params)->coordinates;
}

static size_t constraints_lagrangian_frame(const void *params)
{
  (void)params;
  return 3;
}

static int constraints_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

static size_t constraints_force_frame(const void *params)
{
  (void)params;
  return 3;
}

static size_t constraints_holonomic1_frame(const void *params)
{
  (void)params;
  return 6;
}

static int constraints_holonomic1_rows(const void *params)
{
  return (int)((const struct linkage *)params)->links;
}

static size_t constraints_holonomic2_frame(const void *params)
{
  (void)params;
  return 0;
}

static int constraints_holonomic2_rows(const void *params)
{
  (void)params;
  return 1;
}

static size_t constraints_nonholonomic1_frame(const void *params)
{
  (void)params;
  return 5;
}

static int constraints_nonholonomic1_rows(const void *params)
{
  (void)params;
  return 3;
}

static size_t constraints_nonholonomic2_frame(const void *params)
{
  (void)params;
  return 2;
}

static int constraints_nonholonomic2_rows(const void *params)
{
  (void)params;
  return 1;
}

static const eom_function constraints_holonomic[] = {
  {"rods", "constraints.c:26", constraints_holonomic1_jet, constraints_holonomic1_rows, constraints_holonomic1_frame},
  {"ground", "constraints.c:34", constraints_holonomic2_jet, constraints_holonomic2_rows, constraints_holonomic2_frame},
};

static const eom_function constraints_nonholonomic[] = {
  {"rolling", "constraints.c:36", constraints_nonholonomic1_jet, constraints_nonholonomic1_rows, constraints_nonholonomic1_frame},
  {"sleigh", "constraints.c:44", constraints_nonholonomic2_jet, constraints_nonholonomic2_rows, constraints_nonholonomic2_frame},
};

const eom_model constraints_model = {
  .name = "constraints",
  .dof = constraints_dof,
  .params_size = sizeof(struct linkage),
  .lagrangian = {"energy", "constraints.c:9", constraints_lagrangian_jet, constraints_lagrangian_rows, constraints_lagrangian_frame},
  .force = {"friction", "constraints.c:16", constraints_force_jet, constraints_dof, constraints_force_frame},
  .holonomic = constraints_holonomic,
  .nholonomic = 2,
  .nonholonomic = constraints_nonholonomic,
  .nnonholonomic = 2,
};

static const eom_parameter constraints_member[] = {
  EOM_MEMBER(struct linkage, coordinates, INTEGER, NULL),
  EOM_MEMBER(struct linkage, links, INTEGER, NULL),
  EOM_MEMBER_ARRAY(struct linkage, length, 2, REAL, NULL),
  EOM_MEMBER(struct linkage, ratio, REAL, NULL),
};

const eom_description constraints_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), 0, &constraints_model, constraints_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &constraints_description;
}
#endif
