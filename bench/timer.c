/* Checks contenders against the reference of a case and times them round robin, on the core that the program was pinned to. Prints CSV:
 *   contender,need,way,min_ns,median_ns,repeats,check_error      times per state; empty where the check failed
 *   bench_timer [--check] [--needs FJV] [--repeats R] [--slice MICROSECONDS] MODEL N REFERENCE OBJECT..
 * The contender's number in the CSV is the place of its OBJECT, from 0. --check: no timing, one line for each need. */
#define _POSIX_C_SOURCE 200809L
#include "reference.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ALIGNMENT = 64, BATCHES = BENCH_STATES };

/* Largest difference to the reference, relative to its largest entry. The states' condition leaves 1e-11 to any backward stable solver.
 */
static const double tolerance = 1e-9;

/* Added to each coordinate times the last result: changes no bit of it, but no processor knows. */
static const double link_scale = 1e-300;

typedef struct settings {
  int check_only, repeats;
  double slice; /* s: what one repeat should last */
  const char *needs;
} settings;

/* One loaded contender with its arrays in its own layout. */
typedef struct runner {
  int number;
  bench_contender c;
  int n, native;                                 /* coordinates of the model, and its own */
  double *q[BATCHES], *qd[BATCHES], *w[BATCHES]; /* native, native, 2 native times lanes */
  double *moved;                                 /* native times lanes: the chained coordinates */
  double *qdd, *qdd_y, *dqdd;                    /* native, 4 native^2, native times lanes */
  double error;                                  /* of the need at hand */
  long calls;                                    /* in one repeat */
  double *times;                                 /* of the repeats, ns per state */
} runner;

static void fail(const char *what, const char *which) {
  fprintf(stderr, "bench_timer: %s '%s'\n", what, which);
  exit(1);
}

static double *numbers(size_t count) {
  size_t bytes = (count * sizeof(double) + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  double *x = aligned_alloc(ALIGNMENT, bytes > 0 ? bytes : ALIGNMENT);
  if (x == NULL) fail("no memory for", "arrays");
  memset(x, 0, bytes);
  return x;
}

static int has(const bench_contender *c, char need) {
  return need == 'F' ? c->acceleration != NULL : need == 'J' ? c->jacobian != NULL : c->directional != NULL;
}

static inline int call(const runner *r, char need, const double *q, int batch) {
  const bench_contender *c = &r->c;
  if (need == 'F') return c->acceleration(c->self, q, r->qd[batch], r->qdd);
  if (need == 'J') return c->jacobian(c->self, q, r->qd[batch], r->qdd, r->qdd_y);
  return c->directional(c->self, q, r->qd[batch], r->w[batch], r->qdd, r->dqdd);
}

/* The states of batch b, side by side in the lanes. what: 0 q, 1 qd, 2 w. */
static void gather(double *block, int n, int lanes, int b, double *q, double *qd, double *w) {
  for (int l = 0; l < lanes; l++) {
    bench_state s = bench_block_state(block, n, (b + l) % BENCH_STATES);
    for (int i = 0; i < n; i++) q[i * lanes + l] = s.q[i], qd[i * lanes + l] = s.qd[i];
    for (int i = 0; i < 2 * n; i++) w[i * lanes + l] = s.w[i];
  }
}

static void make_inputs(runner *r, double *block) {
  size_t n = (size_t)r->n, own = (size_t)r->native, lanes = (size_t)r->c.lanes;
  double *q = numbers(n * lanes), *qd = numbers(n * lanes), *w = numbers(2 * n * lanes);
  for (int b = 0; b < BATCHES; b++) {
    r->q[b] = numbers(own * lanes), r->qd[b] = numbers(own * lanes), r->w[b] = numbers(2 * own * lanes);
    gather(block, r->n, r->c.lanes, b, q, qd, w);
    if (r->c.to_native != NULL)
      r->c.to_native(r->c.self, q, qd, w, r->q[b], r->qd[b], r->w[b]);
    else
      gather(block, r->n, r->c.lanes, b, r->q[b], r->qd[b], r->w[b]);
  }
  free(q), free(qd), free(w);
}

/* Returns 0 where the contender does not have the case. */
static int load(runner *r, int number, const char *object, const bench_case *problem, double *block) {
  void *library = dlopen(object, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fail(dlerror(), object);
  int (*start)(const bench_case *, bench_contender *);
  void *symbol = dlsym(library, "bench_open");
  if (symbol == NULL) fail("no bench_open in", object);
  memcpy(&start, &symbol, sizeof start);
  r->number = number, r->n = problem->n;
  r->c = (bench_contender){.lanes = 1};
  if (start(problem, &r->c) != 0) return 0;
  if (r->c.lanes < 1 || r->c.lanes > BENCH_STATES) fail("wrong number of lanes in", object);
  r->native = r->c.coordinates > 0 ? r->c.coordinates : r->n;
  size_t n = (size_t)r->native, lanes = (size_t)r->c.lanes;
  r->moved = numbers(n * lanes), r->qdd = numbers(n * lanes), r->qdd_y = numbers(4 * n * n * lanes), r->dqdd = numbers(n * lanes);
  make_inputs(r, block);
  return 1;
}

/* max |x - truth| / max |truth|; an unequal NaN counts as infinite. */
static double difference(int count, int lanes, const double *x, const double *truth) {
  double worst = 0.0, scale = 0.0;
  for (int i = 0; i < count; i++) {
    double d = fabs(x[i * lanes] - truth[i]);
    worst = d <= worst ? worst : isnan(d) ? HUGE_VAL : d;
    scale = fmax(scale, fabs(truth[i]));
  }
  return worst / scale;
}

static double check_lane(const runner *r, char need, const bench_state *s, int lane) {
  int n = r->n, lanes = r->c.lanes;
  double error = difference(n, lanes, r->qdd + lane, s->qdd);
  if (need == 'J') error = fmax(error, difference(2 * n * n, lanes, r->qdd_y + lane, s->qdd_y));
  if (need == 'V') error = fmax(error, difference(n, lanes, r->dqdd + lane, s->dqdd));
  return error;
}

static void forget(const runner *r) {
  size_t n = (size_t)r->native, lanes = (size_t)r->c.lanes;
  for (size_t i = 0; i < n * lanes; i++) r->qdd[i] = r->dqdd[i] = (double)NAN;
  for (size_t i = 0; i < 4 * n * n * lanes; i++) r->qdd_y[i] = (double)NAN;
}

/* The largest error of a need over all states. */
static double check(runner *r, char need, double *block) {
  size_t n = (size_t)r->n, lanes = (size_t)r->c.lanes;
  double *q = numbers(n * lanes), *qd = numbers(n * lanes), *w = numbers(2 * n * lanes), error = 0.0;
  for (int b = 0; b < BATCHES; b++) {
    forget(r);
    if (call(r, need, r->q[b], b) != 0) error = HUGE_VAL;
    gather(block, r->n, r->c.lanes, b, q, qd, w);
    if (r->c.from_native != NULL) r->c.from_native(r->c.self, need, q, qd, r->qdd, r->qdd_y, r->dqdd);
    for (int l = 0; l < r->c.lanes; l++) {
      bench_state s = bench_block_state(block, r->n, (b + l) % BENCH_STATES);
      error = fmax(error, check_lane(r, need, &s, l));
    }
  }
  free(q), free(qd), free(w);
  return error;
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Independent states, one after the other. */
static void run_throughput(const runner *r, char need, long calls) {
  for (long k = 0; k < calls; k++) call(r, need, r->q[k % BATCHES], (int)(k % BATCHES));
}

/* What the next state hangs on: the first and the last number of a result, whichever a contender computes last. */
static inline double last_result(const runner *r, char need) {
  int n = r->native;
  if (need == 'F') return r->qdd[0] + r->qdd[n - 1];
  if (need == 'J') return r->qdd_y[0] + r->qdd_y[2 * n * n - 1];
  return r->dqdd[0] + r->dqdd[n - 1];
}

/* Every coordinate of a state waits for the result of the state before. */
static void run_latency(const runner *r, char need, long calls) {
  for (long k = 0; k < calls; k++) {
    const double *q = r->q[k % BATCHES];
    double link = link_scale * last_result(r, need);
    for (int i = 0; i < r->native; i++) r->moved[i] = q[i] + link;
    call(r, need, r->moved, (int)(k % BATCHES));
  }
}

static double duration(const runner *r, char need, int chained, long calls) {
  double start = now();
  (chained ? run_latency : run_throughput)(r, need, calls);
  return now() - start;
}

/* Enough calls to fill a slice; doubled until half of it is measured, which also warms everything up. */
static void calibrate(runner *r, char need, int chained, double slice) {
  double lasted;
  for (r->calls = 1; (lasted = duration(r, need, chained, r->calls)) < slice / 2; r->calls *= 2) continue;
  r->calls = (long)fmax(1.0, (double)r->calls * slice / lasted);
}

/* One repeat; before it a few calls that bring the contender's code and data back. */
static double repeat(const runner *r, char need, int chained) {
  duration(r, need, chained, r->calls / 16);
  return 1e9 * duration(r, need, chained, r->calls) / (double)r->calls / r->c.lanes;
}

static int ascending(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void print(const runner *r, char need, int chained, int repeats) {
  qsort(r->times, (size_t)repeats, sizeof *r->times, ascending);
  printf("%d,%c,%s,%.2f,%.2f,%d,%.2g\n", r->number, need, chained ? "latency" : "throughput", r->times[0], r->times[repeats / 2],
         repeats, r->error);
}

/* Times all runners that take part, one repeat of each in turn. */
static void race(runner *runners, int count, char need, int chained, const settings *set) {
  for (int i = 0; i < count; i++) calibrate(&runners[i], need, chained, set->slice);
  for (int k = 0; k < set->repeats; k++)
    for (int i = 0; i < count; i++) runners[i].times[k] = repeat(&runners[i], need, chained);
  for (int i = 0; i < count; i++) print(&runners[i], need, chained, set->repeats);
  fflush(stdout);
}

static int passes(const runner *r) { return r->error <= tolerance || (r->c.approximate && isfinite(r->error)); }

/* Moves those that have the need, pass its check and can run this way to the front; returns their number. A chain of states that wait
 * for each other has no batches. */
static int select_runners(runner *all, int count, char need, int chained, runner *chosen) {
  int m = 0;
  for (int i = 0; i < count; i++)
    if (has(&all[i].c, need) && passes(&all[i]) && !(chained && all[i].c.lanes > 1)) chosen[m++] = all[i];
  return m;
}

static void run_need(runner *all, int count, char need, double *block, const settings *set) {
  runner *chosen = calloc((size_t)count + 1, sizeof *chosen);
  if (chosen == NULL) fail("no memory for", "runners");
  for (int i = 0; i < count; i++) {
    if (!has(&all[i].c, need)) continue;
    all[i].error = check(&all[i], need, block);
    if (set->check_only || !passes(&all[i])) printf("%d,%c,check,,,0,%.2g\n", all[i].number, need, all[i].error);
  }
  for (int chained = 0; chained < 2 && !set->check_only; chained++)
    race(chosen, select_runners(all, count, need, chained, chosen), need, chained, set);
  free(chosen);
}

static double *read_block(const char *path, int n) {
  double *block = numbers(bench_block_size(n));
  FILE *file = fopen(path, "rb");
  if (file == NULL || fread(block, sizeof *block, bench_block_size(n), file) != bench_block_size(n)) fail("cannot read", path);
  fclose(file);
  return block;
}

/* Options into *set; the index of the first other argument. */
static int read_options(int argc, char **argv, settings *set) {
  int i = 1;
  for (; i < argc && strncmp(argv[i], "--", 2) == 0; i++) {
    const char *value = i + 1 < argc ? argv[i + 1] : "";
    if (strcmp(argv[i], "--check") == 0) {
      set->check_only = 1;
      continue;
    }
    if (strcmp(argv[i], "--needs") == 0)
      set->needs = value;
    else if (strcmp(argv[i], "--repeats") == 0)
      set->repeats = atoi(value);
    else if (strcmp(argv[i], "--slice") == 0)
      set->slice = 1e-6 * atof(value);
    else
      fail("unknown option", argv[i]);
    i++;
  }
  return i;
}

int main(int argc, char **argv) {
  settings set = {.repeats = 11, .slice = 1e-3, .needs = "FJV"};
  int first = read_options(argc, argv, &set);
  int n = argc > first + 3 ? atoi(argv[first + 1]) : 0;
  if (n < 1 || set.repeats < 1 || !(set.slice > 0))
    fail("usage: bench_timer [OPTION..] MODEL N REFERENCE OBJECT.., not", argv[argc - 1]);
  static double *block;
  static runner *all; /* contenders and what they were given live until the process ends */
  block = read_block(argv[first + 2], n);
  bench_case problem = {argv[first], n, block[0], block + 1, block + 1 + n};
  int objects = argc - first - 3, count = 0;
  all = calloc((size_t)objects, sizeof *all);
  if (all == NULL) fail("no memory for", "runners");
  for (int i = 0; i < objects; i++) count += load(&all[count], i, argv[first + 3 + i], &problem, block);
  for (int i = 0; i < count; i++) all[i].times = numbers((size_t)set.repeats);
  for (const char *need = set.needs; *need != '\0'; need++) run_need(all, count, *need, block, &set);
  return 0;
}
