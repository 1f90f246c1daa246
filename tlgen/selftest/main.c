/* The options of a test program, and its table. */
#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Some tens of roundings, relative to the scale that check.c says. */
static const double DEFAULT_RTOL = 1e-12;
/* The same in single precision, whose rounding the differences leave out. */
static const double SINGLE_RTOL = 1e-5;
/* Truncation is then about 1e-20 of the fifth derivative, and rounding in a third derivative 1e-19 of the value. */
static const double DEFAULT_STEP = 1e-5;

static void help(const tlgen_selftest *test) {
  printf("usage: %s_selftest [options] [FILE ..]\n\n"
         "Checks every derivative of model \"%s\", the values and orders 1 to 3 of every function, against differences of its C source "
         "in\n"
         "quad precision, at points that you name, and prints the largest error of each order.\n\n"
         "  --params \"NAME=V NAME=V,V ..\"  members of the parameter struct, arrays as lists, nested ones as arm[0].length=1.5;\n"
         "                                 a list that ends in ',..' goes on with its last number\n"
         "  --point \"q=.. qd=.. t=..\"      a point; may be repeated\n"
         "  FILE                           lines 'params ..' and 'point ..' with the same texts; # begins a comment\n"
         "  --rtol R                       largest relative error (default %g)\n"
         "  --order K                      highest order, 0 to %d (default %d)\n"
         "  --step H                       step of the differences (default %g); H times |x| is tried too\n"
         "  --list                         print the members of the parameter struct\n"
         "  --help                         print this\n\n"
         "An error is relative to the largest derivative of that order or below, or to the change of one when a variable doubles.\n"
         "A line says 'unsettled' where the differences themselves do not agree for two steps: a kink is near, or H does not suit.\n"
         "Exit status: 0 all derivatives agree, 1 some do not or are unsettled, 2 wrong usage.\n",
         test->model->name, test->model->name, test->single ? SINGLE_RTOL : DEFAULT_RTOL, MAX_ORDER, MAX_ORDER, DEFAULT_STEP);
}

static void list(const tlgen_selftest *test) {
  static const char *const kinds[] = {"double", "float", "integer", "unsigned integer"};
  for (size_t i = 0; test->params && i < test->params->count; i++) {
    const tlgen_member *m = &test->params->members[i];
    printf("%-30s %s", m->name, kinds[m->kind]);
    if (m->count == 0)
      printf(", any number of them\n");
    else
      printf(m->count > 1 ? ", %zu of them\n" : "\n", m->count);
  }
}

static int usage(const tlgen_selftest *test, const char *what, const char *argument) {
  fprintf(stderr, "%s_selftest: %s%s\nTry '%s_selftest --help'.\n", test->model->name, argument, what, test->model->name);
  return 2;
}

static int number(const char *text, double least, double most, double *x) {
  char *end;
  *x = strtod(text, &end);
  return !*end && end != text && *x >= least && *x <= most;
}

/* Reads the arguments; -1: go on, otherwise the exit status. */
static int parse(int argc, char **argv, input *in, settings *s) {
  for (int i = 1; i < argc; i++) {
    const char *name = argv[i];
    double x = 0.0;
    if (strcmp(name, "--help") == 0) return help(in->test), 0;
    if (strcmp(name, "--list") == 0) return list(in->test), 0;
    if (strncmp(name, "--", 2) != 0) {
      if (!input_read(in, name)) return 2;
      continue;
    }
    if (i + 1 == argc) return usage(in->test, " wants a value (or is no option)", name);
    const char *value = argv[++i];
    if (strcmp(name, "--params") == 0)
      input_add(in, "params", value);
    else if (strcmp(name, "--point") == 0)
      input_add(in, "point", value);
    else if (strcmp(name, "--rtol") == 0 && number(value, 0.0, 1.0, &x))
      s->rtol = x;
    else if (strcmp(name, "--step") == 0 && number(value, 1e-12, 1.0, &x))
      s->step = x;
    else if (strcmp(name, "--order") == 0 && number(value, 0.0, MAX_ORDER, &x) && x == floor(x))
      s->max_order = (int)x;
    else
      return usage(in->test, " is no option, or its value is out of range", name);
  }
  return -1;
}

static int functions(const eom_model *m) { return 3 + m->nholonomic + m->nnonholonomic; }

/* Lagrangian, force, dissipation, then the constraints; without jet where there is none. */
static const eom_function *function(const eom_model *m, int i) {
  const eom_function *single[] = {&m->lagrangian, &m->force, &m->dissipation};
  if (i < 3) return single[i];
  return i < 3 + m->nholonomic ? &m->holonomic[i - 3] : &m->nonholonomic[i - 3 - m->nholonomic];
}

/* Of the column of names. */
static int width(const input *in) {
  int longest = 8;
  for (int i = 0; i < functions(in->test->model); i++) {
    const eom_function *f = function(in->test->model, i);
    if (f->jet && (int)strlen(f->name) > longest) longest = (int)strlen(f->name);
  }
  return longest;
}

static void print_variables(const input *in, const verdict *v, int order) {
  for (int i = 0; i < order; i++) {
    if (v->index[i] == 2 * in->n)
      printf(" t");
    else
      printf(" %s[%d]", v->index[i] < in->n ? "q" : "qd", v->index[i] % in->n);
  }
}

/* One line of the table, and what differs. True where all agree. */
static int print_line(const input *in, const settings *s, const eom_function *f, int order, const verdict *v) {
  const int wrong = v->error > s->rtol;
  if (!v->compared) return 1; /* it has been said why */
  printf("%-*s %5d %11ld  %-9.3g  %s", width(in), f->name, order, v->compared, v->error,
         wrong          ? "WRONG"
         : v->unsettled ? "unsettled"
                        : "ok");
  if (v->unsettled) printf(" (%ld unsettled)", v->unsettled);
  if (v->error > 0.0) {
    printf("  point %d, row %d%s", v->point + 1, v->row + 1, order ? " by" : "");
    print_variables(in, v, order);
  }
  printf("\n");
  if (wrong) printf("    is %.17g, the differences say %.17g\n", v->actual, v->expected);
  return !wrong && !v->unsettled;
}

static int check_model(const input *in, const settings *s) {
  const eom_model *m = in->test->model;
  int good = 1;
  printf("Model %s, %d point%s, n = %d, steps of %g, tolerance %g\n\n", m->name, in->npoints, in->npoints > 1 ? "s" : "", in->n,
         s->step, s->rtol);
  printf("%-*s order derivatives  largest error\n", width(in), "function");
  for (int i = 0, k = 0; i < functions(m); i++) {
    const eom_function *f = function(m, i);
    verdict verdicts[MAX_ORDER + 1] = {{0}};
    if (!f->jet) continue;
    good &= check_function(in, s, f, in->test->functions[k++], i == 1 ? 0.0 : (double)NAN, verdicts);
    for (int order = 0; order <= s->max_order; order++) good &= print_line(in, s, f, order, &verdicts[order]);
  }
  printf("\n%s\n", good ? "All derivatives agree." : "Not all derivatives agree.");
  return good ? 0 : 1;
}

int tlgen_selftest_main(int argc, char **argv, const tlgen_selftest *test) {
  input in = {.test = test};
  settings s = {test->single ? SINGLE_RTOL : DEFAULT_RTOL, DEFAULT_STEP, MAX_ORDER};
  int status = parse(argc, argv, &in, &s);
  if (status < 0 && !in.asked) {
    fprintf(stderr, "%s_selftest: no point is given. Name one or more where the model is smooth, for example\n", test->model->name);
    input_example(test);
    status = 2;
  }
  if (status < 0 && !input_resolve(&in)) status = 2;
  if (status < 0) status = check_model(&in, &s);
  input_free(&in);
  return status;
}
