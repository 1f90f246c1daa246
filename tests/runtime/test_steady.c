/* Steady motions against closed forms, the whole way from plain C: what a given rate needs is found, what is ignorable stays. */
#include "close.h"
#include "conical_tl.h"
#include "crane_tl.h"
#include "disk_tl.h"
#include "evaluation.h"
#include "flyball.h"
#include "flyball_tl.h"
#include "hoop.h"
#include "hoop_tl.h"
#include "linear_models.h"
#include "pendulum.h"
#include "pendulum_tl.h"
#include "random.h"
#include "sleeping_tl.h"
#include "top_tl.h"

#include "eom/eom.h"

#include <math.h>

/* Places and rates of order 1 at which forces of order 10 balance. */
#define STEADY 1e-12

/* Where an acceleration is the square of what is looked for. */
#define HALF_THE_DIGITS 1e-6

static const double g = 9.81;

static eom_equilibrium find(const eom_model *model, const void *params, double *q, double *qd, double t, const unsigned char *keep_q,
                            const unsigned char *keep_qd, eom_status expected) {
  evaluation f = evaluation_start(model, params, NULL, eom_equilibrium_bytes);
  eom_equilibrium e = {.keep_q = keep_q, .keep_qd = keep_qd};
  assert_int_equal(eom_find_equilibrium(f.sys, q, qd, t, &e, f.memory, f.bytes), expected);
  evaluation_stop(&f);
  return e; /* all but its linear model */
}

/* Any link up or down, from anywhere: though their accelerations depend on each other, only torques have to vanish. */
static void chain(void **state) {
  (void)state;
  enum { LINKS = 6, TRIES = 50 };
  struct pendulum p = {.n = LINKS, .g = g};
  rng r = {1};
  for (int i = 0; i < LINKS; i++) p.mass[i] = 1 + i, p.length[i] = 1.5 / (1 + i);
  for (int k = 0; k < TRIES; k++) {
    double q[LINKS], qd[LINKS] = {0};
    for (int i = 0; i < LINKS; i++) q[i] = rng_uniform(&r, -3, 3);
    const eom_equilibrium e = find(&pendulum_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
    for (int i = 0; i < LINKS; i++) assert_close(sin(q[i]), 0, 0, STEADY);
    assert_true(e.steps < 25);
  }
}

/* The bead rises to cos a = g/(r w^2), from either side; below w^2 = g/r the bottom is all there is. */
static void rotating_hoop(void **state) {
  (void)state;
  struct hoop p = {.mass = 0.2, .radius = 0.5, .gravity = g, .spin = 6, .ramp = 1};
  for (int k = 1; k < 5; k++) {
    double q[1] = {0.3 * k + 0.3}, qd[1] = {0};
    find(&hoop_model, &p, q, qd, 2, NULL, NULL, EOM_OK);
    assert_close(cos(q[0]), g / (p.radius * p.spin * p.spin), STEADY, 0);
  }
  p.spin = 4;
  double q[1] = {0.4}, qd[1] = {0};
  find(&hoop_model, &p, q, qd, 2, NULL, NULL, EOM_OK);
  assert_close(q[0], 0, 0, STEADY);
}

/* Rate kept: cos a = g/(l W^2). Place kept, rate free: W^2 = g/(l cos a). The ignorable turn stays. */
static void conical_pendulum(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.8, .length = 1.3, .gravity = g};
  const double W = 3.5, a = 0.5;
  double q[3] = {0.9, 0.7, -0.9}, qd[3] = {0, W, 0};
  find(&conical_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
  assert_close(-q[2] / p.length, g / (p.length * W * W), STEADY, 0);
  assert_close(q[1], 0.7, 1e-15, 0);
  assert_true(qd[0] == 0 && qd[1] == W && qd[2] == 0);
  const unsigned char place[3] = {1, 1, 1}, rates[3] = {1, 0, 1};
  double x[3] = {p.length * sin(a), 0.7, -p.length * cos(a)}, v[3] = {0, 1, 0};
  const eom_equilibrium e = find(&conical_model, &p, x, v, 0, place, rates, EOM_OK);
  assert_close(v[1], sqrt(g / (p.length * cos(a))), STEADY, 0);
  assert_true(x[0] == p.length * sin(a) && e.most_qd == 1 && e.most_q == -1 && e.steps > 0);
}

/* Whatever the mass: places are found as well, and what is beside the constraint by a part of 1e-6 is refused, by 1e-10 not. */
static void any_unit_of_mass(void **state) {
  (void)state;
  for (double mass = 1e-8; mass < 2e8; mass *= 1e4) {
    const linear_model p = {.mass = mass, .length = 1.3, .gravity = g};
    double q[3] = {0.9, 0.7, -0.9}, qd[3] = {0, 3.5, 0};
    const eom_equilibrium e = find(&conical_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
    assert_close(-q[2] / p.length, g / (p.length * 3.5 * 3.5), STEADY, 0);
    assert_true(e.steps < 12);
    evaluation m = evaluation_start(&conical_model, &p, NULL, eom_minimal_bytes);
    eom_minimal linear;
    const double places[2][3] = {{q[0] * (1 + 1e-10), q[1], q[2]}, {q[0] * (1 + 1e-6), q[1], q[2]}};
    const double rates[2][3] = {{1e-10, 3.5, 0}, {1e-6, 3.5, 0}};
    for (int off = 0; off < 2; off++) {
      const eom_status status = off ? EOM_OFF_CONSTRAINTS : EOM_OK;
      assert_int_equal(eom_linearise_minimal(m.sys, &linear, places[off], qd, 0, m.memory, m.bytes), status);
      assert_int_equal(eom_linearise_minimal(m.sys, &linear, q, rates[off], 0, m.memory, m.bytes), status);
    }
    evaluation_stop(&m);
  }
}

/* At a given inclination and precession P the spin: M g l = P (I3 w3 - I1 P cos a). */
static void precessing_top(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.5, .length = 0.1, .gravity = g, .across = 4e-4, .along = 7e-4};
  const double I1 = p.across + p.mass * p.length * p.length, torque = p.mass * g * p.length, a = 0.7, P = 3.0;
  const unsigned char place[5] = {1, 1, 1, 1, 1}, rates[5] = {1, 1, 1, 1, 0};
  double q[5] = {p.length * sin(a), p.length * cos(a), 0, a, 0}, qd[5] = {0, 0, P, 0, 200};
  find(&top_model, &p, q, qd, 0, place, rates, EOM_OK);
  assert_close(qd[4] + P * cos(a), (torque + I1 * P * P * cos(a)) / (p.along * P), STEADY, 0);
}

/* The axis finds the vertical, upwards from near it. */
static void sleeping_top(void **state) {
  (void)state;
  const linear_model p = {.mass = 0.5, .length = 0.1, .gravity = g, .across = 5.4e-3, .along = 7e-4, .spin = 500};
  double q[3] = {0.2, -0.1, 0.9}, qd[3] = {0};
  find(&sleeping_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
  assert_close(q[0], 0, 0, STEADY), assert_close(q[1], 0, 0, STEADY), assert_close(q[2], 1, STEADY, 0);
}

/* A governor of a given spin: arms fly out by the same angle, the slider lies at the height that its springs carry, and the balance of
 * torques about a hinge, computed here from statics, holds. */
static void flyball_governor(void **state) {
  (void)state;
  const flyball p = flyball_parameters();
  double q[FLYBALL_COORDINATES], qd[FLYBALL_COORDINATES];
  flyball_start(q, qd);
  const double spin = qd[0];
  find(&flyball_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
  assert_true(qd[0] == spin && qd[1] == 0 && q[0] == 0);
  assert_close(q[1], q[2], STEADY, 0);
  const double l = p.arm_length, c = cos(q[1]), s = sin(q[1]);
  const double out = 0.5 * l * c, up = p.hinge_height - 0.5 * l * s - q[3], length = hypot(out, up);
  const double tension = p.stiffness * (length - p.rest);
  assert_close(2 * tension * up / length, p.slider_mass * g, 1e-9, 0); /* a stretch of 2e-5 of 0.5 m: five digits go */
  const double across = p.arm_mass * (l * l + p.section * p.section) / 12, along = p.arm_mass * p.section * p.section / 6;
  const double middle = p.hinge_radius + 0.5 * l * c, end = p.hinge_radius + l * c;
  const double centrifugal = spin * spin * (0.5 * p.arm_mass * middle * l * s + p.ball_mass * end * l * s + (across - along) * c * s);
  const double weight = g * (0.5 * p.arm_mass + p.ball_mass) * l * c;
  const double spring = tension * 0.5 * l * (c * up + s * out) / length; /* pulls the arm down as gravity does */
  assert_close(centrifugal, weight + spring, 1e-9, 0);
}

/* A disk on a circle moves steadily, but not in these coordinates: its centre accelerates. */
static void circling_disk(void **state) {
  (void)state;
  const linear_model p = {.mass = 1.7, .length = 0.4, .gravity = g};
  const unsigned char place[5] = {1, 1, 1, 0, 1}, rates[5] = {0, 0, 1, 1, 1};
  const double turn = 0.8, roll = 6;
  double q[5] = {0}, qd[5] = {p.length * roll, 0, turn, 0, roll};
  find(&disk_model, &p, q, qd, 0, place, rates, EOM_NO_EQUILIBRIUM);
}

/* A cart may stand anywhere: it stays; the mass hangs. Pushed, the cart accelerates for ever. */
static void crane(void **state) {
  (void)state;
  linear_model p = {.mass = 0.6, .length = 1.1, .gravity = g, .cart = 2.5};
  double q[3] = {0.4, 0.9, -0.8}, qd[3] = {0};
  find(&crane_model, &p, q, qd, 0, NULL, NULL, EOM_OK);
  assert_close(q[1], q[0], STEADY, 0), assert_close(q[2], -p.length, STEADY, 0);
  p.push = 1;
  find(&crane_model, &p, q, qd, 0, NULL, NULL, EOM_NO_EQUILIBRIUM);
  const unsigned char none[3] = {0, 0, 0};
  double back[3] = {0.4, 0.4, -p.length}, rate[3] = {0.1, 0.1, 0};
  find(&crane_model, &p, back, rate, 0, NULL, none, EOM_NO_EQUILIBRIUM);
  assert_true(back[0] == 0.4 && back[1] == 0.4 && rate[0] == 0.1 && rate[1] == 0.1 && rate[2] == 0);
  const unsigned char cart[3] = {1, 0, 0}, all[3] = {1, 1, 1};
  double x[3] = {0.7, 0.9, -0.8}, rest[3] = {0.7, 0.7, -p.length};
  p.push = 0;
  find(&crane_model, &p, x, qd, 0, cart, NULL, EOM_OK);
  assert_true(x[0] == 0.7), assert_close(x[1], 0.7, STEADY, 0);
  p.push = 5, p.cart = 20; /* and held: what is left is what the push gives the cart */
  const eom_equilibrium e = find(&crane_model, &p, rest, qd, 0, all, NULL, EOM_NO_EQUILIBRIUM);
  assert_close(e.residual, p.push / p.cart, STEADY, 0), assert_int_equal(e.most_qdd, 0);
  p.push = 1, p.cart = 2.5;
  p.damping = 0.5; /* then it reaches a speed; that of the mass beside it lifts the mass by its square only */
  const unsigned char rates[3] = {0, 0, 1};
  find(&crane_model, &p, q, qd, 0, NULL, rates, EOM_OK);
  assert_close(qd[0], p.push / p.damping, HALF_THE_DIGITS, 0), assert_close(qd[1], qd[0], HALF_THE_DIGITS, 0);
  assert_close(q[1], q[0], STEADY, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(chain),
      cmocka_unit_test(rotating_hoop),
      cmocka_unit_test(conical_pendulum),
      cmocka_unit_test(any_unit_of_mass),
      cmocka_unit_test(precessing_top),
      cmocka_unit_test(sleeping_top),
      cmocka_unit_test(flyball_governor),
      cmocka_unit_test(circling_disk),
      cmocka_unit_test(crane),
  };
  return cmocka_run_group_tests_name("steady", tests, NULL, NULL);
}
