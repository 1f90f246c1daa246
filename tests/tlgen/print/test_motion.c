/* Motion functions of the N-pendulum in both forms, against each other and against its closed form. */
#include "eom/motion.h"
#include "taylor/finite.h"
#include "taylor/ldl.h"
#include "taylor/row.h"
#include "taylor/sincos_array.h"

#include "close.h"
#include "random.h"

#include <math.h>

enum { MOST = 20 };

struct pendulum {
  double g, mass[MOST], length[MOST];
};

#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed"
#endif
#include "printed_motion.h"

#define ROUNDING 1e-11 /* of the largest number, with matrices of condition 1e4 */

static struct pendulum rods;
static double q[MOST], qd[MOST], qdd[MOST], w[2 * MOST];
static _Alignas(64) double work[1 << 16];

static void draw(void) {
  rng r = {7};
  rods.g = 9.81;
  for (int i = 0; i < MOST; i++) {
    rods.mass[i] = rng_uniform(&r, 0.5, 1.5);
    rods.length[i] = rng_uniform(&r, 0.5, 1.5);
    q[i] = rng_uniform(&r, -1.5, 1.5);
    qd[i] = rng_uniform(&r, -1, 1);
    qdd[i] = rng_uniform(&r, -1, 1);
  }
  for (int i = 0; i < 2 * MOST; i++) w[i] = rng_uniform(&r, -1, 1);
}

static double largest(const double *x, int n) {
  double most = 0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs(x[i]));
  return most;
}

static void assert_near(const double *actual, const double *expected, int n) {
  assert_all_close(actual, expected, n, 0, ROUNDING * largest(expected, n));
}

/* M_ij = a_max(i,j) l_i l_j cos(q_i - q_j), a_k the mass from k on. */
static double mass_matrix(int n, int i, int j) {
  double below = 0;
  for (int k = i > j ? i : j; k < n; k++) below += rods.mass[k];
  return below * rods.length[i] * rods.length[j] * cos(q[i] - q[j]);
}

typedef struct results {
  double M[MOST * MOST], Q[MOST], r[MOST], momentum[MOST], rate[MOST], lagrangian, energy, solved[MOST], r_y[2 * MOST * MOST], qdd_y[2 * MOST * MOST];
  double r_w[MOST], dqdd[MOST];
} results;

static results in_registers, in_rows;

static void check(int n) {
  const results *a = &in_registers, *b = &in_rows;
  double expected[MOST * MOST] = {0}, residual[MOST] = {0};
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) expected[i * n + j] = mass_matrix(n, i, j);
  assert_near(a->M, expected, n * n);
  assert_near(b->M, expected, n * n);
  assert_near(b->Q, a->Q, n);
  for (int i = 0; i < n; i++) {
    residual[i] = -a->Q[i];
    for (int j = 0; j < n; j++) residual[i] += a->M[i * n + j] * qdd[j];
  }
  assert_near(a->r, residual, n);
  assert_near(b->r, residual, n);
  assert_near(b->momentum, a->momentum, n);
  assert_near(b->rate, a->rate, n);
  assert_close(b->lagrangian, a->lagrangian, ROUNDING, 0);
  assert_close(b->energy, a->energy, ROUNDING, 0);
  assert_near(b->solved, a->solved, n);
  assert_near(b->r_y, a->r_y, 2 * n * n);
  assert_near(b->qdd_y, a->qdd_y, 2 * n * n);
  double r_w[MOST] = {0}, dqdd[MOST] = {0};
  for (int i = 0; i < n; i++)
    for (int j = 0; j < 2 * n; j++) {
      r_w[i] += a->r_y[i * 2 * n + j] * w[j];
      dqdd[i] += a->qdd_y[i * 2 * n + j] * w[j];
    }
  assert_near(a->r_w, r_w, n);
  assert_near(b->r_w, r_w, n);
  assert_near(a->dqdd, dqdd, n);
  assert_near(b->dqdd, dqdd, n);
}

#define EVALUATE(name, to)                                                                                                             \
  do {                                                                                                                                 \
    assert_true(name##_work <= (int)(sizeof work / sizeof *work));                                                                     \
    eom_parts parts = {.M = (to)->M, .Q = (to)->Q};                                                                                    \
    assert_int_equal(name##_simulate(&rods, q, qd, 0, &parts, work), 0);                                                               \
    assert_int_equal(name##_residual(&rods, q, qd, 0, qdd, (to)->r, work), 0);                                                         \
    assert_int_equal(name##_energy(&rods, q, qd, 0, (to)->momentum, (to)->rate, &(to)->lagrangian, &(to)->energy, work), 0);           \
    assert_int_equal(name##_linearise(&rods, q, qd, 0, qdd, NULL, (to)->r_y, NULL, work), 0);                                          \
    assert_int_equal(name##_tangent(&rods, q, qd, 0, qdd, NULL, 1, w, (to)->r_w, NULL, work), 0);                                      \
    assert_int_equal(name##_acceleration(&rods, q, qd, 0, (to)->solved, work), 0);                                                     \
    assert_int_equal(name##_jacobian(&rods, q, qd, 0, (to)->solved, (to)->qdd_y, work), 0);                                            \
    assert_int_equal(name##_directional(&rods, q, qd, 0, 1, w, (to)->solved, (to)->dqdd, work), 0);                                    \
  } while (0)

#define TEST(n)                                                                                                                        \
  static void test_##n(void **state) {                                                                                                 \
    (void)state;                                                                                                                       \
    draw();                                                                                                                            \
    EVALUATE(registers##n, &in_registers);                                                                                             \
    EVALUATE(rows##n, &in_rows);                                                                                                       \
    check(n);                                                                                                                          \
  }

TEST(1)
TEST(3)
TEST(9)
TEST(20)

/* Directions stand side by side in w and in the results. */
static void test_directions(void **state) {
  (void)state;
  draw();
  double both[12], one[2 * 3], solved[3], dqdd[6], first[3], second[3];
  for (int i = 0; i < 6; i++) both[2 * i] = w[i], both[2 * i + 1] = w[i + 6];
  assert_int_equal(registers3_directional(&rods, q, qd, 0, 2, both, solved, dqdd, work), 0);
  for (int i = 0; i < 6; i++) one[i] = w[i + 6];
  assert_int_equal(registers3_directional(&rods, q, qd, 0, 1, w, solved, first, work), 0);
  assert_int_equal(registers3_directional(&rods, q, qd, 0, 1, one, solved, second, work), 0);
  for (int i = 0; i < 3; i++) {
    assert_close(dqdd[2 * i], first[i], ROUNDING, 0);
    assert_close(dqdd[2 * i + 1], second[i], ROUNDING, 0);
  }
}

/* Overflow and a mass matrix that is not positive definite are told apart. */
static void test_failures(void **state) {
  (void)state;
  draw();
  double solved[3];
  qd[1] = 1e200;
  assert_int_equal(registers3_acceleration(&rods, q, qd, 0, solved, work), EOM_MOTION_NOT_FINITE);
  draw();
  rods.mass[2] = -1;
  assert_int_equal(registers3_acceleration(&rods, q, qd, 0, solved, work), EOM_MOTION_PIVOT);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_1),  cmocka_unit_test(test_3),          cmocka_unit_test(test_9),
                                     cmocka_unit_test(test_20), cmocka_unit_test(test_directions), cmocka_unit_test(test_failures)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
