/* What every function reports at each end of its domain and at the neighbouring numbers, order by order: the rows of docs/status.md. */
#include "functions.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MAX_ORDER = 7 }; /* above 6 some functions go another way */

/* The place (x,y) and its two neighbours in the argument that moves. */
typedef struct place {
  jet_function f;
  const char *name;
  double x, y;
  enum { X, Y } moves;
} place;

#define ONE(name, where, x) {{#name, tl_##name, NULL, NULL}, where, x, 0.0, X}
#define TWO(name, where, x, y, moves) {{#name, NULL, tl_##name, NULL}, where, x, y, moves}
#define CONSTANT(name, where, x, y, moves) {{#name, NULL, NULL, tl_##name}, where, x, y, moves}

static void rpow_reversed(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { tl_rpow(cx, c, x, a); }
static void scalbn_of_real(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { tl_scalbn(cx, c, a, (int)x); }
static void shift(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { tl_shift(cx, c, a, x); }
static void rdiv_reversed(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { tl_rdiv(cx, c, x, a); }
static void fma_twice(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { tl_fma(cx, c, a, b, a); }

#define HUGE DBL_MAX
static const place PLACES[] = {
    ONE(sqrt, "0", 0.0),
    ONE(cbrt, "0", 0.0),
    ONE(exp, "log of the largest number", 0x1.62e42fefa39efp9),
    ONE(expm1, "log of the largest number", 0x1.62e42fefa39efp9),
    ONE(exp2, "1024", 1024.0),
    ONE(log, "0", 0.0),
    ONE(log2, "0", 0.0),
    ONE(log10, "0", 0.0),
    ONE(log1p, "-1", -1.0),
    ONE(sin, "the largest number", HUGE),
    ONE(cos, "the largest number", HUGE),
    ONE(tan, "next to pi/2", 0x1.921fb54442d18p0),
    ONE(tan, "the largest number", HUGE),
    ONE(asin, "1", 1.0),
    ONE(asin, "-1", -1.0),
    ONE(acos, "1", 1.0),
    ONE(acos, "-1", -1.0),
    ONE(atan, "the largest number", HUGE),
    TWO(atan2, "(0, 0)", 0.0, 0.0, X),
    TWO(atan2, "(0, 0)", 0.0, 0.0, Y),
    TWO(atan2, "the cut, (0, -1)", 0.0, -1.0, X),
    ONE(sinh, "where it overflows", 0x1.633ce8fb9f87dp9),
    ONE(cosh, "where it overflows", 0x1.633ce8fb9f87dp9),
    ONE(tanh, "the largest number", HUGE),
    ONE(asinh, "the largest number", HUGE),
    ONE(acosh, "1", 1.0),
    ONE(atanh, "1", 1.0),
    ONE(atanh, "-1", -1.0),
    ONE(erf, "the largest number", HUGE),
    ONE(erfc, "the largest number", HUGE),
    ONE(tgamma, "0", 0.0),
    ONE(tgamma, "-1", -1.0),
    ONE(tgamma, "where it overflows", 0x1.573fae561f647p7),
    ONE(lgamma, "0", 0.0),
    ONE(lgamma, "-1", -1.0),
    ONE(lgamma, "where it overflows", 0x1.754d9278b51a7p1014),
    TWO(div, "(1, 0)", 1.0, 0.0, Y),
    TWO(div, "(0, 0)", 0.0, 0.0, X),
    CONSTANT(divc, "1 by 0", 1.0, 0.0, Y),
    {{"rdiv", NULL, NULL, rdiv_reversed}, "1 by 0", 0.0, 1.0, X},
    TWO(mul, "(largest number, 1)", HUGE, 1.0, Y),
    TWO(add, "(largest number, 2^970)", HUGE, 0x1p970, Y),
    TWO(sub, "(largest number, -2^970)", HUGE, -0x1p970, Y),
    {{"shift", NULL, NULL, shift}, "(largest number, 2^970)", HUGE, 0x1p970, Y},
    CONSTANT(scale, "(largest number, 1)", HUGE, 1.0, Y),
    {{"fma", NULL, fma_twice, NULL}, "x y + x, (largest number, 2^-54)", HUGE, 0x1p-54, Y},
    TWO(hypot, "(0, 0)", 0.0, 0.0, X),
    TWO(hypot, "(largest number, 0)", HUGE, 0.0, X),
    ONE(fabs, "0", 0.0),
    TWO(fmin, "tie, (1, 1)", 1.0, 1.0, X),
    TWO(fmax, "tie, (1, 1)", 1.0, 1.0, X),
    TWO(fdim, "tie, (1, 1)", 1.0, 1.0, X),
    TWO(copysign, "(0, 1)", 0.0, 1.0, X),
    TWO(copysign, "(1, 0)", 1.0, 0.0, Y),
    ONE(floor, "3", 3.0),
    ONE(floor, "0", 0.0),
    ONE(ceil, "3", 3.0),
    ONE(ceil, "0", 0.0),
    ONE(trunc, "0", 0.0),
    ONE(trunc, "1", 1.0),
    ONE(round, "0", 0.0),
    ONE(round, "0.5", 0.5),
    ONE(rint, "0.5", 0.5),
    ONE(rint, "2.5", 2.5),
    TWO(fmod, "(6, 3)", 6.0, 3.0, X),
    TWO(fmod, "(0, 3)", 0.0, 3.0, X),
    TWO(fmod, "(5, 0)", 5.0, 0.0, Y),
    TWO(remainder, "(4.5, 3)", 4.5, 3.0, X),
    TWO(remainder, "(6, 3)", 6.0, 3.0, X),
    TWO(remainder, "(5, 0)", 5.0, 0.0, Y),
    {{"scalbn", NULL, NULL, scalbn_of_real}, "1 by 2^1023", 1.0, 1023.0, X},
    {{"scalbn", NULL, NULL, scalbn_of_real}, "1 by 2^1024", 1.0, 1024.0, X},
    ONE(float, "the largest float", 0x1.fffffefffffffp127),
    TWO(pow, "(0, 3)", 0.0, 3.0, X),
    TWO(pow, "(0, 0)", 0.0, 0.0, Y),
    TWO(pow, "(-2, 3)", -2.0, 3.0, Y),
    TWO(pow, "(2, 1024)", 2.0, 1024.0, Y),
    CONSTANT(powc, "0^-1", 0.0, -1.0, X),
    CONSTANT(powc, "0^0", 0.0, 0.0, X),
    CONSTANT(powc, "0^0", 0.0, 0.0, Y),
    CONSTANT(powc, "0^0.5", 0.0, 0.5, X),
    CONSTANT(powc, "0^1", 0.0, 1.0, Y),
    CONSTANT(powc, "0^2.5", 0.0, 2.5, X),
    CONSTANT(powc, "0^3", 0.0, 3.0, Y),
    CONSTANT(powc, "(-2)^3", -2.0, 3.0, Y),
    CONSTANT(powc, "(-2)^-1", -2.0, -1.0, X),
    {{"rpow", NULL, NULL, rpow_reversed}, "0^0", 0.0, 0.0, X},
    {{"rpow", NULL, NULL, rpow_reversed}, "0^1", 1.0, 0.0, Y},
    {{"rpow", NULL, NULL, rpow_reversed}, "(-1)^2", 2.0, -1.0, X},
    {{"rpow", NULL, NULL, rpow_reversed}, "2^1024", 1024.0, 2.0, X},
};

static unsigned status_at(const jet_function *f, int order, double x, double y) {
  jet_space space;
  jet_space_init(&space, tl_complete(2, order), 3);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  tl_seed(cx, a, x, 0);
  if (f->two)
    tl_seed(cx, b, y, 1);
  else
    tl_const(cx, b, y);
  jet_apply(f, cx, c, a, b);
  const unsigned bits = cx->status.bits;
  jet_space_free(&space);
  return bits;
}

static const char *name_of(unsigned bits) {
  switch (bits) {
  case TL_OK:
    return "ok";
  case TL_DOMAIN:
    return "DOMAIN";
  case TL_SINGULAR:
    return "SINGULAR";
  case TL_NONFINITE:
    return "NONFINITE";
  default:
    return "?";
  }
}

/* "ok", or "ok, SINGULAR from order 1": the status where it changes with the order. */
static void print_orders(const jet_function *f, double x, double y) {
  unsigned before = status_at(f, 0, x, y);
  printf(" %s", name_of(before));
  for (int order = 1; order <= MAX_ORDER; order++) {
    const unsigned bits = status_at(f, order, x, y);
    if (bits != before) printf(", %s from order %d", name_of(bits), order);
    before = bits;
  }
  printf(" |");
}

int main(void) {
  for (size_t i = 0; i < sizeof PLACES / sizeof *PLACES; i++) {
    const place *p = &PLACES[i];
    printf("| %s | %s%s |", p->f.name, p->name, p->f.one ? "" : p->moves == X ? ", first argument" : ", second argument");
    for (int side = -1; side <= 1; side++) {
      double x = p->x, y = p->y;
      double *moving = p->moves == X ? &x : &y;
      if (side != 0) *moving = nextafter(*moving, side * (double)INFINITY);
      if (isfinite(*moving))
        print_orders(&p->f, x, y);
      else
        printf(" |");
    }
    printf("\n");
  }
  return 0;
}
