/* Model "arm" on truncated Taylor series, printed by tlgen from arm.c. Do not edit. */
#include "arm_tl.h"

#include "taylor/taylor.h"

/* lagrangian, arm.c:20. */
static void lagrangian_tl(tl_ctx *cx, tl_real *result, const tl_real *x, const tl_real *theta, const tl_real *xd, const tl_real *thetad, const struct arm *p)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const frame = tl_push(cx, 8);
  if (!frame) return;
  tl_real *const tmp0 = frame;
  tl_real *const tmp1 = frame + nc;
  tl_real *const tmp2 = frame + 2*nc;
  tl_real *const tmp3 = frame + 3*nc;
  tl_real *const tmp4 = frame + 4*nc;
  tl_real *const tmp5 = frame + 5*nc;
  tl_real *const tmp6 = frame + 6*nc;
  tl_real *const tmp7 = frame + 7*nc;
  /* arm.c:22: return 0.5 * p->link[0].mass * xd * xd + p->tool.mass * thetad * thetad - p->stages * cos(theta) - x; */
  cx->line = 22;
  tl_scale(cx, tmp3, xd, TL_C(0.5) * p->link[0].mass);
  tl_mul(cx, tmp2, tmp3, xd);
  tl_scale(cx, tmp5, thetad, p->tool.mass);
  tl_mul(cx, tmp4, tmp5, thetad);
  tl_add(cx, tmp1, tmp2, tmp4);
  tl_cos(cx, tmp7, theta);
  tl_scale(cx, tmp6, tmp7, (tl_real)p->stages);
  tl_sub(cx, tmp0, tmp1, tmp6);
  tl_sub(cx, result, tmp0, x);
  tl_pop(cx, 8);
}

static void arm_lagrangian_jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)
{
  const ptrdiff_t nc = cx->shape->ncoef;
  (void)t;
  lagrangian_tl(cx, out, q, q + nc, qd, qd + nc, params);
}

static int arm_dof(const void *params)
{
  (void)params;
  return 2;
}

static size_t arm_lagrangian_frame(const void *params)
{
  (void)params;
  return 8;
}

static int arm_lagrangian_rows(const void *params)
{
  (void)params;
  return 1;
}

const eom_model arm_model = {
  .name = "arm",
  .dof = arm_dof,
  .params_size = sizeof(struct arm),
  .lagrangian = {"lagrangian", "arm.c:20", arm_lagrangian_jet, arm_lagrangian_rows, arm_lagrangian_frame},
  .force = {0},
  .holonomic = NULL,
  .nholonomic = 0,
  .nonholonomic = NULL,
  .nnonholonomic = 0,
};

static const eom_parameter arm_member[] = {
  EOM_MEMBER(struct arm, link[0].mass, REAL, "kg, of a \"rod\" that is uniform"),
  EOM_MEMBER_ARRAY(struct arm, link[0].at, 2, REAL, "m, its ends"),
  EOM_MEMBER(struct arm, link[1].mass, REAL, "kg, of a \"rod\" that is uniform"),
  EOM_MEMBER_ARRAY(struct arm, link[1].at, 2, REAL, "m, its ends"),
  EOM_MEMBER(struct arm, tool.mass, REAL, "kg, of a \"rod\" that is uniform"),
  EOM_MEMBER_ARRAY(struct arm, tool.at, 2, REAL, "m, its ends"),
  EOM_MEMBER(struct arm, stages, INTEGER, "of the gear"),
  EOM_MEMBER(struct arm, loaded, BOOL, NULL),
  EOM_MEMBER(struct arm, code, UNSIGNED, "\\ on its plate"),
  EOM_MEMBER_ARRAY(struct arm, table[0], 3, REAL, NULL),
  EOM_MEMBER_ARRAY(struct arm, table[1], 3, REAL, NULL),
  EOM_MEMBER_NONE(struct arm, label, "for people"),
  EOM_MEMBER_NONE(struct arm, law, NULL),
};

static const char *const arm_coordinate[] = {"x", "theta"};

static const char *const arm_velocity[] = {"xd", "thetad"};

const eom_description arm_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), 0, &arm_model, arm_member, 13, arm_coordinate, arm_velocity};

#ifdef EOM_SHARED_MODEL /* the model of a shared object */
const eom_description *eom_shared_model(void)
{
  return &arm_description;
}
#endif
