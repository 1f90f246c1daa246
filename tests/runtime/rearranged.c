/* A model with its constraint rows written otherwise: repeated, scaled, in another order. */
#include "rearranged.h"

#include "taylor/taylor.h"

static int dof(const void *params) {
  const rearranged *r = params;
  return r->model->dof(r->params);
}

static int one(const void *params) { return (void)params, 1; }
static int rows(const void *params) { return ((const rearranged *)params)->rows; }

static size_t lagrangian_frame(const void *params) {
  const rearranged *r = params;
  return r->model->lagrangian.frame(r->params);
}

static size_t force_frame(const void *params) {
  const rearranged *r = params;
  return r->model->force.frame(r->params);
}

static int rows_there(const rearranged *r) { return r->model->holonomic[0].rows(r->params); }

static size_t constraint_frame(const void *params) {
  const rearranged *r = params;
  return r->model->holonomic[0].frame(r->params) + (size_t)rows_there(r);
}

static void lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  const rearranged *r = params;
  r->model->lagrangian.jet(cx, out, q, qd, t, r->params);
}

static void force(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  const rearranged *r = params;
  r->model->force.jet(cx, out, q, qd, t, r->params);
}

static void constraint(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  const rearranged *r = params;
  const ptrdiff_t nc = cx->shape->ncoef;
  const int count = rows_there(r);
  tl_real *given = tl_push(cx, (size_t)count);
  if (!given) return;
  r->model->holonomic[0].jet(cx, given, q, qd, t, r->params);
  for (int i = 0; i < r->rows; i++) tl_scale(cx, out + i * nc, given + r->from[i] * nc, r->scale[i]);
  tl_pop(cx, (size_t)count);
}

eom_model rearranged_model(const rearranged *r, eom_function *list) {
  *list = (eom_function){"rearranged", "rearranged.c:1", constraint, rows, constraint_frame};
  eom_model m = {.name = r->model->name,
                 .dof = dof,
                 .params_size = sizeof *r,
                 .lagrangian = {"lagrangian", "rearranged.c:2", lagrangian, one, lagrangian_frame},
                 .holonomic = list,
                 .nholonomic = 1};
  if (r->model->force.jet) m.force = (eom_function){"force", "rearranged.c:3", force, dof, force_frame};
  return m;
}
