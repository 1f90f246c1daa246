/* Constrained models on libtaylor calls. */
#include "constrained_models.h"

#include "pen.h"

#define GRAVITY TL_C(9.81)

#define Q(i) at(&p, q, i)
#define V(i) at(&p, qd, i)

/* Opens and closes the body of a model function whose operands q, qd, t, params may stay unused. */
#define BEGIN                                                                                                                          \
  pen p = {cx, 0};                                                                                                                     \
  (void)q, (void)qd, (void)t, (void)params;
#define END pen_lift(&p);
#define FUNCTION(name)                                                                                                                 \
  static void name(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)

static size_t frame(const void *params) {
  (void)params;
  return PEN_FRAME;
}
#define COUNT(name, value)                                                                                                             \
  static int name(const void *params) {                                                                                                \
    (void)params;                                                                                                                      \
    return value;                                                                                                                      \
  }
COUNT(one, 1)
COUNT(two, 2)
COUNT(three, 3)
COUNT(four, 4)

/* a1 b1 + a2 b2 + a3 b3. */
static jet dot3(pen *p, jet a1, jet b1, jet a2, jet b2, jet a3, jet b3) {
  return add(p, add(p, mul(p, a1, b1), mul(p, a2, b2)), mul(p, a3, b3));
}

static jet square3(pen *p, jet a, jet b, jet c) { return dot3(p, a, a, b, b, c, c); }

#define LAGRANGIAN(function) .lagrangian = {.name = "lagrangian", .source = "model.c:1", .jet = function, .rows = one, .frame = frame}
#define CONSTRAINT(label, function, count) {.name = label, .source = "model.c:20", .jet = function, .rows = count, .frame = frame}
#define FORCE(function, count) .force = {.name = "force", .source = "model.c:10", .jet = function, .rows = count, .frame = frame}

/* ---- Cartesian pendulum: (x'^2 + y'^2) - 2 g y, x^2 + y^2 = 1 ---- */

FUNCTION(point_lagrangian) {
  BEGIN pen_result(&p, out, sub(&p, add(&p, square(&p, V(0)), square(&p, V(1))), times(&p, TL_C(2.0) * GRAVITY, Q(1))));
  END
}

FUNCTION(circle) {
  BEGIN pen_result(&p, out, plus(&p, add(&p, square(&p, Q(0)), square(&p, Q(1))), TL_C(-1.0)));
  END
}

static const eom_function circle_list[] = {CONSTRAINT("circle", circle, one)};
const eom_model cartesian_pendulum = {
    .name = "cartesian_pendulum", .dof = two, LAGRANGIAN(point_lagrangian), .holonomic = circle_list, .nholonomic = 1};

/* ---- Cartesian double pendulum, masses 1 and 3, drag -0.3 qd ---- */

FUNCTION(double_lagrangian) {
  BEGIN jet inner = add(&p, square(&p, V(0)), square(&p, V(1)));
  jet outer = add(&p, square(&p, V(2)), square(&p, V(3)));
  jet kinetic = add(&p, times(&p, TL_C(0.5), inner), times(&p, TL_C(1.5), outer));
  jet height = add(&p, Q(1), times(&p, TL_C(3.0), Q(3)));
  pen_result(&p, out, sub(&p, kinetic, times(&p, GRAVITY, height)));
  END
}

FUNCTION(double_links) {
  BEGIN pen_result(&p, out, plus(&p, add(&p, square(&p, Q(0)), square(&p, Q(1))), TL_C(-1.0)));
  jet dx = sub(&p, Q(2), Q(0)), dy = sub(&p, Q(3), Q(1));
  pen_result(&p, row(&p, out, 1), plus(&p, add(&p, square(&p, dx), square(&p, dy)), TL_C(-1.0)));
  END
}

FUNCTION(double_drag) {
  BEGIN for (int i = 0; i < 4; i++) pen_result(&p, row(&p, out, i), times(&p, TL_C(-0.3), V(i)));
  END
}

static const eom_function double_list[] = {CONSTRAINT("links", double_links, two)};
const eom_model cartesian_double_pendulum = {.name = "cartesian_double_pendulum",
                                             .dof = four,
                                             LAGRANGIAN(double_lagrangian),
                                             FORCE(double_drag, four),
                                             .holonomic = double_list,
                                             .nholonomic = 1};

/* ---- central field: |r' u + r u'|^2 + 2*1.7/r (mass 2, mu 1.7), |u|^2 = 1 ---- */

FUNCTION(central_lagrangian) {
  BEGIN jet speed2 = NULL;
  for (int i = 1; i < 4; i++) {
    jet v2 = square(&p, add(&p, mul(&p, V(0), Q(i)), mul(&p, Q(0), V(i))));
    speed2 = speed2 ? add(&p, speed2, v2) : v2;
  }
  tl_real *inverse = pen_new(&p);
  if (!inverse) return;
  tl_rdiv(cx, inverse, TL_C(2.0) * TL_C(1.7), Q(0));
  pen_result(&p, out, add(&p, speed2, inverse));
  END
}

FUNCTION(unit_direction) {
  BEGIN pen_result(&p, out, plus(&p, square3(&p, Q(1), Q(2), Q(3)), TL_C(-1.0)));
  END
}

static const eom_function unit_direction_list[] = {CONSTRAINT("unit_direction", unit_direction, one)};
const eom_model central_field = {
    .name = "central_field", .dof = four, LAGRANGIAN(central_lagrangian), .holonomic = unit_direction_list, .nholonomic = 1};

/* ---- bead on a hoop that turns at 2 rad/s: x^2 + y^2 + z^2 = 1, x sin 2t = y cos 2t ---- */

FUNCTION(bead_lagrangian) {
  BEGIN pen_result(&p, out, sub(&p, times(&p, TL_C(0.5), square3(&p, V(0), V(1), V(2))), times(&p, GRAVITY, Q(2))));
  END
}

FUNCTION(sphere) {
  BEGIN pen_result(&p, out, plus(&p, square3(&p, Q(0), Q(1), Q(2)), TL_C(-1.0)));
  END
}

FUNCTION(hoop_plane) {
  BEGIN jet angle = times(&p, TL_C(2.0), t);
  pen_result(&p, out, sub(&p, mul(&p, Q(0), sine(&p, angle)), mul(&p, Q(1), cosine(&p, angle))));
  END
}

static const eom_function hoop_list[] = {CONSTRAINT("sphere", sphere, one), CONSTRAINT("hoop_plane", hoop_plane, one)};
const eom_model rotating_hoop = {
    .name = "rotating_hoop", .dof = three, LAGRANGIAN(bead_lagrangian), .holonomic = hoop_list, .nholonomic = 2};

/* ---- Chaplygin sleigh: (x' - a h' sin h)^2 + (y' + a h' cos h)^2 + 0.4 h'^2, a = 0.25; x' sin h = y' cos h ---- */

FUNCTION(sleigh_lagrangian) {
  BEGIN jet s = sine(&p, Q(2)), c = cosine(&p, Q(2)), a = times(&p, TL_C(0.25), V(2));
  jet vx = sub(&p, V(0), mul(&p, a, s)), vy = add(&p, V(1), mul(&p, a, c));
  jet translation = add(&p, square(&p, vx), square(&p, vy));
  pen_result(&p, out, add(&p, translation, times(&p, TL_C(0.4), square(&p, V(2)))));
  END
}

FUNCTION(knife_edge) {
  BEGIN pen_result(&p, out, sub(&p, mul(&p, V(0), sine(&p, Q(2))), mul(&p, V(1), cosine(&p, Q(2)))));
  END
}

/* (-0.1 x', -0.2 y'^3, sin t). */
FUNCTION(sleigh_force) {
  BEGIN pen_result(&p, out, times(&p, TL_C(-0.1), V(0)));
  pen_result(&p, row(&p, out, 1), times(&p, TL_C(-0.2), mul(&p, V(1), square(&p, V(1)))));
  pen_result(&p, row(&p, out, 2), sine(&p, t));
  END
}

static const eom_function knife_list[] = {CONSTRAINT("knife_edge", knife_edge, one)};
const eom_model sleigh = {.name = "sleigh",
                          .dof = three,
                          LAGRANGIAN(sleigh_lagrangian),
                          FORCE(sleigh_force, three),
                          .nonholonomic = knife_list,
                          .nnonholonomic = 1};

/* ---- Appell: x'^2 + y'^2 = 0.7 z'^2 ---- */

FUNCTION(cone) {
  BEGIN jet flat = add(&p, square(&p, V(0)), square(&p, V(1)));
  pen_result(&p, out, sub(&p, flat, times(&p, TL_C(0.7), square(&p, V(2)))));
  END
}

static const eom_function cone_list[] = {CONSTRAINT("cone", cone, one)};
const eom_model appell = {.name = "appell", .dof = three, LAGRANGIAN(bead_lagrangian), .nonholonomic = cone_list, .nnonholonomic = 1};

/* ---- symmetric top by a quaternion: w = 2 E(q) q', I = (1, 1, 0.5), 2 z of its axis ---- */

FUNCTION(top_lagrangian) {
  BEGIN static const int index[3][4] = {{1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  static const int sign[3][4] = {{-1, 1, 1, -1}, {-1, -1, 1, 1}, {-1, 1, -1, 1}};
  static const tl_real inertia[3] = {TL_C(2.0), TL_C(2.0), TL_C(1.0)};
  jet energy = NULL;
  for (int i = 0; i < 3; i++) {
    jet w = NULL;
    for (int j = 0; j < 4; j++) {
      jet term = times(&p, (tl_real)sign[i][j], mul(&p, Q(index[i][j]), V(j)));
      w = w ? add(&p, w, term) : term;
    }
    jet part = times(&p, inertia[i], square(&p, w));
    energy = energy ? add(&p, energy, part) : part;
  }
  jet up = sub(&p, add(&p, square(&p, Q(0)), square(&p, Q(3))), add(&p, square(&p, Q(1)), square(&p, Q(2))));
  pen_result(&p, out, sub(&p, energy, times(&p, TL_C(2.0), up)));
  END
}

FUNCTION(unit_quaternion) {
  BEGIN jet vector = square3(&p, Q(1), Q(2), Q(3));
  pen_result(&p, out, plus(&p, add(&p, square(&p, Q(0)), vector), TL_C(-1.0)));
  END
}

static const eom_function unit_quaternion_list[] = {CONSTRAINT("unit_quaternion", unit_quaternion, one)};
const eom_model quaternion_top = {
    .name = "quaternion_top", .dof = four, LAGRANGIAN(top_lagrangian), .holonomic = unit_quaternion_list, .nholonomic = 1};

/* ---- mixed: ((1 + x^2) x'^2 + y'^2 + z'^2)/2 + 0.6 (x y' - y x') - g z; z = x^2/2 + y^2; y' = z x' + sin t; drag -0.2 qd^3 ---- */

FUNCTION(mixed_lagrangian) {
  BEGIN jet kinetic = add(&p, square3(&p, V(0), V(1), V(2)), square(&p, mul(&p, Q(0), V(0))));
  jet gyroscopic = sub(&p, mul(&p, Q(0), V(1)), mul(&p, Q(1), V(0)));
  jet velocity = add(&p, times(&p, TL_C(0.5), kinetic), times(&p, TL_C(0.6), gyroscopic));
  pen_result(&p, out, sub(&p, velocity, times(&p, GRAVITY, Q(2))));
  END
}

FUNCTION(bowl) {
  BEGIN pen_result(&p, out, sub(&p, sub(&p, Q(2), times(&p, TL_C(0.5), square(&p, Q(0)))), square(&p, Q(1))));
  END
}

FUNCTION(steering) {
  BEGIN pen_result(&p, out, sub(&p, sub(&p, V(1), mul(&p, Q(2), V(0))), sine(&p, t)));
  END
}

FUNCTION(cubic_drag) {
  BEGIN for (int i = 0; i < 3; i++) pen_result(&p, row(&p, out, i), times(&p, TL_C(-0.2), mul(&p, V(i), square(&p, V(i)))));
  END
}

static const eom_function bowl_list[] = {CONSTRAINT("bowl", bowl, one)}, steering_list[] = {CONSTRAINT("steering", steering, one)};
const eom_model mixed = {.name = "mixed",
                         .dof = three,
                         LAGRANGIAN(mixed_lagrangian),
                         FORCE(cubic_drag, three),
                         .holonomic = bowl_list,
                         .nholonomic = 1,
                         .nonholonomic = steering_list,
                         .nnonholonomic = 1};

/* ---- relativistic charge on a sphere: -25 sqrt(1 - v^2/25) + 0.8 (x y' - y x') + z sin t ---- */

FUNCTION(relativistic_lagrangian) {
  BEGIN jet v2 = square3(&p, V(0), V(1), V(2));
  jet inertia = times(&p, TL_C(-25.0), root(&p, plus(&p, times(&p, TL_C(-0.04), v2), TL_C(1.0))));
  jet magnetic = sub(&p, mul(&p, Q(0), V(1)), mul(&p, Q(1), V(0)));
  pen_result(&p, out, add(&p, add(&p, inertia, times(&p, TL_C(0.8), magnetic)), mul(&p, Q(2), sine(&p, t))));
  END
}

static const eom_function sphere_list[] = {CONSTRAINT("sphere", sphere, one)};
const eom_model relativistic = {
    .name = "relativistic", .dof = three, LAGRANGIAN(relativistic_lagrangian), .holonomic = sphere_list, .nholonomic = 1};

/* ---- massless: x'^2/2 - 4 s, s = x^2/2 + x ---- */

FUNCTION(massless_lagrangian) {
  BEGIN pen_result(&p, out, sub(&p, times(&p, TL_C(0.5), square(&p, V(0))), times(&p, TL_C(4.0), Q(1))));
  END
}

FUNCTION(follower) {
  BEGIN pen_result(&p, out, sub(&p, sub(&p, Q(1), Q(0)), times(&p, TL_C(0.5), square(&p, Q(0)))));
  END
}

static const eom_function follower_list[] = {CONSTRAINT("follower", follower, one)};
const eom_model massless = {
    .name = "massless", .dof = two, LAGRANGIAN(massless_lagrangian), .holonomic = follower_list, .nholonomic = 1};
const eom_model floating = {.name = "floating", .dof = two, LAGRANGIAN(massless_lagrangian)};

/* ---- the circle again and again ---- */

static int redundant_rows(const void *params) { return ((const redundancy *)params)->rows; }

FUNCTION(circles) {
  BEGIN const redundancy *r = params;
  jet c = plus(&p, add(&p, square(&p, Q(0)), square(&p, Q(1))), TL_C(-1.0));
  jet bend = times(&p, TL_C(0.5), square(&p, t));
  for (int i = 0; i < r->rows; i++) pen_result(&p, row(&p, out, i), add(&p, times(&p, r->factor[i], c), times(&p, r->bend[i], bend)));
  END
}

static const eom_function circles_list[] = {CONSTRAINT("circles", circles, redundant_rows)};
const eom_model redundant = {.name = "redundant",
                             .dof = two,
                             .params_size = sizeof(redundancy),
                             LAGRANGIAN(point_lagrangian),
                             .holonomic = circles_list,
                             .nholonomic = 1};

/* ---- saddle: (x'^2 + y'^2)/2, x^2 - 2 y^2 and 0.3 x^2 - 0.6 y^2 ---- */

FUNCTION(flat_lagrangian) {
  BEGIN pen_result(&p, out, times(&p, TL_C(0.5), add(&p, square(&p, V(0)), square(&p, V(1)))));
  END
}

FUNCTION(saddle_rows) {
  BEGIN jet x2 = square(&p, Q(0)), y2 = square(&p, Q(1));
  pen_result(&p, out, sub(&p, x2, times(&p, TL_C(2.0), y2)));
  pen_result(&p, row(&p, out, 1), sub(&p, times(&p, TL_C(0.3), x2), times(&p, TL_C(0.6), y2)));
  END
}

static const eom_function saddle_list[] = {CONSTRAINT("saddle", saddle_rows, two)};
const eom_model saddle = {.name = "saddle", .dof = two, LAGRANGIAN(flat_lagrangian), .holonomic = saddle_list, .nholonomic = 1};

const eom_model *const constrained_models[] = {&cartesian_pendulum,
                                               &cartesian_double_pendulum,
                                               &central_field,
                                               &rotating_hoop,
                                               &sleigh,
                                               &appell,
                                               &quaternion_top,
                                               &mixed,
                                               &relativistic,
                                               &massless};
const int nconstrained_models = (int)(sizeof constrained_models / sizeof constrained_models[0]);
