/* Eigenvalues and mode shapes in minimal coordinates against closed forms, the whole way from plain C. */
#include "bricard.h"
#include "bricard_tl.h"
#include "cartesian_pendulum.h"
#include "cartesian_pendulum_tl.h"
#include "chaplygin_tl.h"
#include "close.h"
#include "conical_tl.h"
#include "crane_tl.h"
#include "disk_tl.h"
#include "evaluation.h"
#include "linear_models.h"
#include "sleeping_tl.h"
#include "top_tl.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>

/* Simple eigenvalues, relative to the largest: hundreds of roundings times their condition. */
#define EIGENVALUE_TOLERANCE 1e-12

/* A zero eigenvalue of a coordinate and its velocity is double and has one shape: it moves by the root of a rounding. */
#define DOUBLE_ZERO 1e-6

static const double g = 9.81;

typedef struct analysis {
  eom_system *sys;
  eom_minimal minimal;
  eom_mode *modes;
  double *shapes;
  void *memory;
} analysis;

static void *claim(size_t bytes) {
  void *memory = malloc(bytes);
  assert_non_null(memory);
  return memory;
}

/* At a state that satisfies the constraints already. */
static analysis analyse(const eom_model *model, const void *params, const double *q, const double *qd) {
  analysis a;
  assert_int_equal(eom_system_create(&a.sys, model, params, NULL), EOM_OK);
  const size_t bytes = eom_minimal_bytes(a.sys), d = 2 * (size_t)a.sys->n;
  a.memory = claim(bytes), a.modes = claim(d * sizeof *a.modes), a.shapes = claim(2 * d * d * sizeof(double));
  assert_int_equal(eom_linearise_minimal(a.sys, &a.minimal, q, qd, 0, a.memory, bytes), EOM_OK);
  double *work = claim(eom_modes_work((int)d) * sizeof *work);
  assert_int_equal(eom_minimal_modes(a.modes, a.shapes, &a.minimal, work), EOM_OK);
  free(work);
  return a;
}

static void finish(analysis *a) {
  free(a->memory), free(a->modes), free(a->shapes);
  eom_system_destroy(a->sys);
}

/* A line of the table of measured errors: of nonzero eigenvalues, in parts of the largest rate of the motion. */
static void tell(const char *what, int states, double error) { print_message("%-18s %3d states  %.1e\n", what, states, error); }

/* The 2 count eigenvalues +- i omega, and before them as many zeros as there are others. omega: ascending. */
static void assert_frequencies(const char *what, const analysis *a, const double *omega, int count) {
  const int d = a->minimal.d, zeros = d - 2 * count;
  const double largest = omega[count - 1];
  double worst = 0;
  for (int i = 0; i < zeros; i++) assert_close(hypot(a->modes[i].re, a->modes[i].im), 0, 0, DOUBLE_ZERO * largest);
  for (int i = zeros; i < d; i++) {
    const double truth = (i - zeros) % 2 ? -omega[(i - zeros) / 2] : omega[(i - zeros) / 2];
    assert_close(a->modes[i].im, truth, 0, EIGENVALUE_TOLERANCE * largest);
    assert_close(a->modes[i].re, 0, 0, EIGENVALUE_TOLERANCE * largest);
    assert_close(a->modes[i].frequency, fabs(truth) / 6.283185307179586477, 0, EIGENVALUE_TOLERANCE * largest);
    worst = fmax(worst, hypot(a->modes[i].re, a->modes[i].im - truth) / largest);
  }
  tell(what, d, worst);
}

static cartesian_pendulum chain_of(int links) {
  cartesian_pendulum p = {.links = links, .coordinates = 2 * links, .g = g};
  for (int i = 0; i < links; i++) p.mass[i] = 1, p.length[i] = 1;
  return p;
}

static analysis analyse_hanging(const cartesian_pendulum *p) {
  double q[2 * CARTESIAN_PENDULUM_MAX_LINKS] = {0}, qd[2 * CARTESIAN_PENDULUM_MAX_LINKS] = {0}, y = 0;
  for (int i = 0; i < p->links; i++) q[2 * i + 1] = y -= p->length[i];
  return analyse(&cartesian_pendulum_model, p, q, qd);
}

/* In angles: [(m1+m2) l1^2, m2 l1 l2; ., m2 l2^2] a'' = -g [(m1+m2) l1, 0; 0, m2 l2] a. With w = omega^2/g:
 * m1 l1 l2 w^2 - (m1+m2)(l1+l2) w + (m1+m2) = 0; the lower mass moves x2/x1 = 1 + (l2/l1) a2/a1, a2/a1 = w l1/(1 - w l2). */
static void double_pendulum(void **state) {
  (void)state;
  cartesian_pendulum p = chain_of(2);
  const double m1 = p.mass[0] = 1.5, m2 = p.mass[1] = 0.4, l1 = p.length[0] = 0.7, l2 = p.length[1] = 1.9, m = m1 + m2;
  const double a = m1 * l1 * l2, b = m * (l1 + l2), root = sqrt(b * b - 4 * a * m), w[2] = {2 * m / (b + root), (b + root) / (2 * a)};
  const double omega[2] = {sqrt(g * w[0]), sqrt(g * w[1])};
  analysis s = analyse_hanging(&p);
  assert_int_equal(s.minimal.d, 4);
  assert_frequencies("double pendulum", &s, omega, 2);
  for (int k = 0; k < 2; k++) {
    const double ratio = 1 + l2 * w[k] / (1 - w[k] * l2), largest = fmax(1, fabs(ratio)), sign = fabs(ratio) > 1 && ratio < 0 ? -1 : 1;
    const double *re = s.shapes + 2 * k * 16, *im = re + 8; /* re, im of (x1, y1, x2, y2) and their rates: rates are i omega shape */
    const double x1 = sign / largest, x2 = sign * ratio / largest;
    const double truth[8] = {x1, 0, x2, 0, 0, 0, 0, 0}, rates[8] = {0, 0, 0, 0, omega[k] * x1, 0, omega[k] * x2, 0};
    assert_all_close(re, truth, 8, 0, 1e-12 * omega[1]), assert_all_close(im, rates, 8, 0, 1e-12 * omega[1]);
    assert_close(s.modes[2 * k].damping, 0, 0, EIGENVALUE_TOLERANCE);
    assert_true(s.modes[2 * k].condition >= 0.999 && s.modes[2 * k].condition < 10);
  }
  finish(&s);
}

/* L_n and its derivative by the recurrence (k+1) L_k+1 = (2k+1-x) L_k - k L_k-1, x L_n' = n (L_n - L_n-1). */
static double laguerre(int n, double x, double *slope) {
  double before = 1, now = 1 - x;
  for (int k = 1; k < n; k++) {
    const double next = ((2 * k + 1 - x) * now - k * before) / (k + 1);
    before = now, now = next;
  }
  *slope = n * (now - before) / x;
  return now;
}

/* Equal masses on equal links: omega^2 = (g/l) x with L_N(x) = 0. Each eigenvalue is near a zero: the Newton step from there is
 * rounding; and as they differ from each other, they are all zeros. */
static void hanging_chain(void **state) {
  (void)state;
  static const int sizes[] = {1, 3, 8, 20};
  for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    const int N = sizes[i];
    const cartesian_pendulum p = chain_of(N);
    analysis a = analyse_hanging(&p);
    assert_int_equal(a.minimal.d, 2 * N);
    const double largest = a.modes[2 * N - 1].frequency * 6.283185307179586477;
    double worst = 0;
    for (int k = 0; k < N; k++) {
      const double omega = a.modes[2 * k].im, x = omega * omega / g;
      double slope;
      const double value = laguerre(N, x, &slope), off = g * value / slope / (2 * omega);
      assert_close(off, 0, 0, EIGENVALUE_TOLERANCE * largest);
      worst = fmax(worst, fabs(off) / largest);
      if (k > 0) assert_true(omega - a.modes[2 * k - 2].im > 1e-3);
    }
    tell("hanging chain", 2 * N, worst);
    finish(&a);
  }
}

/* At half angle a: spin Omega^2 = g/(l cos a), small motions of a: omega^2 = Omega^2 (1 + 3 cos^2 a). */
static void conical_pendulum(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.8, .length = 1.3, .gravity = g};
  const double a = 0.6, spin = sqrt(g / (p.length * cos(a))), omega = spin * sqrt(1 + 3 * cos(a) * cos(a));
  const double q[3] = {p.length * sin(a), 0.2, -p.length * cos(a)}, qd[3] = {0, spin, 0};
  analysis s = analyse(&conical_model, &p, q, qd);
  assert_int_equal(s.minimal.d, 4);
  assert_frequencies("conical pendulum", &s, &omega, 1);
  finish(&s);
}

/* Regular precession at rate P and inclination a, spin as M g l sin a = P sin a (I3 w3 - I1 P cos a); nutation
 * omega^2 = P^2 - 2 (mgl/I1) cos a + (mgl/(I1 P))^2. */
static void nutation(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.5, .length = 0.1, .gravity = g, .across = 4e-4, .along = 7e-4};
  const double I1 = p.across + p.mass * p.length * p.length, torque = p.mass * g * p.length, a = 0.7, P = 3.0;
  const double w3 = (torque + I1 * P * P * cos(a)) / (p.along * P);
  const double omega = sqrt(P * P - 2 * torque / I1 * cos(a) + pow(torque / (I1 * P), 2));
  const double q[5] = {p.length * sin(a), p.length * cos(a), 0.3, a, 1.1}, qd[5] = {0, 0, P, 0, w3 - P * cos(a)};
  analysis s = analyse(&top_model, &p, q, qd);
  assert_int_equal(s.minimal.d, 6);
  assert_frequencies("nutation", &s, &omega, 1);
  finish(&s);
}

/* Upright: I1 s^2 -+ i I3 w s - mgl = 0. Fast, both roots are frequencies; slow, it falls at a rate sqrt(4 I1 mgl - I3^2 w^2)/(2 I1).
 */
static void sleeping_top(void **state) {
  (void)state;
  linear_model p = {.mass = 0.5, .length = 0.1, .gravity = g, .across = 5.4e-3, .along = 7e-4};
  const double torque = p.mass * g * p.length, critical = sqrt(4 * p.across * torque) / p.along;
  const double q[3] = {0, 0, 1}, qd[3] = {0, 0, 0};
  p.spin = 1.5 * critical;
  const double H = p.along * p.spin, root = sqrt(H * H - 4 * p.across * torque);
  const double omega[2] = {(H - root) / (2 * p.across), (H + root) / (2 * p.across)};
  analysis fast = analyse(&sleeping_model, &p, q, qd);
  assert_frequencies("sleeping top", &fast, omega, 2);
  finish(&fast);
  p.spin = 0.8 * critical;
  const double h = p.along * p.spin, rate = sqrt(4 * p.across * torque - h * h) / (2 * p.across), turn = h / (2 * p.across);
  analysis slow = analyse(&sleeping_model, &p, q, qd);
  for (int i = 0; i < 4; i++) {
    assert_close(fabs(slow.modes[i].re), rate, EIGENVALUE_TOLERANCE, 0);
    assert_close(fabs(slow.modes[i].im), turn, EIGENVALUE_TOLERANCE, 0);
    assert_close(slow.modes[i].damping, -slow.modes[i].re / hypot(rate, turn), EIGENVALUE_TOLERANCE, 0);
  }
  finish(&slow);
}

/* Upright and straight: 5 lean'' = -(12 w^2 - 4 g/r) lean, so that it is stable from w^2 = g/(3 r) up. */
static void rolling_disk(void **state) {
  (void)state;
  const linear_model p = {.mass = 1.7, .length = 0.4, .gravity = g};
  const double threshold = sqrt(g / (3 * p.length));
  const double q[5] = {0.3, -0.2, 0.5, 0, 0.9};
  for (int fast = 0; fast < 2; fast++) {
    const double w = threshold * (fast ? 1.01 : 0.99), qd[5] = {p.length * w * cos(0.5), p.length * w * sin(0.5), 0, 0, w};
    const double square = (12 * w * w - 4 * g / p.length) / 5, rate = sqrt(fabs(square));
    analysis a = analyse(&disk_model, &p, q, qd);
    assert_int_equal(a.minimal.d, 8);
    int found = 0;
    double worst = 0;
    for (int i = 0; i < 8; i++) {
      const double s = fast ? a.modes[i].im : a.modes[i].re, other = fast ? a.modes[i].re : a.modes[i].im;
      if (fabs(s) < rate / 2) continue;
      assert_close(fabs(s), rate, 0, 1e-10), assert_close(other, 0, 0, 1e-10); /* beside six zeros of w = 2.8 1/s */
      worst = fmax(worst, hypot(fabs(s) - rate, other) / w);
      found++;
    }
    tell(fast ? "disk, stable" : "disk, unstable", 8, worst);
    assert_int_equal(found, 2);
    finish(&a);
  }
}

/* Straight at speed u: heading rate falls at m a u/(I + m a^2), all else stays. */
static void chaplygin_sleigh(void **state) {
  (void)state;
  const linear_model p = {.mass = 2, .length = 0.25, .across = 0.3};
  const double u = 1.5, rate = p.mass * p.length * u / (p.across + p.mass * p.length * p.length);
  const double q[3] = {0.1, 0.2, 0.7}, qd[3] = {u * cos(0.7), u * sin(0.7), 0};
  analysis a = analyse(&chaplygin_model, &p, q, qd);
  assert_int_equal(a.minimal.d, 5);
  int fallen = 0, still = 0;
  double nearest = 1;
  for (int i = 0; i < 5; i++) {
    nearest = fmin(nearest, fabs(a.modes[i].re + rate) / rate);
    if (fabs(a.modes[i].re + rate) < EIGENVALUE_TOLERANCE * rate && a.modes[i].im == 0 && a.modes[i].damping == 1) fallen++;
    if (hypot(a.modes[i].re, a.modes[i].im) < DOUBLE_ZERO * rate) still++;
  }
  tell("Chaplygin's sleigh", 5, nearest);
  assert_int_equal(fallen, 1), assert_int_equal(still, 4);
  finish(&a);
}

/* Bricard's mechanism hangs by 24 rows of which 23 count, only where they hold, and its axes have no inertia: one oscillation. Let go a
 * little beside its equilibrium it passes through that after a quarter of the period, to the square of the amplitude. */
static void bricard_mechanism(void **state) {
  (void)state;
  enum { N = BRICARD_COORDINATES };
  const double amplitude = 1e-4;
  const bricard p = bricard_parameters();
  double q[N], qd[N], y[2 * N] = {0}, swing = 0;
  bricard_start(q, qd);
  evaluation f = evaluation_start(&bricard_model, &p, NULL, eom_equilibrium_bytes);
  eom_equilibrium e = {0};
  eom_mode modes[2];
  double shapes[2 * 2 * 2 * N], *work = claim(eom_modes_work(2 * N) * sizeof *work);
  assert_int_equal(eom_find_equilibrium(f.sys, q, qd, 0, &e, f.memory, f.bytes), EOM_OK);
  assert_int_equal(f.sys->report.rank, 23);
  assert_int_equal(e.linear.d, 2);
  assert_int_equal(eom_minimal_modes(modes, shapes, &e.linear, work), EOM_OK);
  assert_true(modes[0].im > 0 && fabs(modes[0].re) < EIGENVALUE_TOLERANCE);
  for (int i = 0; i < N; i++) y[i] = q[i] + amplitude * shapes[i];
  assert_int_equal(eom_project(f.sys, y, y + N, 0, NULL), EOM_OK);
  const double quarter = 1 / (4 * modes[0].frequency);
  double *steps = claim(eom_integrator_size(&eom_dp5, 2 * N) * sizeof *steps);
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, eom_rhs, f.sys, 2 * N, 0, y, quarter / 40, steps);
  it.correct = eom_project_state;
  assert_int_equal(eom_integrate(&it, quarter, NULL, NULL), EOM_OK);
  for (int i = 0; i < N; i++) {
    assert_close(it.y[i], q[i], 0, 10 * amplitude * amplitude);
    swing = fmax(swing, fabs(it.y[N + i]));
  }
  assert_close(swing, amplitude * modes[0].im, 1e-3, 0);
  free(steps), free(work);
  evaluation_stop(&f);
}

/* A push on the cart at rest moves the cart by 1/M and leaves the mass below where it is: Z B = (0, 0, 0, 1/M, 0, 0). */
static void inputs_in_minimal_coordinates(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.6, .length = 1.1, .gravity = g, .cart = 2.5};
  const double q[3] = {0.4, 0.4, -p.length}, qd[3] = {0, 0, 0};
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_PARAMETERS;
  eom_system *sys;
  eom_minimal m;
  assert_int_equal(eom_system_create(&sys, &crane_model, &p, &options), EOM_OK);
  const size_t bytes = eom_minimal_bytes(sys);
  void *memory = claim(bytes);
  double qdd_p[3], lambda_p[1], B[4];
  assert_int_equal(eom_linearise_minimal(sys, &m, q, qd, 0, memory, bytes), EOM_OK);
  assert_int_equal(eom_parameter_derivatives(sys, qdd_p, lambda_p, q, qd, 0), EOM_OK);
  eom_minimal_inputs(&m, B, sys->motion->np, qdd_p);
  assert_int_equal(m.d, 4);
  for (int k = 0; k < 4; k++)
    assert_int_equal(m.coordinate[k], k % 2); /* cart, then the load's x: the first of those that move freely */
  for (int i = 0; i < 6; i++) {
    double sum = 0;
    for (int k = 0; k < 4; k++) sum += m.Z[i * 4 + k] * B[k];
    assert_close(sum, i == 3 ? 1 / p.cart : 0, 0, 1e-15);
  }
  free(memory);
  eom_system_destroy(sys);
}

/* A matrix by itself: an oscillator with its closed forms, a double eigenvalue with one shape, and what is not finite. */
static void modes_of_a_matrix(void **state) {
  (void)state;
  eom_mode mode[2];
  double shape[8], *work = claim(eom_modes_work(2) * sizeof *work);
  const double damping = 0.3, w = 4, oscillator[4] = {0, 1, -w * w, -2 * damping * w}, block[4] = {3, 1, 0, 3};
  const double apart[4] = {-2, 0, 0, -3}, still[4] = {0, 1, 0, 0}, turning[4] = {0, 0.2, -0.2, 0}, broken[4] = {(double)NAN, 1, 0, 0};
  assert_int_equal(eom_modes(mode, shape, 2, oscillator, work), EOM_OK);
  for (int i = 0; i < 2; i++) {
    const double im = (i == 0 ? 1 : -1) * w * sqrt(1 - damping * damping);
    assert_close(mode[i].re, -damping * w, 1e-14, 0), assert_close(mode[i].im, im, 1e-14, 0);
    assert_close(mode[i].damping, damping, 1e-14, 0);
    const double *v = shape + 4 * i; /* (1/s, 1), the rate being larger: 1/s = conj(s)/w^2 */
    assert_close(v[0], -damping / w, 1e-14, 0), assert_close(v[2], -im / (w * w), 1e-14, 0);
    assert_true(v[1] == 1 && v[3] == 0);
  }
  assert_int_equal(eom_modes(mode, NULL, 2, block, work), EOM_OK);
  assert_close(mode[0].re, 3, 1e-7, 0), assert_true(mode[0].condition > 1e7);
  assert_int_equal(eom_modes(mode, shape, 2, apart, work), EOM_OK);
  const double real[8] = {0, 1, 0, 0, 1, 0, 0, 0}; /* -3 before -2 */
  assert_all_close(shape, real, 8, 0, 0);
  for (int i = 0; i < 2; i++) assert_true(mode[i].re == i - 3 && mode[i].im == 0 && mode[i].damping == 1 && mode[i].frequency == 0);
  assert_int_equal(eom_modes(mode, NULL, 2, still, work), EOM_OK);
  assert_true(mode[0].re == 0 && mode[0].damping == 0);
  assert_int_equal(eom_modes(mode, shape, 2, turning, work), EOM_OK);
  assert_close(mode[0].im, 0.2, 1e-15, 0), assert_close(mode[1].im, -0.2, 1e-15, 0);
  const double circle[8] = {1, 0, 0, 1, 1, 0, 0, -1}; /* (1, +-i) */
  assert_all_close(shape, circle, 8, 0, 1e-15);
  for (int i = 0; i < 2; i++) assert_close(mode[i].condition, 1, 1e-14, 0), assert_close(mode[i].damping, 0, 0, 1e-15);
  assert_int_equal(eom_modes(mode, shape, 2, broken, work), EOM_NOT_FINITE);
  free(work);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(double_pendulum),   cmocka_unit_test(hanging_chain),     cmocka_unit_test(conical_pendulum),
      cmocka_unit_test(nutation),          cmocka_unit_test(sleeping_top),      cmocka_unit_test(rolling_disk),
      cmocka_unit_test(chaplygin_sleigh),  cmocka_unit_test(bricard_mechanism), cmocka_unit_test(inputs_in_minimal_coordinates),
      cmocka_unit_test(modes_of_a_matrix),
  };
  return cmocka_run_group_tests_name("modes", tests, NULL, NULL);
}
