/* Model "crane" on truncated Taylor series, printed by tlgen from crane.c. Do not edit. */
#include "crane_tl.h"

#include "taylor/taylor.h"

static const tl_real height[4] = {TL_C(2.0), TL_C(3.5), -TL_C(0.25), TL_C(0.125)};

/* hang, crane.c:21. */
static void hang_tl(tl_ctx *cx, tl_real *result, const tl_real *top_in, const tl_real *angle, const tl_real *length)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 4);
  if (!frame) return;
  tl_real *const tmp0 = frame + 2*nc;
  tl_real *const tmp1 = frame + 3*nc;
  tl_real *const top = frame;
  tl_move(cx, top, top_in, 2);
  /* crane.c:23: top.x += length * sin(angle); */
  cx->line = 23;
  tl_sin(cx, tmp1, angle);
  tl_mul(cx, tmp0, length, tmp1);
  tl_add(cx, top, top, tmp0);
  /* crane.c:24: top.y -= length * cos(angle); */
  cx->line = 24;
  tl_cos(cx, tmp1, angle);
  tl_mul(cx, tmp0, length, tmp1);
  tl_sub(cx, top + nc, top + nc, tmp0);
  /* crane.c:25: return top; */
  cx->line = 25;
  tl_move(cx, result, top, 2);
  tl_pop(cx, 4);
}

/* polynomial, crane.c:14. */
static void polynomial_tl(tl_ctx *cx, tl_real *result, const tl_real *c, int n, const tl_real *x)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 2);
  if (!frame) return;
  tl_real *const tmp0 = frame + nc;
  /* crane.c:16: double y = 0.0; */
  cx->line = 16;
  tl_real *const y = frame;
  tl_const(cx, y, TL_C(0.0));
  while (n-- > 0) {
    /* crane.c:17: while (n-- > 0) y = y * x + c[n]; */
    cx->line = 17;
    tl_mul(cx, tmp0, y, x);
    tl_shift(cx, y, tmp0, c[n]);
  }
  /* crane.c:18: return y; */
  cx->line = 18;
  tl_copy(cx, result, y);
  tl_pop(cx, 2);
}

/* wind, crane.c:29. */
static void wind_tl(tl_ctx *cx, tl_real *result, const tl_real *t_in, const tl_real *load_in, tl_real *pressure)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 6);
  if (!frame) return;
  tl_real *const tmp0 = frame + 4*nc;
  tl_real *const tmp1 = frame + 5*nc;
  tl_real *const t = frame;
  tl_copy(cx, t, t_in);
  tl_real *const load = frame + nc;
  tl_move(cx, load, load_in, 2);
  /* crane.c:31: double speed = load.y > 2.0 ? 3.0 + sin(2.0 * t) : 1.0; */
  cx->line = 31;
  tl_real *const speed = frame + 3*nc;
  if (load[nc] > TL_C(2.0)) {
    tl_scale(cx, tmp1, t, TL_C(2.0));
    tl_sin(cx, tmp0, tmp1);
    tl_shift(cx, speed, tmp0, TL_C(3.0));
  } else {
    tl_const(cx, speed, TL_C(1.0));
  }
  /* crane.c:33: *pressure = 0.5 * speed * fabs(speed); */
  cx->line = 33;
  tl_scale(cx, tmp0, speed, TL_C(0.5));
  tl_fabs(cx, tmp1, speed);
  tl_mul(cx, pressure, tmp0, tmp1);
  if (load[0] < TL_C(0.0)) {
    /* crane.c:34: if (load.x < 0.0) return -speed; */
    cx->line = 34;
    tl_neg(cx, result, speed);
    tl_pop(cx, 6);
    return;
  }
  /* crane.c:35: return speed; */
  cx->line = 35;
  tl_copy(cx, result, speed);
  tl_pop(cx, 6);
}

/* lagrangian, crane.c:38. */
static void lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *q, const tl_real *qd, const tl_real *t_in, const struct crane *p)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 16);
  if (!frame) return;
  tl_real *const tmp0 = frame + 8*nc;
  tl_real *const tmp1 = frame + 9*nc;
  tl_real *const tmp2 = frame + 10*nc;
  tl_real *const tmp3 = frame + 11*nc;
  tl_real *const tmp4 = frame + 12*nc;
  tl_real *const tmp5 = frame + 13*nc;
  tl_real *const tmp6 = frame + 14*nc;
  tl_real *const tmp7 = frame + 15*nc;
  tl_real *const t = frame;
  tl_copy(cx, t, t_in);
  /* crane.c:40: point top = {q[1], polynomial(height, 4, q[0])}; */
  cx->line = 40;
  tl_real *const top = frame + nc;
  tl_copy(cx, top, q + nc);
  polynomial_tl(cx, top + nc, height, 4, q);
  /* crane.c:41: point load = hang(top, q[2], 1.5 + 0.1 * t); */
  cx->line = 41;
  tl_real *const load = frame + 3*nc;
  cx->line = 41;
  tl_scale(cx, tmp1, t, TL_C(0.1));
  tl_shift(cx, tmp0, tmp1, TL_C(1.5));
  hang_tl(cx, load, top, q + 2*nc, tmp0);
  /* crane.c:42: double T = 0.5 * p->mass * qd[1] * qd[1], pressure, speed; */
  cx->line = 42;
  tl_real *const T = frame + 5*nc;
  tl_scale(cx, tmp0, qd + nc, TL_C(0.5) * p->mass);
  tl_mul(cx, T, tmp0, qd + nc);
  tl_real *const pressure = frame + 6*nc;
  tl_real *const speed = frame + 7*nc;
  for (int k = 0; k < p->sections; k++) {
    if (k == 1) {
      continue;
    }
    /* crane.c:46: T += 0.125 * (k + 1) * qd[0] * qd[0] * pow(top.y, 2); */
    cx->line = 46;
    tl_scale(cx, tmp1, qd, TL_C(0.125) * (tl_real)(k + 1));
    tl_mul(cx, tmp0, tmp1, qd);
    tl_powi(cx, tmp2, top + nc, 2);
    tl_muladd(cx, T, tmp0, tmp2);
  }
  /* crane.c:48: speed = wind(t, load, &pressure); */
  cx->line = 48;
  wind_tl(cx, speed, t, load, pressure);
  /* crane.c:49: return T + 0.5 * p->load * hypot(qd[2], 0.1 * qd[0]) - p->load * p->gravity * load.y + pressure * load.x * speed; */
  cx->line = 49;
  tl_scale(cx, tmp4, qd, TL_C(0.1));
  tl_hypot(cx, tmp3, qd + 2*nc, tmp4);
  tl_scale(cx, tmp2, tmp3, TL_C(0.5) * p->load);
  tl_add(cx, tmp1, T, tmp2);
  tl_scale(cx, tmp5, load + nc, p->load * p->gravity);
  tl_sub(cx, tmp0, tmp1, tmp5);
  tl_mul(cx, tmp7, pressure, load);
  tl_mul(cx, tmp6, tmp7, speed);
  tl_add(cx, result, tmp0, tmp6);
  tl_pop(cx, 16);
}

/* hang, crane.c:21. */
static void hang_tl2(tl_ctx *cx, tl_real *result, const tl_real *top_in, const tl_real *angle, tl_real length)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 3);
  if (!frame) return;
  tl_real *const tmp0 = frame + 2*nc;
  tl_real *const top = frame;
  tl_move(cx, top, top_in, 2);
  /* crane.c:23: top.x += length * sin(angle); */
  cx->line = 23;
  tl_sin(cx, tmp0, angle);
  tl_axpy(cx, top, length, tmp0);
  /* crane.c:24: top.y -= length * cos(angle); */
  cx->line = 24;
  tl_cos(cx, tmp0, angle);
  tl_axpy(cx, top + nc, -length, tmp0);
  /* crane.c:25: return top; */
  cx->line = 25;
  tl_move(cx, result, top, 2);
  tl_pop(cx, 3);
}

/* cable, crane.c:52. */
static void cable_tl(tl_ctx *cx, const tl_real *q, const tl_real *t_in, tl_real *out)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 9);
  if (!frame) return;
  tl_real *const tmp0 = frame + 7*nc;
  tl_real *const tmp1 = frame + 8*nc;
  tl_real *const t = frame;
  tl_copy(cx, t, t_in);
  /* crane.c:54: point load = hang((point){q[1], 0.0}, q[2], 1.0); */
  cx->line = 54;
  tl_real *const load = frame + nc;
  cx->line = 54;
  tl_copy(cx, frame + 5*nc, q + nc);
  tl_const(cx, frame + 5*nc + nc, TL_C(0.0));
  tl_move(cx, frame + 3*nc, frame + 5*nc, 2);
  hang_tl2(cx, load, frame + 3*nc, q + 2*nc, TL_C(1.0));
  /* crane.c:55: out[0] = load.x; */
  cx->line = 55;
  tl_copy(cx, out, load);
  /* crane.c:56: out[1] = load.y + (t > 1.0 ? 0.5 * (t - 1.0) : 0.0); */
  cx->line = 56;
  if (t[0] > TL_C(1.0)) {
    tl_shift(cx, tmp1, t, -TL_C(1.0));
    tl_scale(cx, tmp0, tmp1, TL_C(0.5));
  } else {
    tl_const(cx, tmp0, TL_C(0.0));
  }
  tl_add(cx, out + nc, load + nc, tmp0);
  tl_pop(cx, 9);
}

static void crane_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  lagrangian_tl(cx, out, q, qd, t, params);
}

static void crane_holonomic1_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  (void)qd;
  (void)params;
  cable_tl(cx, q, t, out);
}

static int crane_dof(const void *params)
{
  (void)params;
  return 3;
}

static size_t crane_lagrangian_frame(const void *params)
{
  (void)params;
  return 22;
}

static int crane_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

static size_t crane_holonomic1_frame(const void *params)
{
  (void)params;
  return 12;
}

static int crane_holonomic1_rows(const void *params)
{
  (void)params;
  return 2;
}

static const eom_function crane_holonomic[] = {
  {"cable", "crane.c:52", crane_holonomic1_jet, crane_holonomic1_rows, crane_holonomic1_frame},
};

const eom_model crane_model = {
  .name = "crane",
  .dof = crane_dof,
  .params_size = sizeof(struct crane),
  .lagrangian = {"lagrangian", "crane.c:38", crane_lagrangian_jet, crane_lagrangian_rows, crane_lagrangian_frame},
  .force = {0},
  .holonomic = crane_holonomic,
  .nholonomic = 1,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
};

static const eom_parameter crane_member[] = {
  EOM_MEMBER(struct crane, mass, REAL, NULL),
  EOM_MEMBER(struct crane, load, REAL, NULL),
  EOM_MEMBER(struct crane, gravity, REAL, NULL),
  EOM_MEMBER(struct crane, sections, INTEGER, NULL),
};

const eom_description crane_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), 0, &crane_model, crane_member, 4, NULL, NULL};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &crane_description;
}
#endif
