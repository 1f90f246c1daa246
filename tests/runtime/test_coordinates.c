/* The linear model in the user's coordinates: a planar orbit computed in Cartesian and read in polar coordinates, at rest and turning.
 */
#include "close.h"
#include "pen.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TURN 0.7 /* rad/s: of the turning frame */

static int one(const void *params) {
  (void)params;
  return 1;
}
static int two(const void *params) {
  (void)params;
  return 2;
}
static size_t frame(const void *params) {
  (void)params;
  return 32;
}

#define ARGUMENTS tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params
#define UNUSED (void)qd, (void)t, (void)params

/* (x'^2 + y'^2)/2 + 1/sqrt(x^2 + y^2). */
static void orbit(ARGUMENTS) {
  UNUSED;
  pen p = {cx, 0};
  jet v2 = add(&p, square(&p, at(&p, qd, 0)), square(&p, at(&p, qd, 1)));
  jet r = root(&p, add(&p, square(&p, at(&p, q, 0)), square(&p, at(&p, q, 1))));
  tl_real *inverse = pen_new(&p);
  tl_rdiv(cx, inverse, 1, r);
  pen_result(&p, out, add(&p, times(&p, 0.5, v2), inverse));
  pen_lift(&p);
}

/* (r, angle - w t) of (x, y). */
static void polar(ARGUMENTS, double w) {
  UNUSED;
  pen p = {cx, 0};
  jet r = root(&p, add(&p, square(&p, at(&p, q, 0)), square(&p, at(&p, q, 1))));
  tl_real *angle = pen_new(&p);
  tl_atan2(cx, angle, at(&p, q, 1), at(&p, q, 0));
  tl_axpy(cx, angle, -w, t);
  pen_result(&p, out, r);
  pen_result(&p, row(&p, out, 1), angle);
  pen_lift(&p);
}

/* (x, y) of (r, angle - w t). */
static void cartesian(ARGUMENTS, double w) {
  UNUSED;
  pen p = {cx, 0};
  jet angle = add(&p, at(&p, q, 1), times(&p, w, t));
  pen_result(&p, out, mul(&p, at(&p, q, 0), cosine(&p, angle)));
  pen_result(&p, row(&p, out, 1), mul(&p, at(&p, q, 0), sine(&p, angle)));
  pen_lift(&p);
}

static void polar_at_rest(ARGUMENTS) { polar(cx, out, q, qd, t, params, 0); }
static void polar_turning(ARGUMENTS) { polar(cx, out, q, qd, t, params, TURN); }
static void cartesian_at_rest(ARGUMENTS) { cartesian(cx, out, q, qd, t, params, 0); }
static void cartesian_turning(ARGUMENTS) { cartesian(cx, out, q, qd, t, params, TURN); }

/* Wrong by a reflection. */
static void reflected(ARGUMENTS) {
  cartesian(cx, out, q, qd, t, params, 0);
  pen p = {cx, 0};
  tl_neg(cx, row(&p, out, 1), row(&p, out, 1));
}

/* v = q, and q = v^2: inverse at 1 in value, not in slope. */
static void identity(ARGUMENTS) {
  UNUSED;
  pen p = {cx, 0};
  for (int i = 0; i < 2; i++) tl_copy(cx, row(&p, out, i), at(&p, q, i));
}
static void squares(ARGUMENTS) {
  UNUSED;
  pen p = {cx, 0};
  for (int i = 0; i < 2; i++) tl_mul(cx, row(&p, out, i), at(&p, q, i), at(&p, q, i));
}

#define FUNCTION(label, function, count) {.name = label, .source = "orbit.c:1", .jet = function, .rows = count, .frame = frame}
static const eom_model orbit_model = {.name = "orbit", .dof = two, .lagrangian = FUNCTION("orbit", orbit, one)};

static eom_system *start(void) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &orbit_model, NULL, NULL), EOM_OK);
  return sys;
}

static eom_status linearise(eom_system *sys, const eom_coordinates *c, double *F, double *z, const double *q, const double *qd,
                            double t) {
  const size_t bytes = eom_coordinates_bytes(sys, c);
  assert_true(bytes > 0);
  void *memory = malloc(bytes);
  assert_int_equal(eom_linearise_in(sys, c, F, z, q, qd, t, memory, bytes - 1), EOM_NO_MEMORY);
  const eom_status status = eom_linearise_in(sys, c, F, z, q, qd, t, memory, bytes);
  free(memory);
  return status;
}

/* r'' = r o^2 - 1/r^2, a'' = -2 r' o/r with o = a' + w, by hand; rows 2 and 3 of F in (r, a, r', a'). */
static void polar_by_hand(const double *z, double w, double *F) {
  const double r = z[0], rd = z[2], o = z[3] + w;
  memset(F, 0, 16 * sizeof(double));
  F[0 * 4 + 2] = F[1 * 4 + 3] = 1;
  F[2 * 4 + 0] = o * o + 2 / (r * r * r);
  F[2 * 4 + 3] = 2 * r * o;
  F[3 * 4 + 0] = 2 * rd * o / (r * r);
  F[3 * 4 + 2] = -2 * o / r;
  F[3 * 4 + 3] = -2 * rd / r;
}

/* Rounding of products of a few numbers up to 30; measured 4e-15 of the largest. */
#define POLAR_TOLERANCE 1e-13

static void check(const eom_coordinates *c, double w) {
  eom_system *sys = start();
  rng r = {3};
  for (int k = 0; k < 100; k++) {
    const double q[2] = {rng_uniform(&r, -1, 1), rng_uniform(&r, 0.3, 1)}, qd[2] = {rng_uniform(&r, -1, 1), rng_uniform(&r, -1, 1)};
    const double t = rng_uniform(&r, -2, 2), r2 = q[0] * q[0] + q[1] * q[1];
    double F[16], truth[16], z[4], largest = 0;
    assert_int_equal(linearise(sys, c, F, z, q, qd, t), EOM_OK);
    assert_close(z[0], sqrt(r2), 1e-14, 0);
    assert_close(z[1], atan2(q[1], q[0]) - w * t, 1e-14, 1e-14);
    assert_close(z[2], (q[0] * qd[0] + q[1] * qd[1]) / sqrt(r2), 1e-13, 1e-14);
    assert_close(z[3], (q[0] * qd[1] - q[1] * qd[0]) / r2 - w, 1e-13, 1e-13);
    polar_by_hand(z, w, truth);
    for (int i = 0; i < 16; i++) largest = fmax(largest, fabs(truth[i]));
    assert_all_close(F, truth, 16, 0, POLAR_TOLERANCE * largest);
  }
  eom_system_destroy(sys);
}

static void polar_coordinates(void **state) {
  (void)state;
  check(&(eom_coordinates){FUNCTION("polar", polar_at_rest, two), FUNCTION("cartesian", cartesian_at_rest, two)}, 0);
}

static void turning_coordinates(void **state) {
  (void)state;
  check(&(eom_coordinates){FUNCTION("polar", polar_turning, two), FUNCTION("cartesian", cartesian_turning, two)}, TURN);
}

/* With v = q the state matrix is F itself. */
static void same_coordinates(void **state) {
  (void)state;
  eom_system *sys = start();
  const eom_coordinates c = {FUNCTION("identity", identity, two), FUNCTION("identity", identity, two)};
  const double q[2] = {0.5, 0.25}, qd[2] = {0.125, 1};
  double F[16], F_z[16];
  assert_int_equal(linearise(sys, &c, F_z, NULL, q, qd, 0), EOM_OK);
  eom_state_matrix(sys, F);
  assert_all_close(F_z, F, 16, 0, 0);
  eom_system_destroy(sys);
}

static void wrong_inverse(void **state) {
  (void)state;
  eom_system *sys = start();
  const double q[2] = {0.5, 0.25}, qd[2] = {0.125, 1}, at_one[2] = {1, 1};
  double F[16];
  const eom_coordinates mirror = {FUNCTION("polar", polar_at_rest, two), FUNCTION("reflected", reflected, two)};
  assert_int_equal(linearise(sys, &mirror, F, NULL, q, qd, 0), EOM_NOT_INVERSE);
  assert_string_equal(sys->report.function, "reflected");
  assert_int_equal(sys->report.index, 1);
  const eom_coordinates slope = {FUNCTION("identity", identity, two), FUNCTION("squares", squares, two)};
  assert_int_equal(linearise(sys, &slope, F, NULL, at_one, qd, 0), EOM_NOT_INVERSE);
  assert_int_equal(sys->report.index, 0);
  const eom_coordinates swapped = {FUNCTION("polar", polar_turning, two), FUNCTION("cartesian", cartesian_at_rest, two)};
  assert_int_equal(linearise(sys, &swapped, F, NULL, q, qd, 1), EOM_NOT_INVERSE);
  assert_int_equal(linearise(sys, &swapped, F, NULL, (const double[]){0, 0}, qd, 0), EOM_DOMAIN);
  eom_system_destroy(sys);
}

static void wrong_size(void **state) {
  (void)state;
  eom_system *sys = start();
  const eom_coordinates short_one = {FUNCTION("polar", polar_at_rest, one), FUNCTION("cartesian", cartesian_at_rest, two)};
  assert_int_equal(eom_coordinates_bytes(sys, &short_one), 0);
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(polar_coordinates), cmocka_unit_test(turning_coordinates),
                                     cmocka_unit_test(same_coordinates), cmocka_unit_test(wrong_inverse), cmocka_unit_test(wrong_size)};
  return cmocka_run_group_tests_name("coordinates", tests, NULL, NULL);
}
