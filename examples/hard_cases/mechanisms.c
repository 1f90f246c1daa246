/* Scenes of published mechanisms with closed loops and stiff parts. */
#include "andrews.h"
#include "andrews_tl.h"
#include "bricard.h"
#include "bricard_tl.h"
#include "elastic_crank.h"
#include "elastic_crank_tl.h"
#include "elliptic.h"
#include "flyball.h"
#include "flyball_tl.h"
#include "four_bars.h"
#include "four_bars2_tl.h"
#include "four_bars_tl.h"
#include "scene.h"
#include "slider_crank.h"
#include "slider_crank_tl.h"

#include <math.h>

#define DIGITS(table) .digits = (table), .ndigits = sizeof(table) / sizeof(table)[0]

/* ---- Andrews' squeezing mechanism: beta and the crank's end, from a solution in quadruple precision whose digits agree at two
 * tolerances. The digits that the Test Set publishes are off by up to 1.1e-9. */

static const scene_digits andrews_digits[] = {
    {0.005, {0.21107638590326671, 0.0068446417542537882, 0.001466587622996196}},
    {0.01, {2.160113131531527, -0.0038905523886494354, 0.0058192441185410133}},
    {0.015, {5.6554297499917947, 0.0056654344158393564, -0.0041113079281200736}},
    {0.02, {8.1849058896616764, -0.0022744209241605069, 0.0066201970861705373}},
    {0.025, {12.107149234447659, 0.0062747852495255736, -0.0031027520159265529}},
    {0.03, {15.81077119515371, -0.0069630394270468491, -0.0007183884307191237}},
    {0.035, {19.761503414451351, 0.0042854492354663194, 0.0055348825507178685}},
    {0.04, {24.375304972013357, 0.0050861989111456174, -0.0048094262273436677}},
    {0.045, {29.162549312057457, -0.0044155843390385101, -0.0054316309654502343}},
    {0.05, {33.825867766954522, -0.0052085047222967416, 0.0046766952603106973}},
};

static andrews squeezer; /* filled by andrews_begin */

static void andrews_begin(scene_start *s) {
  squeezer = andrews_parameters();
  s->params = &squeezer;
  andrews_start(s->q, s->qd);
}

static void andrews_measure(const double *y, double *value) {
  value[0] = y[0];
  value[1] = squeezer.rr * cos(y[0]);
  value[2] = squeezer.rr * sin(y[0]);
}

static double andrews_work(const double *y) { return squeezer.mom * y[0]; }

const scene scene_a03 = {.name = "A03",
                         .about = "Andrews' squeezing mechanism: seven bodies, a very small scale of time",
                         .model = &andrews_model,
                         .begin = andrews_begin,
                         .duration = 0.05,
                         .quick = 0.01,
                         .outputs = 50,
                         .method = "dop853",
                         .tolerance = 1e-12,
                         .coarsest = 1.6e-4,
                         .measured = "beta, end of the crank",
                         .values = 3,
                         .measure = andrews_measure,
                         DIGITS(andrews_digits),
                         .floor = 0.01,
                         .required = 1e-9,
                         .energy = 1e-9,
                         .work = andrews_work,
                         .source = "the published digits",
                         .published = "OpenSim 3.2 0.384 s"};

/* ---- N four-bars, which turn as one parallelogram: with f from the vertical, I f'' = G sin f, I = (N + 1)/3 + N, G = g ((N + 1)/2 +
 * N) in units of m l^2 and m l, so with w^2 = 1 + 4 G/I, the square of the rate at the bottom after 1 rad/s at the top, and k = (w^2 -
 * 1)/w^2, f = pi + 2 am(w t/2 - K(k)),  f' = w dn(w t/2 - K(k)). */

static four_bars bars2, bars40;

static void bars_begin(scene_start *s, four_bars *p, int loops) {
  *p = four_bars_parameters(loops);
  s->params = p;
  four_bars_start(p, s->q, s->qd);
}

static void bars2_begin(scene_start *s) { bars_begin(s, &bars2, 2); }
static void bars40_begin(scene_start *s) { bars_begin(s, &bars40, 40); }

/* Place and velocity of the first joint. */
static void first_joint(const four_bars *p, const double *y, double *value) {
  for (int i = 0; i < 2; i++) value[i] = y[i], value[2 + i] = y[p->coordinates + i];
}

static void bars2_measure(const double *y, double *value) { first_joint(&bars2, y, value); }
static void bars40_measure(const double *y, double *value) { first_joint(&bars40, y, value); }

static void parallelogram(const four_bars *p, double t, double *value) {
  const double inertia = (p->loops + 1) / 3.0 + p->loops, torque = p->g * ((p->loops + 1) / 2.0 + p->loops);
  const double w2 = 1.0 + 4.0 * torque / inertia, w = sqrt(w2), k = (w2 - 1.0) / w2;
  const elliptic at = elliptic_at(0.5 * w * t - elliptic_quarter(k), k);
  const double s = -sin(2.0 * at.am), c = -cos(2.0 * at.am), rate = w * at.dn;
  value[0] = s, value[1] = c, value[2] = rate * c, value[3] = -rate * s;
}

static void bars2_truth(double t, double *value) { parallelogram(&bars2, t, value); }
static void bars40_truth(double t, double *value) { parallelogram(&bars40, t, value); }

#define BARS                                                                                                                           \
  .method = "dop853", .tolerance = 1e-10, .measured = "first joint and its velocity", .values = 4, .floor = 1e-3, .required = 1e-3,    \
  .energy = 0.1, .hold = true, .source = "the benchmark"

const scene scene_a02 = {.name = "A02",
                         .about = "40 four-bars in a row: 41 freedoms at each passage of the horizontal",
                         .model = &four_bars_model,
                         .begin = bars40_begin,
                         .duration = 20.0,
                         .quick = 1.0,
                         .outputs = 400,
                         .measure = bars40_measure,
                         .truth = bars40_truth,
                         BARS};
const scene scene_a02_2 = {.name = "A02_2",
                           .about = "2 four-bars in a row: 3 freedoms at each passage of the horizontal",
                           .model = &four_bars2_model,
                           .begin = bars2_begin,
                           .duration = 10.0,
                           .quick = 2.0,
                           .outputs = 200,
                           .coarsest = 0.05,
                           .measure = bars2_measure,
                           .truth = bars2_truth,
                           BARS,
                           .published = "OpenSim 3.2 0.455 s"};

/* ---- Bricard's mechanism: P3 from a solution in quadruple precision whose digits agree at two tolerances. */

static const scene_digits bricard_digits[] = {
    {0.25, {0.9980847968766585, -1.0600572019049839, 0.9381393643446883}},
    {0.5, {0.9681538711727576, -1.2250354363220488, 0.7496440898776237}},
    {0.75, {0.8360066147843133, -1.4482536819515328, 0.45128063635691434}},
    {1.0, {0.5086647602300617, -1.6498270632111325, 0.13903533074806496}},
    {1.5, {-0.5206114976532169, -1.645474820231044, 0.14620630799280643}},
    {2.0, {-0.9698920037897387, -1.2194551409464747, 0.7564645796096069}},
    {2.5, {-0.9999999989432189, -1.0000459724372763, 0.9999540265059912}},
    {3.0, {-0.9663411779036645, -1.230661550970519, 0.7427360734814182}},
    {4.0, {0.5323992825579031, -1.6410322100967307, 0.15350664271251954}},
    {5.0, {0.9999999830907257, -1.0001838812949344, 0.9998161017989003}},
    {6.0, {0.4843027689008353, -1.6582523737368002, 0.12509953249813374}},
    {7.0, {-0.9731527665928688, -1.2084371279823956, 0.7698398538568297}},
    {8.0, {-0.9624838044946677, -1.2420460014195231, 0.728660865178887}},
    {9.0, {0.5554905314622124, -1.6318841022913033, 0.1684771383444537}},
    {10.0, {0.9999997294019177, -1.000735389910512, 0.9992643396903277}},
};

static bricard cube;

static void bricard_begin(scene_start *s) {
  cube = bricard_parameters();
  s->params = &cube;
  bricard_start(s->q, s->qd);
}

static void bricard_measure(const double *y, double *value) {
  for (int i = 0; i < 3; i++) value[i] = y[6 + i];
}

const scene scene_a04 = {.name = "A04",
                         .about = "Bricard's mechanism: 24 constraints of rank 23, and only where they hold",
                         .model = &bricard_model,
                         .begin = bricard_begin,
                         .duration = 10.0,
                         .quick = 1.0,
                         .outputs = 40,
                         .method = "dop853",
                         .tolerance = 1e-12,
                         .hold = true,
                         .coarsest = 0.125,
                         .measured = "P3",
                         .values = 3,
                         .measure = bricard_measure,
                         DIGITS(bricard_digits),
                         .floor = 1.0,
                         .required = 1e-6,
                         .energy = 1e-3,
                         .published = "OpenSim 3.2 0.258 s"};

/* ---- slider-crank with a rod as long as the crank, without forces: at the angle a of the crank the slider is at x = 2 l cos a, so
 *   a'^2 (m_pin + 4 m_slider sin^2 a) l^2 = 2 T,  and the phase s(a) = integral of sqrt(m_pin + 4 m_slider sin^2 a) grows evenly. */

static const slider_crank passing = {.crank = 1.0, .rod = 1.0, .pin_mass = 1.0, .slider_mass = 0.7};
static const double passing_angle = 1.0 / 3.0, passing_rate = 1.0; /* rad, rad/s, at the start */

static double phase_rate(double a) { return sqrt(passing.pin_mass + 4.0 * passing.slider_mass * sin(a) * sin(a)); }

/* By Simpson's rule, wrong by less than rounding. */
static double phase(double a) {
  const int parts = 2000;
  double sum = phase_rate(0.0) + phase_rate(a);
  for (int i = 1; i < parts; i++) sum += (i % 2 == 1 ? 4.0 : 2.0) * phase_rate(a * i / parts);
  return sum * a / parts / 3.0;
}

static void phase_on_circle(double s, double *value) {
  const double turn = 2.0 * acos(-1.0), angle = turn * s / phase(turn);
  value[0] = cos(angle), value[1] = sin(angle);
}

static void passing_begin(scene_start *s) {
  const double sine = sin(passing_angle), cosine = cos(passing_angle);
  s->params = &passing;
  s->q[0] = passing.crank * cosine, s->q[1] = passing.crank * sine, s->q[2] = 2.0 * passing.crank * cosine;
  for (int i = 0; i < 3; i++) s->qd[i] = passing_rate * (i == 1 ? s->q[0] : i == 0 ? -s->q[1] : -2.0 * s->q[1]);
}

static void passing_measure(const double *y, double *value) { phase_on_circle(phase(atan2(y[1], y[0])), value); }

static void passing_truth(double t, double *value) {
  phase_on_circle(phase(passing_angle) + phase_rate(passing_angle) * passing_rate * t, value);
}

const scene scene_dead_points = {.name = "dead_points",
                                 .about =
                                     "slider-crank whose slider passes the bearing: 2 freedoms there, and another motion branches off",
                                 .model = &slider_crank_model,
                                 .begin = passing_begin,
                                 .duration = 20.0,
                                 .quick = 5.0,
                                 .outputs = 200,
                                 .method = "dop853",
                                 .tolerance = 1e-12,
                                 .hold = true,
                                 .measured = "phase of the motion, on a circle",
                                 .values = 2,
                                 .measure = passing_measure,
                                 .truth = passing_truth,
                                 .floor = 1.0,
                                 .required = 1e-6,
                                 .energy = 1e-8};

/* ---- flyball governor: height of the slider, from a solution in quadruple precision whose digits agree at two tolerances. */

static const scene_digits flyball_digits[] = {
    {0.1, {0.52383647556957569}}, {0.2, {0.58507981182078316}}, {0.3, {0.65863234878034016}},  {0.4, {0.7177132364511406}},
    {0.5, {0.74324942478632561}}, {0.6, {0.72763122168663974}}, {0.7, {0.67546713953750404}},  {0.8, {0.60318128468915511}},
    {0.9, {0.53628232840894741}}, {1.0, {0.50142092237956759}}, {2.0, {0.5059092942967036}},   {3.0, {0.5132460783402204}},
    {4.0, {0.52322337102604333}}, {5.0, {0.5355631037216434}},  {6.0, {0.54992866590564227}},  {7.0, {0.56593815771940314}},
    {8.0, {0.58317833670977181}}, {9.0, {0.60121840204750621}}, {10.0, {0.61962291706136563}},
};

static flyball governor;

static void flyball_begin(scene_start *s) {
  governor = flyball_parameters();
  s->params = &governor;
  flyball_start(s->q, s->qd);
}

static void flyball_measure(const double *y, double *value) { value[0] = y[3]; }

const scene scene_a05 = {.name = "A05",
                         .about = "flyball governor: springs and dampers with an eigenvalue of -4e4 1/s",
                         .model = &flyball_model,
                         .begin = flyball_begin,
                         .duration = 10.0,
                         .quick = 1.0,
                         .outputs = 100,
                         .method = "dop853",
                         .tolerance = 1e-12,
                         .coarsest = 1.6e-4,
                         .measured = "height of the slider",
                         .values = 1,
                         .measure = flyball_measure,
                         DIGITS(flyball_digits),
                         .floor = 1.0,
                         .required = 1e-9,
                         .published = "Exudyn 0.53 s"};

/* ---- slider crank with an elastic rod: phi2, x3, q1 and q4 as the Test Set publishes them (MEBDFI, tolerance 1e-14). Its x3 starts
 * from a rounded number, 2e-10 m off the constraint. */

static const scene_digits crank_digits[] = {
    {0.1, {-3.311734988256260e-01, 1.697373328427860e-01, 1.893192899613509e-04, -8.363313279112129e-06}}};

static elastic_crank crank;

static void crank_begin(scene_start *s) {
  crank = elastic_crank_parameters();
  s->params = &crank;
  elastic_crank_start(s->q, s->qd);
}

static void crank_measure(const double *y, double *value) { value[0] = y[1], value[1] = y[2], value[2] = y[3], value[3] = y[6]; }

const scene scene_elastic_crank = {.name = "crank",
                                   .about = "slider crank with an elastic rod: driven, stiff, without damping",
                                   .model = &elastic_crank_model,
                                   .begin = crank_begin,
                                   .duration = 0.1,
                                   .quick = 0.1,
                                   .outputs = 100,
                                   .method = "dop853",
                                   .tolerance = 1e-12,
                                   .measured = "phi2, x3, q1, q4",
                                   .values = 4,
                                   .measure = crank_measure,
                                   DIGITS(crank_digits),
                                   .floor = 0.01,
                                   .required = 3e-9,
                                   .source = "the published digits",
                                   .published = "MEBDFI 180090 steps"};
