/* The table of the report's scenes, and those of them that are no hard cases: orbits of Kepler's problem, and two pendulums. */
#include "scenes.h"

#include "kepler.h"
#include "kepler_tl.h"
#include "pendulum.h"
#include "pendulum2_tl.h"
#include "pendulum6_tl.h"

#include <math.h>
#include <string.h>

/* That energy is conserved is all that the report asks. */
#define conserved 1.0

/* ---- Kepler's problem in the plane, from the pericentre of an ellipse with a = 1 and the gravitational parameter 1:
 *   E - e sin E = n t,   x = a (cos E - e),   y = b sin E.
 * a and e are those of the start as it is rounded to doubles, in which 1/a = 2/r - v^2 loses digits: long double has them. */

static double circle_speed(double e) { return sqrt((1.0 + e) / (1.0 - e)); }

static void orbit_begin(scene_start *s, double e) {
  s->q[0] = 1.0 - e;
  s->qd[1] = circle_speed(e);
}

static void orbit05_begin(scene_start *s) { orbit_begin(s, 0.5); }
static void orbit99_begin(scene_start *s) { orbit_begin(s, 0.99); }

static void orbit_measure(const double *y, double *value) { value[0] = y[0], value[1] = y[1]; }

static void orbit_truth(double e0, double t, double *value) {
  const long double r = (long double)(1.0 - e0), v = (long double)circle_speed(e0), a = 1.0L / (2.0L / r - v * v), e = 1.0L - r / a;
  const long double mean = remainderl((long double)t / (a * sqrtl(a)), 4.0L * acosl(0.0L));
  long double E = mean < 0.0L ? -2.0L * acosl(0.0L) : 2.0L * acosl(0.0L); /* Newton's method converges from here for every e */
  for (int i = 0; i < 60; i++) E -= (E - e * sinl(E) - mean) / (1.0L - e * cosl(E));
  value[0] = (double)(a * (cosl(E) - e));
  value[1] = (double)(a * sqrtl((1.0L - e) * (1.0L + e)) * sinl(E));
}

static void orbit05_truth(double t, double *value) { orbit_truth(0.5, t, value); }
static void orbit99_truth(double t, double *value) { orbit_truth(0.99, t, value); }

#define ORBIT                                                                                                                          \
  .model = &kepler_model, .duration = 100.0, .outputs = 1, .measured = "place", .values = 2, .measure = orbit_measure, .floor = 1.0,   \
  .energy = conserved

static const scene orbit05 = {
    .name = "kepler05", .about = "orbit of eccentricity 0.5", .begin = orbit05_begin, .truth = orbit05_truth, ORBIT};
static const scene orbit99 = {
    .name = "kepler99", .about = "orbit of eccentricity 0.99", .begin = orbit99_begin, .truth = orbit99_truth, ORBIT};

/* ---- the paper's pendulum, its first link at 75 degrees: angles from Taylor series in 30 digits, uncertain in the 26th. */

static const struct pendulum two = {.n = 2, .g = 9.81, .mass = {1.0, 1.0}, .length = {1.0, 1.0}};
static const struct pendulum six = {
    .n = 6, .g = 9.81, .mass = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, .length = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}};

static void chain_begin(scene_start *s, const struct pendulum *p) {
  s->params = p;
  s->q[0] = 75.0 * acos(-1.0) / 180.0;
}

static void two_begin(scene_start *s) { chain_begin(s, &two); }
static void six_begin(scene_start *s) { chain_begin(s, &six); }
static void two_measure(const double *y, double *value) { memcpy(value, y, 2 * sizeof *y); }
static void six_measure(const double *y, double *value) { memcpy(value, y, 6 * sizeof *y); }

static const scene_digits two_digits[] = {{10.0, {0.47034055994908508, -1.4231163716945483}}};
static const scene_digits six_digits[] = {{5.0,
                                           {-0.2616631666180611, 0.59349454216297248, -0.049519457735305458, -0.9410828382331593,
                                            -0.038293513547839012, 0.10183382874794256}}};

#define CHAIN .outputs = 1, .measured = "angles", .ndigits = 1, .floor = 1.0, .energy = conserved

static const scene chain2 = {.name = "pendulum2",
                             .about = "the paper's pendulum of two links",
                             .model = &pendulum2_model,
                             .begin = two_begin,
                             .duration = 10.0,
                             .values = 2,
                             .measure = two_measure,
                             .digits = two_digits,
                             CHAIN};
static const scene chain6 = {.name = "pendulum6",
                             .about = "the paper's pendulum of six links",
                             .model = &pendulum6_model,
                             .begin = six_begin,
                             .duration = 5.0,
                             .values = 6,
                             .measure = six_measure,
                             .digits = six_digits,
                             CHAIN};

const precision_scene precision_scenes[] = {
    {"kepler05", "Kepler, e = 0.5, 100 s", &orbit05, 100.0, 1000.0, 500},
    {"kepler99", "Kepler, e = 0.99, 100 s", &orbit99, 100.0, 0.0, 16000},
    {"pendulum2", "Double pendulum, 10 s", &chain2, 10.0, 200.0, 100},
    {"pendulum6", "Pendulum of 6 links, 5 s", &chain6, 5.0, 100.0, 100},
    {"andrews", "Andrews' squeezing mechanism, 0.05 s", &scene_a03, 0.05, 0.0, 300},
    {"bricard", "Bricard's mechanism, 10 s", &scene_a04, 10.0, 0.0, 100},
    {"flyball", "Flyball governor, 10 s", &scene_a05, 10.0, 0.0, 50000},
    {"spring", "Pendulum on a stiff spring, 10 s", &scene_spring, 10.0, 0.0, 10000},
};
const int precision_scene_count = sizeof precision_scenes / sizeof precision_scenes[0];

const precision_scene *precision_scene_find(const char *name) {
  for (int i = 0; i < precision_scene_count; i++)
    if (strcmp(precision_scenes[i].name, name) == 0) return &precision_scenes[i];
  return NULL;
}
