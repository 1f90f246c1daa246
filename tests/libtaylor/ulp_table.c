/* The table of libtaylor's errors: function by order by worst error in ulp. See HELP for the definitions. */
#include "close.h"
#include "functions.h"
#include "random.h"
#include "reference_function.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char HELP[] =
    "Usage: ulp_table [--points N] [--function NAME] [--no-limits]\n"
    "\n"
    "For each elementary function f, the Taylor coefficients f_k = f^(k)(x)/k!, k = 0..4, computed by libtaylor in the shape T(1,4) at "
    "x + t\n"
    "(functions of two variables: T(2,4) at x + t1, y + t2, all coefficients of order k) are compared with the exact ones. The points "
    "are\n"
    "uniform in the exponent over the whole domain, near zeros, poles and ends of the domain, and a list of hard points.\n"
    "\n"
    "  ulp            |computed - exact| in units of the last place of the exact coefficient\n"
    "  condition      of coefficient k: what a relative error of 1 in x (and y) and in the 1 of the seed does to it, relative to "
    "itself;\n"
    "                 for one variable (|x (k+1) f_(k+1)| + |k f_k|) / |f_k|\n"
    "  well           worst ulp over the points where the condition is at most 4\n"
    "  ill/condition  worst ulp divided by condition over the others\n"
    "\n"
    "Coefficients outside 1e-290 .. 1e300, and those that libtaylor refuses by its status, are left out. Every column has a limit for "
    "each "
    "function;\n"
    "a worst error above it is marked * and the program fails, unless --no-limits.\n";

static const double WELL = 4.0, LARGEST = 1e300, SMALLEST = 1e-290;

enum { MAX_ORDER = 4, NORDER = MAX_ORDER + 1 };

typedef struct worst_errors {
  double well[NORDER], ill[NORDER];
} worst_errors;

/* What is reached over 20000 points, plus about 15 %; 0.51 stands for correctly rounded. The values
 * themselves, order 0, are the C library's. */
typedef struct limits {
  const char *name;
  double well[NORDER], ill;
} limits;
static const limits LIMITS[] = {
    {"sqrt", {0.51, 1.7, 2.1, 3.6, 4.1}, 0.3},     {"cbrt", {3.3, 0.51, 0.51, 0.51, 0.51}, 0.2},
    {"exp", {0.51, 0.51, 0.51, 1.2, 1.2}, 0.4},    {"expm1", {0.9, 0.51, 0.51, 1.2, 1.2}, 0.4},
    {"exp2", {0.51, 1.7, 3.1, 4.6, 4.8}, 1.2},     {"log", {0.51, 0.51, 1.4, 3, 3.4}, 1.2},
    {"log1p", {0.9, 1.7, 3.2, 4.4, 6.6}, 0.9},     {"log2", {0.51, 0.8, 1.6, 3.2, 3.5}, 1.1},
    {"log10", {1.6, 0.9, 1.7, 2.7, 3.9}, 1.0},     {"sin", {0.6, 0.51, 0.6, 1.2, 1.2}, 0.3},
    {"cos", {0.51, 0.6, 0.51, 1.2, 1.2}, 0.3},     {"tan", {0.6, 1.4, 1.9, 2.2, 2.5}, 0.8},
    {"asin", {0.51, 0.51, 0.51, 0.51, 0.51}, 0.2}, {"acos", {0.51, 0.51, 0.51, 0.51, 0.51}, 0.2},
    {"atan", {0.6, 0.51, 0.51, 0.51, 0.51}, 0.2},  {"sinh", {1.8, 1.2, 1.8, 1.9, 2.1}, 0.5},
    {"cosh", {1.2, 1.8, 1.2, 2.1, 1.9}, 0.5},      {"tanh", {2.2, 1.5, 3.2, 2.5, 2.3}, 0.9},
    {"asinh", {1.8, 0.51, 0.51, 0.51, 0.51}, 0.2}, {"acosh", {1.5, 0.51, 0.51, 0.51, 0.51}, 0.4},
    {"atanh", {1.3, 0.51, 0.51, 0.51, 0.51}, 0.2}, {"erf", {1, 2.2, 3, 3.9, 5}, 1.5},
    {"mul", {0.51, 0.51, 0.51, 0.51, 0.51}, 0.2},  {"div", {0.51, 1.6, 2.6, 2.1, 2.5}, 0.7},
    {"pow", {0.51, 1.7, 1.7, 1.7, 1.7}, 0.4},      {"hypot", {0.6, 0.51, 0.51, 0.51, 0.51}, 0.2},
    {"atan2", {0.6, 0.51, 0.51, 0.51, 0.51}, 0.2}, {"erfc", {2.7, 2.2, 3, 3.9, 5}, 1.5},
    {"tgamma", {2.4, 3.5, 2.7, 2.4, 2.5}, 0.9},    {"lgamma", {2.8, 0.6, 0.51, 1.8, 2}, 0.4},
};

static const limits *limits_of(const char *name) {
  for (size_t i = 0; i < sizeof LIMITS / sizeof *LIMITS; i++)
    if (strcmp(LIMITS[i].name, name) == 0) return &LIMITS[i];
  return NULL;
}

static void keep(worst_errors *w, int order, double ulp, double condition) {
  if (condition <= WELL)
    w->well[order] = fmax(w->well[order], ulp);
  else
    w->ill[order] = fmax(w->ill[order], ulp / condition);
}

/* |computed - exact| in units of the last place of exact, a normal number. */
static double ulps(double computed, mpfr_srcptr exact) {
  mpfr_t difference;
  mpfr_init2(difference, REF_PRECISION);
  mpfr_sub_d(difference, exact, computed, MPFR_RNDN);
  const double ulp = fabs(mpfr_get_d(difference, MPFR_RNDN)) / ulp_of(mpfr_get_d(exact, MPFR_RNDZ));
  mpfr_clear(difference);
  return ulp;
}

enum { N = MAX_ORDER + 2 }; /* one order more, for the condition */

static double size_at(mpfr_t *f, int i, int j) { return fabs(mpfr_get_d(f[i * N + j], MPFR_RNDN)); }

/* f: the exact coefficients of h^i g^j at (x, y). */
static void compare(worst_errors *w, const tl_ctx *cx, const double *c, mpfr_t *f, double x, double y) {
  const int nvar = cx->shape->nvar;
  for (int i = 0; i <= MAX_ORDER; i++)
    for (int j = 0; j <= (nvar == 2 ? MAX_ORDER - i : 0); j++) {
      const double size = size_at(f, i, j);
      const double change = fabs(x) * (i + 1) * size_at(f, i + 1, j) + fabs(y) * (j + 1) * size_at(f, i, j + 1);
      if (size < SMALLEST || size > LARGEST || change > LARGEST) continue;
      const double computed = tl_coef(cx->shape, c, 0, (int[]){i, j});
      if (cx->status.bits != TL_OK && !isfinite(computed)) continue; /* refused, not wrong */
      keep(w, i + j, ulps(computed, f[i * N + j]), change / size);
    }
}

static worst_errors measure(const jet_function *f, int points) {
  const ref_function *ref = ref_lookup(f->name);
  worst_errors w = {0};
  jet_space space;
  jet_space_init(&space, tl_complete(f->two ? 2 : 1, MAX_ORDER), 3);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  mpfr_t exact[N * N];
  for (int i = 0; i < N * N; i++) mpfr_init2(exact[i], REF_PRECISION);
  rng r = {2026};
  for (int i = 0; i < points; i++) {
    double x, y;
    ref_draw(ref, &r, &x, &y);
    tl_ctx_clear(cx);
    tl_seed(cx, a, x, 0);
    if (f->two) tl_seed(cx, b, y, 1);
    if (f->two)
      f->two(cx, c, a, b);
    else
      f->one(cx, c, a);
    ref_taylor(ref, x, y, N - 1, exact);
    compare(&w, cx, c, exact, x, y);
  }
  for (int i = 0; i < N * N; i++) mpfr_clear(exact[i]);
  jet_space_free(&space);
  return w;
}

/* Prints one number and whether it keeps its limit; returns 1 where it does not. */
static int print_error_of(double error, double limit) {
  const int above = !(error <= limit);
  printf(" %6.2f%c", error, above ? '*' : ' ');
  return above;
}

static int print_row(const jet_function *f, const worst_errors *w, int with_limits) {
  const limits none = {f->name, {HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL}, HUGE_VAL};
  const limits *l = with_limits ? limits_of(f->name) : &none;
  if (!l) {
    printf("%-6s has no limits\n", f->name);
    return 1;
  }
  int above = 0;
  printf("%-6s", f->name);
  for (int k = 0; k < NORDER; k++) above += print_error_of(w->well[k], l->well[k]);
  printf(" |");
  for (int k = 0; k < NORDER; k++) above += print_error_of(w->ill[k], l->ill);
  printf("\n");
  fflush(stdout);
  return above;
}

int main(int argc, char **argv) {
  int points = 20000, with_limits = 1;
  const char *only = NULL;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--points") == 0 && i + 1 < argc) {
      points = atoi(argv[++i]);
    } else if (strcmp(argv[i], "--function") == 0 && i + 1 < argc) {
      only = argv[++i];
    } else if (strcmp(argv[i], "--no-limits") == 0) {
      with_limits = 0;
    } else {
      fputs(HELP, stderr);
      return 2;
    }
  }
  if (points <= 0 || (only && !ref_lookup(only))) {
    fputs(HELP, stderr);
    return 2;
  }
  points = test_tries(points);
  printf("%d points; worst error in ulp where well-conditioned, order 0..4 | in ulp/condition elsewhere, order 0..4\n", points);
  int above = 0;
  for (int i = 0; i < njet_functions; i++) {
    if (only && strcmp(only, jet_functions[i].name) != 0) continue;
    const worst_errors w = measure(&jet_functions[i], points);
    above += print_row(&jet_functions[i], &w, with_limits);
  }
  return above ? 1 : 0;
}
