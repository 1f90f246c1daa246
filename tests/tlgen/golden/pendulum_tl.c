/* Model "pendulum" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#include "pendulum_tl.h"

#include "taylor/taylor.h"

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

static void pendulum_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  pendulum_lagrangian_tl(cx, out, q, qd, t, params);
}

static int pendulum_dof(const void *params)
{
  return (int)((const struct pendulum *)params)->n;
}

static size_t pendulum_lagrangian_frame(const void *params)
{
  (void)params;
  return 10;
}

static int pendulum_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model pendulum_model = {
  .name = "pendulum",
  .dof = pendulum_dof,
  .params_size = sizeof(struct pendulum),
  .lagrangian = {"pendulum_lagrangian", "pendulum.c:6", pendulum_lagrangian_jet, pendulum_lagrangian_rows, pendulum_lagrangian_frame},
  .force = {0},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
};

static const eom_parameter pendulum_member[] = {
  EOM_MEMBER_UP_TO(struct pendulum, n, 64, INTEGER, "number of links, 1..PENDULUM_MAX_LINKS"),
  EOM_MEMBER(struct pendulum, g, REAL, "gravity, m/s^2"),
  EOM_MEMBER_ARRAY(struct pendulum, mass, 64, REAL, "mass at the end of each link, kg"),
  EOM_MEMBER_ARRAY(struct pendulum, length, 64, REAL, "length of each link, m"),
};

const eom_description pendulum_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), 0, &pendulum_model, pendulum_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &pendulum_description;
}
#endif
