/* Division and the elementary functions of jets with lanes. Values come from the C library lane by lane; where every lane is an
 * ordinary point the recurrence goes through all lanes at once, as it would through one. All else is done lane by lane by the functions
 * for one number, and gives their bits and their status. */
#include "taylor/elementary.h"
#include "block.h"
#include "lane.h"

/* Jets of one number that the scratch jets hold: a context for one lane, three operands and two results. */
enum { MOST_OPERANDS = 3, MOST_RESULTS = 2 };
_Static_assert(TL_LANE_JETS + MOST_OPERANDS + MOST_RESULTS <= TL_NSCRATCH * TL_REAL_LANES, "the scratch jets have no room for a lane");

static void gather(int n, tl_number *to, const tl_real *from, int lane) {
  for (int i = 0; i < n; i++) to[i] = from[i][lane];
}
static void scatter(int n, tl_real *to, const tl_number *from, int lane) {
  for (int i = 0; i < n; i++) to[i][lane] = from[i];
}

/* An operation with its operands and results, and a constant for each lane. */
typedef struct operation {
  tl_lane_function function;
  const tl_real *operands[MOST_OPERANDS];
  tl_real *results[MOST_RESULTS];
  tl_real x;
  int n;
} operation;

/* The result may be an operand: of it a lane is written when it has been read. */
static void lane_by_lane(tl_ctx *cx, const operation *o) {
  const int n = cx->shape->ncoef;
  tl_number *memory = (tl_number *)cx->scratch, *operands = memory + TL_LANE_JETS * n, *results = operands + MOST_OPERANDS * n;
  for (int lane = 0; lane < TL_REAL_LANES; lane++) {
    for (int k = 0; k < MOST_OPERANDS; k++)
      if (o->operands[k]) gather(n, operands + k * n, o->operands[k], lane);
    const tl_lane_task task = {o->function, cx->shape, memory, operands, o->x[lane], o->n, results};
    int failed;
    const unsigned bits = tl_lane_run(&task, &failed);
    if (bits != TL_OK) {
      for (int k = 0; k < MOST_RESULTS; k++)
        if (o->results[k]) tl_reject_in_lane(cx, o->results[k], bits, (tl_fn)failed, lane);
      return;
    }
    for (int k = 0; k < MOST_RESULTS; k++)
      if (o->results[k]) scatter(n, o->results[k], results + k * n, lane);
  }
}

static void one(tl_ctx *cx, tl_real *c, const tl_real *a, tl_lane_function function) {
  lane_by_lane(cx, &(operation){.function = function, .operands = {a}, .results = {c}});
}
static void with_constant(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x, tl_lane_function function) {
  lane_by_lane(cx, &(operation){.function = function, .operands = {a}, .results = {c}, .x = x});
}
static void two(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_lane_function function) {
  lane_by_lane(cx, &(operation){.function = function, .operands = {a, b}, .results = {c}});
}

/* Numbers whose products and quotients with each other are far from the ends of the range; and such or zero. */
static tl_real_mask ordinary(tl_real x) {
  const tl_real far = TL_C(1.0) / (TL_EPSILON * TL_EPSILON);
  return ((x <= far) & (x >= TL_C(1.0) / far)) | ((x >= -far) & (x <= -TL_C(1.0) / far));
}
static int are_ordinary(tl_real x) { return TL_EVERY(ordinary(x)); }
static int are_ordinary_or_zero(tl_real x) { return TL_EVERY(ordinary(x) | (x == TL_C(0.0))); }

void tl_div(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  if (!are_ordinary_or_zero(a[0]) || !are_ordinary(b[0])) {
    two(cx, c, a, b, TL_LANE_div);
    return;
  }
  const tl_real *divisor = tl_unaliased(cx, b, c, 0);
  c[0] = a[0] / divisor[0];
  tl_quotient_blocks(cx->shape, c, b == a ? divisor : a, divisor);
  tl_check(cx, c, TL_FN_div);
}

void tl_rdiv(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b) {
  if (!are_ordinary_or_zero(x) || !are_ordinary(b[0])) {
    with_constant(cx, c, b, x, TL_LANE_rdiv);
    return;
  }
  const tl_real *divisor = tl_unaliased(cx, b, c, 0);
  tl_row_zero(cx->shape->ncoef, c);
  c[0] = x / divisor[0];
  tl_quotient_blocks(cx->shape, c, c, divisor);
  tl_check(cx, c, TL_FN_div);
}

void tl_divc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  if (!are_ordinary(x)) {
    with_constant(cx, c, a, x, TL_LANE_divc);
    return;
  }
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = a[i] / x;
  tl_check(cx, c, TL_FN_div);
}

#define VALUES(result, name, argument)                                                                                                 \
  tl_real result = (argument);                                                                                                         \
  for (int lane = 0; lane < TL_REAL_LANES; lane++) result[lane] = TL_LIBM(name)(result[lane])

/* Where exponentials, and what the recurrence makes of them on the way, are within the range of a float too. */
static int are_small(tl_real x) { return TL_EVERY((x < TL_C(64.0)) & (x > -TL_C(64.0))); }

void tl_exp(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!are_small(a[0])) {
    one(cx, c, a, TL_LANE_exp);
    return;
  }
  VALUES(value, exp, a[0]);
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  c[0] = value;
  tl_exp_blocks(cx->shape, c, TL_C(1.0), x);
  tl_check(cx, c, TL_FN_exp);
}

static int are_finite(tl_real x) { return TL_EVERY(TL_ISFINITE(x)); }

/* Both are wanted, at any finite argument. */
static void circle(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  VALUES(s, sin, a[0]);
  VALUES(c, cos, a[0]);
  sine[0] = s;
  cosine[0] = c;
  tl_circle_blocks(cx->shape, sine, cosine, -TL_C(1.0), a);
}

void tl_sin(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!are_finite(a[0])) {
    one(cx, c, a, TL_LANE_sin);
    return;
  }
  circle(cx, c, tl_scratch(cx, 1), tl_unaliased(cx, a, c, 0));
  tl_check(cx, c, TL_FN_sin);
}

void tl_cos(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!are_finite(a[0])) {
    one(cx, c, a, TL_LANE_cos);
    return;
  }
  circle(cx, tl_scratch(cx, 1), c, tl_unaliased(cx, a, c, 0));
  tl_check(cx, c, TL_FN_cos);
}

void tl_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  assert(sine != cosine);
  if (!are_finite(a[0])) {
    lane_by_lane(cx, &(operation){.function = TL_LANE_sincos, .operands = {a}, .results = {sine, cosine}});
    return;
  }
  const tl_real *x = a == cosine ? tl_unaliased(cx, a, cosine, 0) : tl_unaliased(cx, a, sine, 0);
  circle(cx, sine, cosine, x);
  tl_check(cx, sine, TL_FN_sin);
  tl_check(cx, cosine, TL_FN_cos);
}

/* The recurrence of (a/a_0)^(p/q) takes ratios of a's coefficients only: any a_0 will do that is ordinary. */
void tl_sqrt(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!are_ordinary(a[0]) || TL_SOME(a[0] < TL_C(0.0))) {
    one(cx, c, a, TL_LANE_sqrt);
    return;
  }
  VALUES(value, sqrt, a[0]);
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  c[0] = value;
  tl_power_blocks(cx->shape, c, TL_C(1.0), TL_C(2.0), x);
  tl_check(cx, c, TL_FN_sqrt);
}

void tl_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *d) {
  lane_by_lane(cx, &(operation){.function = TL_LANE_fma, .operands = {a, b, d}, .results = {c}});
}

void tl_powc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { with_constant(cx, c, a, x, TL_LANE_powc); }
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b) { with_constant(cx, c, b, x, TL_LANE_rpow); }
void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {
  lane_by_lane(cx, &(operation){.function = TL_LANE_powi, .operands = {a}, .results = {c}, .n = n});
}
void tl_scalbn(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {
  lane_by_lane(cx, &(operation){.function = TL_LANE_scalbn, .operands = {a}, .results = {c}, .n = n});
}

#define ONE(name)                                                                                                                      \
  void tl_##name(tl_ctx *cx, tl_real *c, const tl_real *a) { one(cx, c, a, TL_LANE_##name); }
#define TWO(name)                                                                                                                      \
  void tl_##name(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { two(cx, c, a, b, TL_LANE_##name); }
/* clang-format off */
ONE(cbrt) ONE(expm1) ONE(exp2) ONE(log) ONE(log1p) ONE(log2) ONE(log10) ONE(tan) ONE(asin) ONE(acos) ONE(atan) ONE(sinh) ONE(cosh)
ONE(tanh) ONE(asinh) ONE(acosh) ONE(atanh) ONE(erf) ONE(erfc) ONE(tgamma) ONE(lgamma) ONE(fabs) ONE(floor) ONE(ceil) ONE(trunc)
ONE(round) ONE(rint) ONE(float)
TWO(pow) TWO(hypot) TWO(atan2) TWO(fmin) TWO(fmax) TWO(fdim) TWO(copysign) TWO(fmod) TWO(remainder)
