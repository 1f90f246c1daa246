/* The computed equations beside the closed form: at one state as numbers, at many as the largest relative error. */
#include "agreement.h"

#include "central_field_reduced_tl.h"
#include "central_field_tl.h"
#include "host/message.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

const double agreement_bound = 1e-13;

enum { N = 4 };

const eom_model *model_of(kinetic kind) { return kind == KINETIC_FULL ? &central_field_model : &central_field_reduced_model; }

static int failed(const eom_system *sys, eom_status status) {
  char text[2000];
  complain("no accelerations: %s", eom_status_text(status));
  if (sys != NULL && eom_report_text(&sys->report, text, sizeof text) > 0) fputs(text, stderr);
  return -1;
}

/* What is compared, by name: where the system has it, where the closed form has it, rows, columns. */
typedef struct part {
  const char *name, *equation;
  const double *computed, *by_hand;
  int rows, columns;
} part;

enum { PARTS = 5 };

static void list_parts(part parts[PARTS], const eom_system *sys, const equations *e) {
  parts[0] = (part){"M", "eq 67", sys->M, e->M, N, N};
  parts[1] = (part){"Q", "eq 68", sys->Q, e->Q, N, 1};
  parts[2] = (part){"A", "eq 69", sys->A, e->A, 1, N};
  parts[3] = (part){"b", "eq 70", sys->b, e->b, 1, 1};
  parts[4] = (part){"qdd", "eq 71", sys->qdd, e->qdd, N, 1};
}

static double relative_error(const part *p) {
  double difference = 0.0, largest = 0.0;
  for (int i = 0; i < p->rows * p->columns; i++) {
    double d = fabs(p->computed[i] - p->by_hand[i]);
    if (!(d <= difference)) difference = d;
    largest = fmax(largest, fabs(p->by_hand[i]));
  }
  double error = difference / largest;
  return isfinite(error) ? error : HUGE_VAL;
}

/* Without a sign on zero. */
static void print_entry(double x) { printf(" %12.8f", x + 0.0); }

static void print_part(const part *p) {
  for (int i = 0; i < p->rows; i++) {
    printf("  %-4s", i == 0 ? p->name : "");
    for (int j = 0; j < p->columns; j++) print_entry(p->computed[i * p->columns + j]);
    printf("%*s", 13 * (N - p->columns) + 4, "");
    for (int j = 0; j < p->columns; j++) print_entry(p->by_hand[i * p->columns + j]);
    if (i == 0) printf("%*s%s", 13 * (N - p->columns) + 2, "", p->equation);
    putchar('\n');
  }
}

int print_agreement(kinetic kind) {
  const struct central_field p = {.m = 2.0, .mu = 1.5};
  const double q[N] = {1.25, 0.48, 0.60, 0.64}, qd[N] = {0.3, 0.8, -0.64, 0.0};
  part parts[PARTS];
  eom_system *sys;
  eom_status status = eom_system_create(&sys, model_of(kind), &p, NULL);
  if (status == EOM_OK) status = eom_assemble(sys, q, qd, 0.0);
  if (status == EOM_OK) status = eom_solve(sys);
  if (status != EOM_OK) {
    failed(sys, status);
    eom_system_destroy(sys);
    return -1;
  }
  equations e = closed_form(kind, q, qd, &p);
  list_parts(parts, sys, &e);
  printf("At m = 2, mu = 1.5, r = 1.25, u = (0.48, 0.60, 0.64), rd = 0.3, ud = (0.8, -0.64, 0):\n");
  printf("       %-55s%s\n", "computed from the Lagrangian and the constraint", "by hand");
  for (int i = 0; i < PARTS; i++) print_part(&parts[i]);
  eom_system_destroy(sys);
  return 0;
}

/* Uniform in 0..1 (xorshift64*): the same states in every run. */
static double uniform(uint64_t *state) {
  *state ^= *state >> 12;
  *state ^= *state << 25;
  *state ^= *state >> 27;
  return (double)((*state * 2685821657736338717u) >> 11) * 0x1p-53;
}

static double between(uint64_t *state, double low, double high) { return low + (high - low) * uniform(state); }
static double scale_between(uint64_t *state, double low, double high) { return exp(between(state, log(low), log(high))); }

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* |u| = 1, then ud without its part along u. */
static void onto_manifold(double *u, double *ud) {
  double length = sqrt(dot(u, u));
  for (int i = 0; i < 3; i++) u[i] /= length;
  double along = dot(u, ud);
  for (int i = 0; i < 3; i++) ud[i] -= along * u[i];
}

static void random_state(uint64_t *state, bool manifold, double *q, double *qd, struct central_field *p) {
  p->m = scale_between(state, 0.1, 10.0);
  p->mu = scale_between(state, 0.1, 10.0);
  q[0] = scale_between(state, 0.1, 10.0);
  qd[0] = between(state, -1.0, 1.0);
  do
    for (int i = 1; i < N; i++) q[i] = between(state, -1.0, 1.0);
  while (dot(q + 1, q + 1) < 0.25);
  for (int i = 1; i < N; i++) qd[i] = between(state, -1.0, 1.0);
  if (manifold) onto_manifold(q + 1, qd + 1);
}

/* Raises worst[] to the errors met with one choice of W. */
static int compare(kinetic kind, const double *weight, int states, double worst[PARTS]) {
  struct central_field p = {1.0, 1.0};
  eom_options options = eom_options_default();
  eom_system *sys;
  uint64_t random = 20160101;
  options.weights = weight;
  eom_status status = eom_system_create(&sys, model_of(kind), &p, &options);
  for (int k = 0; k < states && status == EOM_OK; k++) {
    double q[N], qd[N];
    part parts[PARTS];
    random_state(&random, k % 2 == 0, q, qd, &p);
    status = eom_assemble(sys, q, qd, 0.0);
    if (status == EOM_OK) status = eom_solve(sys);
    equations e = closed_form(kind, q, qd, &p);
    list_parts(parts, sys, &e);
    for (int i = 0; i < PARTS; i++) worst[i] = fmax(worst[i], relative_error(&parts[i]));
  }
  if (status != EOM_OK) failed(sys, status);
  eom_system_destroy(sys);
  return status == EOM_OK ? 0 : -1;
}

int print_errors(kinetic kind, int states) {
  static const char *const names[PARTS] = {"M", "Q", "A", "b", "qdd"};
  double worst[PARTS] = {0}, largest = 0.0;
  if (compare(kind, NULL, states, worst) != 0) return -1;
  for (int power = -8; power <= 8; power += 2) {
    double weight = pow(10.0, power);
    if (compare(kind, &weight, states, worst) != 0) return -1;
  }
  printf("Largest relative error at %d random states, W automatic and from 1e-8 to 1e8:\n ", states);
  for (int i = 0; i < PARTS; i++) {
    printf(" %s %.1e%s", names[i], worst[i], i + 1 < PARTS ? "," : "\n");
    largest = fmax(largest, worst[i]);
  }
  if (largest <= agreement_bound) return 0;
  complain("the computed equations differ from the closed form by more than %g", agreement_bound);
  return -1;
}
