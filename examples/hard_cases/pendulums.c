/* Scenes of pendulums in Cartesian coordinates, with rods for constraints, and on a stiff spring. */
#include "cartesian_pendulum.h"
#include "chain16_tl.h"
#include "chain1_tl.h"
#include "chain2_tl.h"
#include "chain64_tl.h"
#include "chain6_tl.h"
#include "elliptic.h"
#include "repeated_rod.h"
#include "repeated_rod_tl.h"
#include "scene.h"
#include "spring_pendulum.h"
#include "spring_pendulum_tl.h"

#include <math.h>
#include <stdbool.h>

#define DIGITS(table) .digits = (table), .ndigits = sizeof(table) / sizeof(table)[0]

static const double gravity = 9.81;

/* ---- one mass, let go at (1, 0): with k = sin(amplitude/2), w = sqrt(g/l) and theta from the downward vertical,
 *   sin(theta/2) = k sn(K - w t),  cos(theta/2) = dn(K - w t). */

static void simple_begin(scene_start *s, const void *params) {
  s->params = params;
  s->q[0] = 1.0;
}

static void simple_measure(const double *y, double *value) { value[0] = y[0], value[1] = y[1]; }

static void simple_truth(double t, double *value) {
  const double k2 = 0.5; /* sin^2 of half of a right angle */
  const elliptic at = elliptic_at(elliptic_quarter(k2) - sqrt(gravity) * t, k2);
  const double s = sqrt(k2) * at.sn;
  value[0] = 2.0 * s * at.dn;
  value[1] = 2.0 * s * s - 1.0;
}

static const cartesian_pendulum simple = {.links = 1, .coordinates = 2, .g = 9.81, .mass = {1.0}, .length = {1.0}};
static void a01_begin(scene_start *s) { simple_begin(s, &simple); }

#define SIMPLE_TRUTH                                                                                                                   \
  .measured = "x, y", .values = 2, .measure = simple_measure, .truth = simple_truth, .floor = 1e-3, .required = 1e-3, .energy = 5e-5

const scene scene_a01 = {.name = "A01",
                         .about = "simple pendulum in Cartesian coordinates: drift over a long time",
                         .model = &chain1_model,
                         .begin = a01_begin,
                         .duration = 2000.0,
                         .quick = 10.0,
                         .outputs = 4000,
                         .method = "dop853",
                         .tolerance = 1e-14,
                         .coarsest = 0.1,
                         SIMPLE_TRUTH,
                         .source = "the benchmark",
                         .published = "Exudyn 0.037 s, OpenSim 3.2 0.637 s for 10 s"};

/* ---- the same with its constraint written as it should not be; truth and bounds stay. */

static const repeated_rod thrice = {.mass = 1.0, .length = 1.0, .gravity = 9.81, .rows = 3, .scale = {1.0, 1.0, 1.0}};
static const repeated_rod scaled = {.mass = 1.0, .length = 1.0, .gravity = 9.81, .rows = 1, .scale = {1e8}};
static const repeated_rod mixed = {.mass = 1.0, .length = 1.0, .gravity = 9.81, .rows = 3, .scale = {1.0, 1e8, 1e-8}};
static void thrice_begin(scene_start *s) { simple_begin(s, &thrice); }
static void scaled_begin(scene_start *s) { simple_begin(s, &scaled); }
static void mixed_begin(scene_start *s) { simple_begin(s, &mixed); }

#define REPEATED                                                                                                                       \
  .model = &repeated_rod_model, .duration = 100.0, .quick = 5.0, .outputs = 200, .method = "dop853", .tolerance = 1e-12, SIMPLE_TRUTH

const scene scene_rod_thrice = {
    .name = "thrice", .about = "simple pendulum whose constraint is given three times", .begin = thrice_begin, REPEATED};
const scene scene_rod_scaled = {
    .name = "scaled", .about = "simple pendulum whose constraint is scaled by 1e8", .begin = scaled_begin, REPEATED};
const scene scene_rod_mixed = {
    .name = "mixed", .about = "simple pendulum whose constraint is given times 1, 1e8 and 1e-8", .begin = mixed_begin, REPEATED};

/* ---- chains let go with the first link at 75 degrees, the others hanging: the last mass, from tests/data/chain.c (1e-24; 16 digits
 * agree with 1e-20). Errors grow like e^t, so the times are short. */

static void chain_begin(scene_start *s, cartesian_pendulum *p, int links, bool straight) {
  const double angle = 75.0 * 3.14159265358979323846 / 180.0, dx = straight ? sin(angle) : 0.0, dy = straight ? cos(angle) : 1.0;
  p->links = links;
  p->coordinates = 2 * links;
  p->g = gravity;
  for (int i = 0; i < links; i++) {
    if (p->mass[i] <= 0.0) p->mass[i] = 1.0;
    p->length[i] = 1.0;
    s->q[2 * i] = sin(angle) + i * dx;
    s->q[2 * i + 1] = -cos(angle) - i * dy;
  }
  s->params = p;
}

static cartesian_pendulum six, sixteen, sixty_four;
static void chain6_begin(scene_start *s) { chain_begin(s, &six, 6, false); }
static void chain16_begin(scene_start *s) { chain_begin(s, &sixteen, 16, false); }
static void chain64_begin(scene_start *s) { chain_begin(s, &sixty_four, 64, false); }

static void last6(const double *y, double *value) { value[0] = y[10], value[1] = y[11]; }
static void last16(const double *y, double *value) { value[0] = y[30], value[1] = y[31]; }

static void some64(const double *y, double *value) {
  for (int i = 0; i < 2; i++) value[i] = y[6 + i], value[2 + i] = y[30 + i];
}

static const scene_digits digits6[] = {
    {1.0, {0.828880251166554, -4.771040028854738}},    {2.0, {-1.7410456769926346, -4.314109360187569}},
    {3.0, {0.4904173469653026, -5.399967641497141}},   {4.0, {1.3296256016427856, -5.219147871841549}},
    {5.0, {-0.49374781999776995, -5.376726151073789}}, {6.0, {-1.0117082700159328, -3.6204233167985804}},
    {7.0, {0.8949575217263486, -4.662102845076072}},   {8.0, {0.9654822592201514, -5.0250320482926}},
    {9.0, {-0.23141665509860068, -5.770400705587283}}, {10.0, {-1.3516848780871706, -4.596309250953326}},
};
static const scene_digits digits16[] = {
    {1.0, {0.9659258258902318, -15.163675692128377}},   {2.0, {0.52377033826991, -13.712215623316638}},
    {3.0, {-1.1446430878681522, -13.229043643829113}},  {4.0, {0.0782687136903964, -14.86826518681804}},
    {5.0, {-0.46276369475689294, -14.905237222906985}},
};
static const scene_digits digits64[] = {
    {0.1, {0.9659258262884968, -3.3078042457650496, 0.9659258262890683, -15.30780424576505}},
    {0.2, {0.965925824098175, -3.4545814894295606, 0.9659258262890683, -15.454581489429561}},
    {0.3, {0.9659190913124207, -3.6973131313361995, 0.9659258262890683, -15.69731313131389}},
    {0.4, {0.43470658689540304, -3.9691198364645115, 0.9659258262890172, -15.909743950650158}},
    {0.5, {-0.3748251686303145, -3.980135118797403, 0.965925321659233, -15.769509425398793}},
    {0.6, {-0.6630850149873857, -3.942219926689123, 0.9657772625411855, -15.590349804369152}},
    {0.7, {-0.8352917713644853, -3.9114447679194777, 0.9615899799491068, -15.448547780414657}},
    {0.8, {-0.8224072773448454, -3.9135728511623347, 0.9199725630297222, -15.360966465392591}},
    {0.9, {-0.8032600241016429, -3.917944273734526, 0.7038057903967092, -15.346956255923415}},
    {1.0, {-0.674606566643064, -3.942124265958593, 0.07411447579126175, -15.5115562104919}},
};

#define CHAIN .method = "dop853", .floor = 1.0

const scene scene_chain6 = {.name = "chain6",
                            .about = "chain of 6 links, rods as constraints",
                            .model = &chain6_model,
                            .begin = chain6_begin,
                            .duration = 10.0,
                            .quick = 2.0,
                            .outputs = 100,
                            .tolerance = 1e-12,
                            .measured = "last mass",
                            .values = 2,
                            .measure = last6,
                            DIGITS(digits6),
                            .required = 1e-6,
                            .energy = 1e-7,
                            CHAIN};
const scene scene_chain16 = {.name = "chain16",
                             .about = "chain of 16 links, rods as constraints",
                             .model = &chain16_model,
                             .begin = chain16_begin,
                             .duration = 5.0,
                             .quick = 1.0,
                             .outputs = 50,
                             .tolerance = 1e-12,
                             .measured = "last mass",
                             .values = 2,
                             .measure = last16,
                             DIGITS(digits16),
                             .required = 1e-6,
                             .energy = 1e-7,
                             CHAIN};
const scene scene_chain64 = {.name = "chain64",
                             .about = "chain of 64 links, rods as constraints",
                             .model = &chain64_model,
                             .begin = chain64_begin,
                             .duration = 1.0,
                             .quick = 0.1,
                             .outputs = 10,
                             .tolerance = 1e-12,
                             .measured = "masses 4 and 16",
                             .values = 4,
                             .measure = some64,
                             DIGITS(digits64),
                             .required = 1e-6,
                             .energy = 1e-6,
                             CHAIN};

/* ---- two links, masses in the ratio 1e8; digits as above. With the heavy mass below, the chain starts straight, and the light mass
 * can swing across at 4e4 rad/s; when the heavy mass is let fall and the chain snaps straight, it is thrown across within 1e-8 s. The
 * energy is of the size of 1e9 J. */

static cartesian_pendulum heavy_above = {.mass = {1e8, 1.0}}, heavy_below = {.mass = {1.0, 1e8}};
static void heavy_above_begin(scene_start *s) { chain_begin(s, &heavy_above, 2, false); }
static void snap_begin(scene_start *s) { chain_begin(s, &heavy_below, 2, false); }
static void heavy_below_begin(scene_start *s) { chain_begin(s, &heavy_below, 2, true); }

static void both(const double *y, double *value) {
  for (int i = 0; i < 4; i++) value[i] = y[i];
}

static const scene_digits digits_above[] = {
    {1.0, {-0.9452323658394552, -0.3263981840781997, -1.2563127241622516, -1.2767817964504673}},
    {2.0, {0.8570929711570479, -0.5151617598319812, 0.5961902137197703, 0.4502033271489108}},
    {3.0, {-0.6416105913458517, -0.7670305398566777, -1.5460796609199516, -1.1935697551508426}},
    {4.0, {0.26805475367694315, -0.9634036791663156, -0.6053875445540841, -0.4764760134284759}},
    {5.0, {0.19093332271218103, -0.9816030084907473, -0.5676442330386557, -1.6331857675559993}},
};
static const scene_digits digits_below[] = {
    {1.0, {-0.5120731863774195, -0.858941820959532, -1.024146373756053, -1.7178836413221725}},
    {2.0, {-0.7923913200580042, -0.6100131112498597, -1.5847826374261658, -1.2200262259937555}},
};

static const scene_digits digits_snap[] = {
    {1.0, {0.17140134008432292, -0.9852012893908018, -0.6831620574239099, -1.5045483791479177}},
    {2.0, {0.43730023613419444, -0.899315575021904, -0.18295819990705636, -1.6837130970218537}},
    {3.0, {0.8646323352722176, -0.5024051401027974, 0.9649266597714732, -1.4973629525115637}},
    {4.0, {-0.04429483485960795, -0.9990185021333489, -0.9778603737320866, -1.3574252328594036}},
    {5.0, {0.654688000527652, -0.75589921415828, 0.4241729161905522, -1.7289679660422668}},
    {6.0, {0.4020297338087989, -0.9156266122899805, 0.5474383585741891, -1.904998297676134}},
    {7.0, {-0.8286968801821348, -0.5596976690825115, -1.1269779322743438, -1.5141757536726004}},
    {8.0, {0.7075901708653344, -0.7066230608285913, 1.0182524280633625, -1.6571434246044685}},
    {9.0, {-0.45072565382330126, -0.8926625258100385, -0.14640281106085637, -1.8452314773159042}},
    {10.0, {-0.8301022460632096, -0.5576112096082849, -0.690594627320646, -1.5478322073218151}},
};

#define HEAVY                                                                                                                          \
  .model = &chain2_model, .quick = 1.0, .method = "dop853", .measured = "both masses", .values = 4, .measure = both, .floor = 1.0,     \
  .energy = 1.0

const scene scene_heavy_above = {.name = "heavy_above",
                                 .about = "two links, 1e8 kg above 1 kg",
                                 .begin = heavy_above_begin,
                                 .duration = 5.0,
                                 .outputs = 50,
                                 .tolerance = 1e-12,
                                 DIGITS(digits_above),
                                 .required = 1e-6,
                                 HEAVY};
const scene scene_heavy_below = {.name = "heavy_below",
                                 .about = "two links, 1 kg above 1e8 kg",
                                 .begin = heavy_below_begin,
                                 .duration = 2.0,
                                 .outputs = 20,
                                 .tolerance = 1e-12,
                                 DIGITS(digits_below),
                                 .required = 1e-6,
                                 HEAVY};
const scene scene_snap = {.name = "snap",
                          .about = "the same let fall: it snaps straight within 1e-8 s",
                          .begin = snap_begin,
                          .duration = 10.0,
                          .outputs = 100,
                          .tolerance = 1e-14,
                          DIGITS(digits_snap),
                          .required = 1e-6,
                          HEAVY};

/* ---- pendulum on a spring a thousand times as fast as it swings: from a solution in quadruple precision whose digits agree at two
 * tolerances. */

static const struct spring_pendulum stiff = {.mass = 1.0, .rest = 1.0, .stiffness = 9.81e6, .gravity = 9.81};

static void spring_begin(scene_start *s) {
  s->params = &stiff;
  s->q[0] = 1.0;
  s->q[1] = 1.0;
}

static const scene_digits spring_digits[] = {{0.1, {1.0000003283733525, 0.9589101782874985}},
                                             {1.0, {1.0000011291295299, -0.98006632935306214}},
                                             {10.0, {1.0000012036785855, -0.4632815564204581}},
                                             {100.0, {1.0000016741005593, -0.014394501660730622}}};

const scene scene_spring = {.name = "spring",
                            .about = "pendulum on a spring, a thousand times as fast as it swings",
                            .model = &spring_pendulum_model,
                            .begin = spring_begin,
                            .duration = 100.0,
                            .quick = 1.0,
                            .outputs = 1000,
                            .method = "dop853",
                            .tolerance = 1e-12,
                            .measured = "length, angle",
                            .values = 2,
                            .measure = simple_measure,
                            DIGITS(spring_digits),
                            .floor = 1.0,
                            .required = 1e-6,
                            .energy = 1e-6};
