/* The planar N-pendulum on libtaylor calls, from the positions of its masses. */
#include "pendulum_model.h"

#include "pen.h"

/* x_k' = sum cos(q_i) q_i', y_k' = sum sin(q_i) q_i', height_k = -sum cos(q_i); L = sum (x_k'^2 + y_k'^2)/2 - g height_k. */
static void lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)t;
  const pendulum *chain = params;
  pen p = {cx, 0};
  tl_real *vx = pen_new(&p), *vy = pen_new(&p), *height = pen_new(&p), *s = pen_new(&p), *c = pen_new(&p);
  if (!c) return;
  tl_const(cx, vx, 0);
  tl_const(cx, vy, 0);
  tl_const(cx, height, 0);
  tl_const(cx, out, 0);
  for (int i = 0; i < chain->n; i++) {
    tl_sincos(cx, s, c, at(&p, q, i));
    tl_muladd(cx, vx, c, at(&p, qd, i));
    tl_muladd(cx, vy, s, at(&p, qd, i));
    tl_sub(cx, height, height, c);
    tl_mul(cx, s, vx, vx);
    tl_muladd(cx, s, vy, vy);
    tl_axpy(cx, out, TL_C(0.5), s);
    tl_axpy(cx, out, -chain->g, height);
  }
  pen_lift(&p);
}

static int dof(const void *params) { return ((const pendulum *)params)->n; }
static int one(const void *params) {
  (void)params;
  return 1;
}
static size_t frame(const void *params) {
  (void)params;
  return 5;
}

const eom_model pendulum_model = {
    .name = "pendulum",
    .dof = dof,
    .params_size = sizeof(pendulum),
    .lagrangian = {.name = "lagrangian", .source = "pendulum.c:1", .jet = lagrangian, .rows = one, .frame = frame}};
