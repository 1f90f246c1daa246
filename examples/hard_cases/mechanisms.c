/* Scenes of published mechanisms with closed loops and stiff parts. */
#include "andrews.h"
#include "andrews_tl.h"
#include "elastic_crank.h"
#include "elastic_crank_tl.h"
#include "flyball.h"
#include "flyball_tl.h"
#include "scene.h"

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
                         .method = "dp5",
                         .step = 2.5e-6,
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
                         .method = "dp5",
                         .step = 4e-5,
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
                                   .method = "dp5",
                                   .step = 5e-6,
                                   .measured = "phi2, x3, q1, q4",
                                   .values = 4,
                                   .measure = crank_measure,
                                   DIGITS(crank_digits),
                                   .floor = 0.01,
                                   .required = 3e-9,
                                   .source = "the published digits",
                                   .published = "MEBDFI 180090 steps"};
