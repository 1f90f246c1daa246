/* The table of libtaylor's errors: function by order by worst error in ulp. See HELP for the definitions. */
#include "close.h"
#include "formulas.h"
#include "functions.h"
#include "reference_series.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char HELP[] =
    "Usage: ulp_table [--points N] [--function NAME] [--no-limits] [--rivals] [--markdown] [--worst]\n"
    "\n"
    "For each elementary function f, the Taylor coefficients f_k = f^(k)(x)/k!, k = 0..6, computed by libtaylor in the shape T(1,6) "
    "at\n"
    "x + t (functions of two variables: T(2,6) at x + t1, y + t2, all coefficients of order k) are compared with the exact ones. A "
    "third\n"
    "of the points are uniform in the exponent over all numbers, subnormal ones too, where f has a value; the others are uniform in "
    "the\n"
    "exponent near zeros, poles and ends of the domain, or come from a list of hard points.\n"
    "\n"
    "  ulp            |computed - exact| in units of the last place of the exact coefficient; below the normal numbers in units of "
    "the\n"
    "                 smallest subnormal one\n"
    "  condition      of coefficient k: what a relative error of 1 in x (and y) does to it, relative to itself; for one variable\n"
    "                 |x (k+1) f_(k+1)| / |f_k|\n"
    "  well           worst ulp over the points where the condition is at most 4 + k\n"
    "  ill/condition  worst ulp divided by condition over the others\n"
    "  silent, refused  points where a coefficient is beyond the range of numbers and the status is OK; and where it is not OK "
    "although\n"
    "                 all coefficients are within\n"
    "\n"
    "--rivals adds the same for other people's formulas (formulas.h), at those points alone where x and y are between 1e-50 and 1e50 "
    "in\n"
    "size, beyond which most of them overflow: one that has lost all digits is shown as inf. --worst prints the worst points.\n"
    "libtaylor's worst errors above a limit are marked *, and the program fails, unless --no-limits.\n";

enum { MAX_ORDER = FORMULA_ORDER, NORDER = MAX_ORDER + 1, N = MAX_ORDER + 2 /* one order more, for the condition */, MAX_ROW = 4 };

static const double WELL = 4.0;

/* A worst error and where it was. */
typedef struct worst_error {
  double error, x, y;
} worst_error;

/* Errors of one row of the table. */
typedef struct row {
  const char *school, *function;
  const formula *rival; /* null: libtaylor */
  worst_error well[NORDER], ill[NORDER];
  long silent, refused;
} row;

/* What libtaylor may reach: to order 3 and to order 6 where well-conditioned, over condition elsewhere. Over 100000 points it reaches
 * these less some 15 %; at most the goals of 4 and 16 ulp. The values themselves, order 0, are the C library's. */
typedef struct limits {
  const char *name;
  double low, high, ill;
} limits;
static const limits LIMITS[] = {
    {"sqrt", 4, 6.8, 0.2},    {"cbrt", 3.6, 0.9, 0.2},  {"exp", 1.2, 2.2, 0.3},  {"expm1", 1.2, 2.2, 0.3}, {"exp2", 1.8, 1.4, 0.4},
    {"log", 3, 5.9, 0.2},     {"log1p", 0.9, 0.9, 0.3}, {"log2", 2.9, 6.4, 0.3}, {"log10", 3.2, 6, 0.4},   {"sin", 1.2, 2.2, 0.3},
    {"cos", 1.2, 2.2, 0.3},   {"tan", 2.9, 5.1, 0.5},   {"asin", 0.6, 0.7, 0.3}, {"acos", 0.6, 0.7, 0.3},  {"atan", 0.9, 0.9, 0.2},
    {"sinh", 1.9, 3, 0.6},    {"cosh", 2.2, 3, 0.5},    {"tanh", 2.5, 1.4, 0.3}, {"asinh", 1.8, 0.9, 0.2}, {"acosh", 1.5, 0.9, 0.6},
    {"atanh", 1.4, 0.6, 0.3}, {"erf", 2.2, 2.2, 0.5},   {"erfc", 3.5, 2.2, 0.7}, {"tgamma", 4, 4.1, 0.9},  {"lgamma", 3.3, 3.4, 0.9},
    {"mul", 0.6, 0.6, 0.2},   {"div", 3.1, 10, 0.3},    {"pow", 2.2, 3.1, 0.5},  {"hypot", 1, 1, 0.2},     {"atan2", 1, 1, 0.3},
    {"powc", 1.8, 3.2, 1},    {"rpow", 1.7, 1.7, 1},
};

static const limits *limits_of(const char *name) {
  for (size_t i = 0; i < sizeof LIMITS / sizeof *LIMITS; i++)
    if (strcmp(LIMITS[i].name, name) == 0) return &LIMITS[i];
  return NULL;
}

static void keep(worst_error *w, double error, double x, double y) {
  if (error <= w->error) return;
  *w = (worst_error){isnan(error) ? HUGE_VAL : error, x, y};
}

/* Exponent of the unit of the last place of x. */
static long ulp_exponent(mpfr_srcptr x) {
  const long least = DBL_MIN_EXP - DBL_MANT_DIG;
  const long e = mpfr_zero_p(x) ? least : mpfr_get_exp(x) - DBL_MANT_DIG;
  return e < least ? least : e;
}

static double ulps(double computed, mpfr_srcptr exact) {
  mpfr_t difference;
  if (!isfinite(computed)) return HUGE_VAL;
  mpfr_init2(difference, REF_PRECISION);
  mpfr_sub_d(difference, exact, computed, MPFR_RNDN);
  mpfr_mul_2si(difference, difference, -ulp_exponent(exact), MPFR_RNDN);
  const double ulp = fabs(mpfr_get_d(difference, MPFR_RNDN));
  mpfr_clear(difference);
  return ulp;
}

static long double size_at(mpfr_t *f, int i, int j) { return fabsl(mpfr_get_ld(f[i * N + j], MPFR_RNDN)); }

static int is_beyond_range(mpfr_srcptr x) {
  return mpfr_inf_p(x) || (mpfr_regular_p(x) && mpfr_cmpabs_ui(x, 0) > 0 && mpfr_get_exp(x) > DBL_MAX_EXP);
}

/* Where a coefficient comes from: libtaylor's jet, or a plain series. */
typedef struct result {
  const tl_shape *shape;
  const double *jet;
  const plain_series *series;
} result;

static double computed_at(const result *r, int i, int j) {
  return r->series ? r->series->c[i][j] : r->jet[tl_index(r->shape, 0, (int[]){i, j})];
}

/* f: the exact coefficients of h^i g^j at (x, y). */
static void compare(row *w, const result *r, int two, mpfr_t *f, double x, double y) {
  for (int i = 0; i <= MAX_ORDER; i++)
    for (int j = 0; j <= (two ? MAX_ORDER - i : 0); j++) {
      const long double size = size_at(f, i, j);
      const long double change = fabsl((long double)x) * (long double)(i + 1) * size_at(f, i + 1, j) +
                                 (two ? fabsl((long double)y) * (long double)(j + 1) * size_at(f, i, j + 1) : 0.0L);
      const double ulp = ulps(computed_at(r, i, j), f[i * N + j]);
      const long double unit = ldexpl(1.0L, (int)ulp_exponent(f[i * N + j])), steps = unit / (change * 0x1p-53L);
      const long double error = (long double)ulp * steps;
      if (change <= (long double)(WELL + i + j) * size || change < (long double)DBL_MIN)
        keep(&w->well[i + j], ulp, x, y);
      else
        keep(&w->ill[i + j], (double)error, x, y);
    }
}

static int is_beyond_range_in(mpfr_t *f, int two) {
  for (int i = 0; i <= MAX_ORDER; i++)
    for (int j = 0; j <= (two ? MAX_ORDER - i : 0); j++)
      if (is_beyond_range(f[i * N + j])) return 1;
  return 0;
}

/* Everything that one point needs. */
typedef struct measurement {
  const jet_function *f;
  const ref_function *ref;
  jet_space space;
  tl_real *a, *b, *c;
  mpfr_t exact[N * N];
  int nrow;
  row *rows; /* rows[0]: libtaylor's */
} measurement;

static void measure_library(measurement *m, double x, double y) {
  tl_ctx *cx = &m->space.cx;
  row *w = &m->rows[0];
  const int two = m->f->two != NULL, beyond = is_beyond_range_in(m->exact, two);
  tl_ctx_clear(cx);
  tl_seed(cx, m->a, x, 0);
  if (two)
    tl_seed(cx, m->b, y, 1);
  else
    tl_const(cx, m->b, y);
  jet_apply(m->f, cx, m->c, m->a, m->b);
  if (cx->status.bits == TL_OK && !beyond)
    compare(w, &(result){m->space.cx.shape, m->c, NULL}, two, m->exact, x, y);
  else if (cx->status.bits == TL_OK)
    w->silent++;
  else if (!beyond)
    w->refused++;
}

static int is_moderate(double x) { return x == 0.0 || (fabs(x) > 1e-50 && fabs(x) < 1e50); }

static void measure_rival(measurement *m, row *w, double x, double y) {
  if (!is_moderate(x) || !is_moderate(y) || is_beyond_range_in(m->exact, m->f->two != NULL)) return;
  plain_series a = {.c = {{x}}}, b = {.c = {{y}}}, c;
  a.c[1][0] = 1.0;
  if (m->f->two) b.c[0][1] = 1.0;
  if (w->rival->one)
    w->rival->one(&c, &a);
  else
    w->rival->two(&c, &a, &b);
  compare(w, &(result){NULL, NULL, &c}, m->f->two != NULL, m->exact, x, y);
}

static void measure(measurement *m, int points) {
  rng r = {2026};
  for (int i = 0; i < points; i++) {
    double x, y;
    if (i % 3 == 0)
      ref_draw_anywhere(m->ref, &r, &x, &y);
    else
      ref_draw(m->ref, &r, &x, &y);
    ref_series(m->ref, x, y, N - 1, m->exact);
    measure_library(m, x, y);
    for (int k = 1; k < m->nrow; k++) measure_rival(m, &m->rows[k], x, y);
  }
}

/* Fills the rows of one function; returns how many. */
static int fill_rows(row *rows, const jet_function *f, int points, int rivals) {
  measurement m = {.f = f, .ref = ref_lookup(f->name), .rows = rows, .nrow = 1};
  memset(rows, 0, MAX_ROW * sizeof *rows);
  rows[0] = (row){.school = "libtaylor", .function = f->name};
  for (int i = 0; rivals && i < nformulas; i++)
    if (strcmp(formulas[i].function, f->name) == 0)
      rows[m.nrow++] = (row){.school = formulas[i].school, .function = f->name, .rival = &formulas[i]};
  jet_space_init(&m.space, tl_complete(f->two ? 2 : 1, MAX_ORDER), 3);
  m.a = tl_push(&m.space.cx, 1);
  m.b = tl_push(&m.space.cx, 1);
  m.c = tl_push(&m.space.cx, 1);
  for (int i = 0; i < N * N; i++) mpfr_init2(m.exact[i], REF_PRECISION);
  measure(&m, points);
  for (int i = 0; i < N * N; i++) mpfr_clear(m.exact[i]);
  jet_space_free(&m.space);
  return m.nrow;
}

/* How the table is printed. */
typedef struct style {
  int with_limits, markdown, worst;
} style;

/* Prints one number and whether it keeps its limit; returns 1 where it does not. */
static int print_error_of(double error, double limit, const style *how) {
  const int above = !(error <= limit);
  char text[32];
  if (error < 99.5)
    snprintf(text, sizeof text, "%.1f", error);
  else if (error < 4e15)
    snprintf(text, sizeof text, "%.0e", error);
  else
    snprintf(text, sizeof text, "inf");
  printf(how->markdown ? "%s%s | " : "%6s%s", text, above ? "*" : how->markdown ? "" : " ");
  return above;
}

static void print_worst(const row *w) {
  for (int k = 0; k < NORDER; k++)
    printf("    order %d: well %.3g at (%.17g, %.17g), ill %.3g at (%.17g, %.17g)\n", k, w->well[k].error, w->well[k].x, w->well[k].y,
           w->ill[k].error, w->ill[k].x, w->ill[k].y);
}

/* The worst over all orders. */
static double worst_of(const worst_error *w) {
  double worst = 0.0;
  for (int k = 0; k < NORDER; k++) worst = fmax(worst, w[k].error);
  return worst;
}

static int print_row(const row *w, const style *how) {
  const limits none = {w->function, HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const limits *l = how->with_limits && !w->rival ? limits_of(w->function) : &none;
  if (!l) {
    printf("%-6s has no limits\n", w->function);
    return 1;
  }
  int above = 0;
  printf(how->markdown ? "| %s | %s | " : "%-6s %-12s", w->rival ? "" : w->function, w->school);
  for (int k = 0; k < NORDER; k++) above += print_error_of(w->well[k].error, k <= 3 ? l->low : l->high, how);
  if (how->markdown)
    above += print_error_of(worst_of(w->ill), l->ill, how);
  else
    printf(" |");
  for (int k = 0; k < NORDER && !how->markdown; k++) above += print_error_of(w->ill[k].error, l->ill, how);
  if (w->rival)
    printf(how->markdown ? "| |\n" : "\n");
  else
    printf(how->markdown ? "%ld | %ld |\n" : " | %ld %ld\n", w->silent, w->refused);
  if (how->worst) print_worst(w);
  fflush(stdout);
  return above + (how->with_limits && (w->silent || w->refused));
}

int main(int argc, char **argv) {
  int points = 20000, rivals = 0;
  style how = {.with_limits = 1};
  const char *only = NULL;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--points") == 0 && i + 1 < argc) {
      points = atoi(argv[++i]);
    } else if (strcmp(argv[i], "--function") == 0 && i + 1 < argc) {
      only = argv[++i];
    } else if (strcmp(argv[i], "--no-limits") == 0) {
      how.with_limits = 0;
    } else if (strcmp(argv[i], "--rivals") == 0) {
      rivals = 1;
    } else if (strcmp(argv[i], "--markdown") == 0) {
      how.markdown = 1;
    } else if (strcmp(argv[i], "--worst") == 0) {
      how.worst = 1;
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
  if (!how.markdown)
    printf(
        "%d points; worst error in ulp where well-conditioned, order 0..6 | in ulp/condition elsewhere, order 0..6 | silent, refused\n",
        points);
  int above = 0;
  for (int i = 0; i < njet_functions; i++) {
    row rows[MAX_ROW];
    if (only && strcmp(only, jet_functions[i].name) != 0) continue;
    const int nrow = fill_rows(rows, &jet_functions[i], points, rivals);
    for (int k = 0; k < nrow; k++) above += print_row(&rows[k], &how);
  }
  return above ? 1 : 0;
}
