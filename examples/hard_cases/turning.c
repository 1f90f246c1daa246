/* Scenes with more coordinates than freedoms: a singular mass matrix. */
#include "central_field.h"
#include "central_field_tl.h"
#include "elliptic.h"
#include "quaternion_top.h"
#include "quaternion_top_tl.h"
#include "scene.h"

#include <math.h>

/* ---- symmetric top let go with its axis at rest: u = cos of the tilt, a = I_along spin/I_across, b = 2 m g h/I_across,
 *   u'^2 = (u_0 - u) (b (1 - u^2) - a^2 (u_0 - u)) = b (u - u_0)(u - r_1)(u - r_3)
 *   u = r_1 + (u_0 - r_1) sn^2(K(k) - t sqrt(b (r_3 - r_1))/2),  k = (u_0 - r_1)/(r_3 - r_1)  (Landau and Lifshitz, sect. 35). */

static const quaternion_top top = {.across = 0.2, .along = 0.1, .mass = 1.0, .height = 0.3, .gravity = 9.81};
static const double tilt = 0.5, spin = 20.0;

static void top_begin(scene_start *s) {
  s->params = &top;
  quaternion_top_start(tilt, spin, s->q, s->qd);
}

static void top_measure(const double *y, double *value) { value[0] = quaternion_top_upright(y); }

static void top_truth(double t, double *value) {
  const double u0 = cos(tilt), a = top.along * spin / top.across, b = 2.0 * top.mass * top.gravity * top.height / top.across;
  const double half = 0.5 * a * a / b, root = sqrt(half * half + 1.0 - 2.0 * half * u0);
  const double r1 = half - root, r3 = half + root, k = (u0 - r1) / (r3 - r1);
  const double sn = elliptic_at(elliptic_quarter(k) - 0.5 * t * sqrt(b * (r3 - r1)), k).sn;
  value[0] = r1 + (u0 - r1) * sn * sn;
}

const scene scene_top = {.name = "top",
                         .about = "symmetric top by a quaternion: M of rank 3 of 4",
                         .model = &quaternion_top_model,
                         .begin = top_begin,
                         .duration = 20.0,
                         .quick = 2.0,
                         .outputs = 1000,
                         .method = "dop853",
                         .tolerance = 1e-12,
                         .measured = "cosine of the tilt",
                         .values = 1,
                         .measure = top_measure,
                         .truth = top_truth,
                         .floor = 1.0,
                         .required = 1e-9,
                         .energy = 1e-9};

/* ---- Kepler's problem in (r, u), from the pericentre of an ellipse of eccentricity 0.99 in the plane of (1, 0, 0) and (0, 0.8, 0.6):
 *   E - e sin E = n t,  r = a (1 - e cos E),  cos v = a (cos E - e)/r,  sin v = b sin E/r. */

static const struct central_field field = {.m = 1.0, .mu = 1.0};
static const double pericentre = 0.01, rates[2] = {1128.5388783732708, 846.404158779953};

static void kepler_begin(scene_start *s) {
  s->params = &field;
  s->q[0] = pericentre;
  s->q[1] = 1.0;
  s->qd[2] = rates[0];
  s->qd[3] = rates[1];
}

static void kepler_measure(const double *y, double *value) {
  for (int i = 0; i < 4; i++) value[i] = y[i];
}

/* By Newton's method from where it converges for every eccentricity. */
static double eccentric_anomaly(double mean, double e) {
  const double turn = 4.0 * acos(0.0), m = remainder(mean, turn);
  double E = m < 0.0 ? -2.0 * acos(0.0) : 2.0 * acos(0.0);
  for (int i = 0; i < 60; i++) E -= (E - e * sin(E) - m) / (1.0 - e * cos(E));
  return E;
}

static void kepler_truth(double t, double *value) {
  const double rate = hypot(rates[0], rates[1]), speed = pericentre * rate;
  const double a = 1.0 / (2.0 / pericentre - speed * speed / field.mu), e = 1.0 - pericentre / a;
  const double E = eccentric_anomaly(t * sqrt(field.mu / a) / a, e), r = a * (1.0 - e * cos(E));
  const double sine = a * sqrt((1.0 - e) * (1.0 + e)) * sin(E) / r;
  value[0] = r;
  value[1] = a * (cos(E) - e) / r;
  value[2] = sine * rates[0] / rate;
  value[3] = sine * rates[1] / rate;
}

/* Kinetic and potential energy at the pericentre are 200 times their sum, so rounding in some 50 steps of each of 160 passages changes
 * the energy by 2e-12 of itself, which makes 1e-8 s after 1000 s; the direction turns at 1400 rad/s there. Asked for is ten times that.
 */
const scene scene_kepler = {.name = "kepler",
                            .about = "orbit of eccentricity 0.99 in (r, u): a factor of 200 in r, and M of rank 3 of 4",
                            .model = &central_field_model,
                            .begin = kepler_begin,
                            .duration = 1000.0,
                            .quick = 20.0,
                            .outputs = 1000,
                            .method = "dop853",
                            .tolerance = 1e-14,
                            .measured = "distance and direction",
                            .values = 4,
                            .measure = kepler_measure,
                            .truth = kepler_truth,
                            .floor = 1.0,
                            .required = 1e-4,
                            .energy = 1e-8};
