/* The main of one program of a batch: the model's numbers by every way there is, beside the reference, at random smooth points.
 *
 * Prints one line per way and group, "PROGRAM way group error", the largest relative to the scale of reference.h; a line "PROGRAM FAULT
 * .." for what is wrong, and a last line "PROGRAM done POINTS SOLVED". The batch calls tlgen_selftest_main of each program with the
 * program's name, the text of its parameters and the numbers of the parameters by which a derivative is wanted. */
#include "contender.h"
#include "random.h"
#include "rounding.h"

#include "eom/motion.h"

#include "selftest/input.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Third derivatives of some hundred operations lose four to five digits where a program is unkind. */
static const double RTOL = 1e-10;

/* What the reference may be wrong by without being taken for the error of what it is held against. */
static const double REFERENCE_RTOL = 1e-11;

enum { POINTS = 2, ATTEMPTS = 16, DIRECTIONS = 3, MAX_FAULTS = 5 };

static const fuzz_contender contenders[] = {{"calls", contender_calls}, {"motion", contender_motion}, {"runtime", contender_runtime}};
enum { CONTENDERS = sizeof contenders / sizeof *contenders };

typedef struct outcome {
  const char *program;
  int points, solved; /* compared; and of these with accelerations */
  int rough, too_large, rounded, faults;
  int motions, parameters;                    /* whether there are motion functions; and parameters of derivatives */
  double error[CONTENDERS][FUZZ_GROUP_COUNT]; /* negative where never compared */
} outcome;

static int rows_of(const eom_function *f, int count, const void *params) {
  int rows = 0;
  for (int i = 0; i < count; i++) rows += f[i].rows(params);
  return rows;
}

static fuzz_model model_of(const input *in, const int *parameters, int np) {
  const eom_model *m = in->test->model;
  const int m1 = rows_of(m->holonomic, m->nholonomic, in->params), m2 = rows_of(m->nonholonomic, m->nnonholonomic, in->params);
  return (fuzz_model){in->test, in->params, in->quad_params, parameters, {in->n, m1, m2, m1 + m2, DIRECTIONS, np}};
}

static void fill(rng *r, double *x, int count) {
  for (int i = 0; i < count; i++) x[i] = rng_uniform(r, -1.0, 1.0);
}

static fuzz_point point_start(const fuzz_sizes *s) {
  const int n = s->n;
  double *memory = input_memory((size_t)(4 * n + 1 + s->m + 2 * n * s->k), sizeof *memory);
  return (fuzz_point){memory, memory + 2 * n + 1, memory + 3 * n + 1, memory + 4 * n + 1, memory + 4 * n + 1 + s->m};
}

static void point_draw(rng *r, const fuzz_sizes *s, const fuzz_point *p) {
  fill(r, p->x, 2 * s->n + 1);
  fill(r, p->trial, s->n);
  fill(r, p->lambda, s->m);
  fill(r, p->w, 2 * s->n * s->k);
}

static void fault(outcome *o, const char *way, const char *text) {
  if (++o->faults <= MAX_FAULTS) printf("%s FAULT %s: %s\n", o->program, way, text);
}

static double error_of(double actual, double expected, double scale) {
  const double difference = fabs(actual - expected);
  return difference == 0.0 ? 0.0 : isnan(difference) ? HUGE_VAL : difference / scale;
}

/* The place of the largest error of a group. */
static int worst(const fuzz_numbers *actual, const fuzz_numbers *expected, int group, double scale) {
  const double *const a = actual->group[group], *const e = expected->group[group];
  int place = 0;
  for (int i = 1; i < fuzz_group_size(&expected->sizes, group); i++)
    if (error_of(a[i], e[i], scale) > error_of(a[place], e[place], scale)) place = i;
  return place;
}

static int both_have(const fuzz_numbers *actual, const fuzz_numbers *expected, int group) {
  return actual->group[group] && expected->group[group] && fuzz_group_size(&expected->sizes, group);
}

/* What numbers are held against, what their errors are relative to, and how large these may be. */
typedef struct expectation {
  fuzz_numbers numbers;
  double scale[FUZZ_GROUP_COUNT], limit[FUZZ_GROUP_COUNT];
} expectation;

static int agrees(const fuzz_numbers *actual, const expectation *expected) {
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) {
    const fuzz_numbers *const e = &expected->numbers;
    if (!both_have(actual, e, g)) continue;
    const int i = worst(actual, e, g, expected->scale[g]);
    if (!(error_of(actual->group[g][i], e->group[g][i], expected->scale[g]) <= expected->limit[g])) return 0;
  }
  return 1;
}

static void note(outcome *o, int way, const fuzz_numbers *actual, const expectation *expected) {
  char text[200];
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) {
    if (!both_have(actual, &expected->numbers, g)) continue;
    const double scale = expected->scale[g];
    const int i = worst(actual, &expected->numbers, g, scale), columns = fuzz_group_columns(&actual->sizes, g);
    const double a = actual->group[g][i], e = expected->numbers.group[g][i], error = error_of(a, e, scale);
    o->error[way][g] = fmax(o->error[way][g], error);
    if (error <= expected->limit[g]) continue;
    snprintf(text, sizeof text, "%s[%d][%d] is %.17g, not %.17g; scale %.3g", fuzz_group_name(g), i / columns, i % columns, a, e,
             scale);
    fault(o, contenders[way].name, text);
  }
}

/* What every way computes at a point. */
typedef struct computed {
  fuzz_numbers numbers[CONTENDERS];
  char refusal[CONTENDERS][400]; /* empty where there are numbers */
} computed;

static void compute(computed *c, const fuzz_model *m, const fuzz_point *p, const fuzz_numbers *expected) {
  for (int way = 0; way < CONTENDERS; way++) {
    fuzz_numbers *v = &c->numbers[way];
    fuzz_numbers_start(v, m->sizes);
    for (int g = 0; g < FUZZ_GROUP_COUNT; g++)
      if (!expected->group[g]) v->group[g] = NULL;
    c->refusal[way][0] = '\0';
    contenders[way].compute(m->test->model, m->params, p, v, c->refusal[way], sizeof c->refusal[way]);
  }
}

static void compare(outcome *o, const computed *c, const expectation *expected) {
  o->points++;
  o->solved += expected->numbers.group[FUZZ_QDD] != NULL;
  for (int way = 0; way < CONTENDERS; way++) {
    if (*c->refusal[way])
      fault(o, contenders[way].name, c->refusal[way]);
    else
      note(o, way, &c->numbers[way], expected);
  }
}

static int all_agree(const computed *c, const expectation *expected) {
  for (int way = 0; way < CONTENDERS; way++)
    if (!*c->refusal[way] && !agrees(&c->numbers[way], expected)) return 0;
  return 1;
}

static void forget(computed *c) {
  for (int way = 0; way < CONTENDERS; way++) fuzz_numbers_free(&c->numbers[way]);
}

/* Allows errors as large as roundings of the state have for effect. */
static fuzz_smoothness allow_moves(const fuzz_model *m, const fuzz_point *p, expectation *expected) {
  double moves[FUZZ_GROUP_COUNT];
  const fuzz_smoothness smoothness = reference_moves(m, p, expected->scale, moves);
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) expected->limit[g] = fmax(RTOL, moves[g]);
  return smoothness;
}

/* With the finer reference where the first does not agree; then with what is known of the point, but not where the source itself in
 * double does not agree either. */
static void check_point(outcome *o, const fuzz_model *m, const fuzz_point *p) {
  expectation expected;
  computed c;
  bool rounded = false;
  fuzz_numbers_start(&expected.numbers, m->sizes);
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) expected.limit[g] = RTOL;
  fuzz_smoothness smoothness = reference_evaluate(m, p, &expected.numbers, expected.scale);
  if (smoothness == FUZZ_SMOOTH) {
    compute(&c, m, p, &expected.numbers);
    if (!all_agree(&c, &expected)) {
      smoothness = reference_refine(m, p, REFERENCE_RTOL, &expected.numbers, expected.scale);
      forget(&c);
      compute(&c, m, p, &expected.numbers); /* at the accelerations that the finer reference has found */
    }
    if (smoothness == FUZZ_SMOOTH && !all_agree(&c, &expected)) {
      rounded = rounding_prevails(m, p, RTOL, expected.scale);
      smoothness = allow_moves(m, p, &expected);
    }
    if (smoothness == FUZZ_SMOOTH && !rounded) compare(o, &c, &expected);
    forget(&c);
  }
  o->rounded += rounded;
  o->rough += smoothness == FUZZ_ROUGH && !rounded;
  o->too_large += smoothness == FUZZ_TOO_LARGE && !rounded;
  fuzz_numbers_free(&expected.numbers);
}

static void print_outcome(const outcome *o) {
  for (int way = 0; way < CONTENDERS; way++)
    for (int g = 0; g < FUZZ_GROUP_COUNT; g++)
      if (o->error[way][g] >= 0.0) printf("%s %s %s %.3g\n", o->program, contenders[way].name, fuzz_group_name(g), o->error[way][g]);
  printf("%s done %d points %d solved %d rough %d large %d rounded %d motions %d parameters\n", o->program, o->points, o->solved,
         o->rough, o->too_large, o->rounded, o->motions, o->parameters);
}

static int check(const char *program, const fuzz_model *m) {
  outcome o = {.program = program, .motions = contender_find_motion(m->test->model, m->params) != NULL, .parameters = m->sizes.np};
  rng r = {20160829};
  for (int i = 0; i < CONTENDERS * FUZZ_GROUP_COUNT; i++) o.error[i / FUZZ_GROUP_COUNT][i % FUZZ_GROUP_COUNT] = -1.0;
  const fuzz_point p = point_start(&m->sizes);
  for (int attempt = 0; attempt < ATTEMPTS && o.points < POINTS; attempt++) {
    point_draw(&r, &m->sizes, &p);
    check_point(&o, m, &p);
  }
  free(p.x);
  print_outcome(&o);
  return o.faults > 0;
}

/* The place in the parameter struct's numbers of "p->mass[2]", counted through its members; -1 where there is none. */
static int place_of(const tlgen_params *params, const char *text) {
  const char *name = strstr(text, "->") ? strstr(text, "->") + 2 : text;
  const size_t length = strcspn(name, "[");
  int place = name[length] ? atoi(name + length + 1) : 0;
  for (size_t i = 0; i < params->count; i++) {
    const tlgen_member *member = &params->members[i];
    if (strlen(member->name) == length && strncmp(member->name, name, length) == 0) return place;
    place += (int)member->count;
  }
  return -1;
}

/* The parameters by which the motion functions give derivatives: their number, and their places. */
static int parameters_of(const input *in, int *places) {
  const eom_motion *motion = contender_find_motion(in->test->model, in->params);
  if (!motion || !motion->parameters || motion->np > FUZZ_MAX_PARAMETERS) return 0;
  for (int k = 0; k < motion->np; k++) {
    places[k] = place_of(in->test->params, motion->parameter[k]);
    if (places[k] < 0) return 0;
  }
  return motion->np;
}

/* argv: the program's name, and the text of its parameters (empty: none). */
int tlgen_selftest_main(int argc, char **argv, const tlgen_selftest *test) {
  input in = {.test = test};
  int places[FUZZ_MAX_PARAMETERS];
  if (argc != 2) return 2;
  if (*argv[1]) input_add(&in, "params", argv[1]);
  if (!input_resolve(&in)) {
    printf("%s FAULT run: wrong parameters\n", argv[0]);
    return 1;
  }
  const int np = parameters_of(&in, places);
  const fuzz_model m = model_of(&in, places, np);
  const int bad = check(argv[0], &m);
  input_free(&in);
  return bad;
}
