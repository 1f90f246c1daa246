/* Rows that a model function leaves unwritten: no force, and an error elsewhere. Nothing of an earlier evaluation may show through. */
#include "close.h"

#include "eom/eom.h"
#include "taylor/taylor.h"

#define ROUNDING 1e-15 /* the numbers are small integers */

static int two(const void *params) { return (void)params, 2; }
static int one(const void *params) { return (void)params, 1; }
static size_t frame(const void *params) { return (void)params, 2; }

/* L = (qd0^2 + qd1^2)/2 - q0 q1 */
static void lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)t, (void)params;
  const ptrdiff_t nc = cx->shape->ncoef;
  tl_real *const square = tl_push(cx, 2), *const other = square + nc;
  if (!square) return;
  tl_mul(cx, square, qd, qd);
  tl_mul(cx, other, qd + nc, qd + nc);
  tl_add(cx, square, square, other);
  tl_scale(cx, square, square, TL_C(0.5));
  tl_mul(cx, other, q, q + nc);
  tl_sub(cx, out, square, other);
  tl_pop(cx, 2);
}

/* Gamma_0 = -qd0, and nothing for the second coordinate. */
static void drag(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)q, (void)t, (void)params;
  tl_neg(cx, out, qd);
}

/* phi_0 = q0 - q1, and phi_1 forgotten. */
static void half_a_constraint(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)qd, (void)t, (void)params;
  tl_sub(cx, out, q, q + cx->shape->ncoef);
}

static const double q[2] = {0.3, 0.4}, qd[2] = {0.5, 0.6};

static void unwritten_force_is_zero(void **state) {
  (void)state;
  const eom_model model = {
      .name = "m", .dof = two, .lagrangian = {"L", "m.c:1", lagrangian, one, frame}, .force = {"F", "m.c:2", drag, two, frame}};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_OK);
  const double truth[8] = {0, -1, -1, 0, -1, 0, 0, 0};
  for (int again = 0; again < 2; again++) {
    assert_int_equal(eom_linearise(sys, q, qd, 0), EOM_OK);
    assert_all_close(sys->qdd_y, truth, 8, 0, ROUNDING);
  }
  eom_system_destroy(sys);
}

static void unwritten_constraint_is_named(void **state) {
  (void)state;
  const eom_function phi = {"phi", "m.c:3", half_a_constraint, two, frame};
  const eom_model model = {
      .name = "m", .dof = two, .lagrangian = {"L", "m.c:1", lagrangian, one, frame}, .holonomic = &phi, .nholonomic = 1};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_OK);
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_NOT_FINITE);
  assert_string_equal(sys->report.function, "phi");
  assert_string_equal(sys->report.source, "m.c:3");
  assert_int_equal(sys->report.index, 1);
  eom_system_destroy(sys);
}

static void missing_parameters_are_said(void **state) {
  (void)state;
  const eom_model model = {.name = "m", .dof = two, .params_size = 8, .lagrangian = {"L", "m.c:1", lagrangian, one, frame}};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_NO_PARAMS);
  assert_null(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(unwritten_force_is_zero),
      cmocka_unit_test(unwritten_constraint_is_named),
      cmocka_unit_test(missing_parameters_are_said),
  };
  return cmocka_run_group_tests_name("rows", tests, NULL, NULL);
}
