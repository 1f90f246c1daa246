/* The motion functions of one model against its jets: every need at random states or at those of a reference file, the solved forms
 * against the general solver, parameters against differences.
 *   check [REFERENCE]     prints the largest error of each need; exit 1 where one is beyond its limit, 3 where there are no functions */
#include "reference.h"
#include "subject.h"

#include "eom/eom.h"
#include "evaluate.h"
#include "random.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Two groupings of the same sums, relative to the largest number that enters: some thousand roundings. */
static const double RTOL = 1e-12;

/* Differences of order 8 in double: step^8 of truncation beside rounding by the step. */
static const double DIFFERENCE_STEP = 2e-2, DIFFERENCE_RTOL = 1e-8;

enum { RANDOM_STATES = 8, MOST_FAULTS = 10, DIRECTIONS = 3 };

static int faults;

typedef struct needs_error {
  double energy, simulate, residual, linearise, tangent, parameters, acceleration, jacobian, directional, constrained, lanes;
} needs_error;

static needs_error worst;

/* ---- a state and what is computed at it ---- */

typedef struct subject {
  eom_system *calls;
  const eom_motion *f;
  void *params; /* a copy that may change */
  tl_real *work;
  double *q, *qd, *qdd, *lambda, t; /* qdd and lambda are any numbers */
  double force;                     /* size of the forces that meet in r */
  double rtol;                      /* RTOL, but more where the state is ill-conditioned */
} subject;

static double *numbers(int count) {
  double *a = calloc((size_t)count + 1, sizeof *a);
  if (!a) exit(EXIT_FAILURE);
  return a;
}

static double largest(const double *a, int count) {
  double most = 0;
  for (int i = 0; i < count; i++) most = fmax(most, fabs(a[i]));
  return most;
}

/* Errors relative to the largest expected number, or to size where that is more. */
static void compare(double *error, const char *what, const double *actual, const double *expected, int rows, int columns, double size,
                    double limit) {
  const double scale = fmax(largest(expected, rows * columns), size);
  for (int i = 0; i < rows * columns; i++) {
    const double difference = fabs(actual[i] - expected[i]);
    const double relative = difference == 0 ? 0 : difference / scale;
    if (relative <= limit) {
      *error = fmax(*error, relative);
      continue;
    }
    *error = (double)INFINITY;
    if (++faults > MOST_FAULTS) continue;
    fprintf(stderr, "%s[%d][%d]: %.17g, by calls %.17g, difference %.3g, scale %.3g\n", what, i / columns, i % columns, actual[i],
            expected[i], difference, scale);
  }
}

/* Whether a motion function did what calls can do here. */
static bool ran(const char *what, int code) {
  if (code == 0) return true;
  if (++faults <= MOST_FAULTS) fprintf(stderr, "%s: code %d\n", what, code);
  return false;
}

static void check_energy(const subject *s) {
  eom_system *c = s->calls;
  double *p = numbers(c->n), *rate = numbers(c->n), lagrangian, energy;
  if (s->f->energy && eom_energy(c, s->q, s->qd, s->t) == EOM_OK &&
      ran("energy", s->f->energy(s->params, s->q, s->qd, s->t, p, rate, &lagrangian, &energy, s->work))) {
    const double speed = largest(s->qd, c->n), size = fmax(fabs(c->lagrangian), largest(c->momentum, c->n) * speed);
    compare(&worst.energy, "momentum", p, c->momentum, 1, c->n, 0, s->rtol);
    compare(&worst.energy, "momentum_rate", rate, c->momentum_rate, 1, c->n, s->force, s->rtol);
    compare(&worst.energy, "lagrangian", &lagrangian, &c->lagrangian, 1, 1, size, s->rtol);
    compare(&worst.energy, "energy", &energy, &c->energy, 1, 1, size, s->rtol);
  }
  free(p);
  free(rate);
}

static void check_simulate(const subject *s) {
  const eom_system *c = s->calls;
  const int n = c->n, m = c->m;
  const eom_parts out = {.M = numbers(n * n),
                         .Q = numbers(n),
                         .phi = numbers(c->m1),
                         .phi_dot = numbers(c->m1),
                         .psi = numbers(c->m2),
                         .A = numbers(m * n),
                         .b = numbers(m)};
  if (s->f->simulate && ran("simulate", s->f->simulate(s->params, s->q, s->qd, s->t, &out, s->work))) {
    compare(&worst.simulate, "M", out.M, c->M, n, n, 0, s->rtol);
    compare(&worst.simulate, "Q", out.Q, c->Q, 1, n, s->force, s->rtol);
    compare(&worst.simulate, "phi", out.phi, c->phi, 1, c->m1, 1, s->rtol);
    compare(&worst.simulate, "phi_dot", out.phi_dot, c->phi_dot, 1, c->m1, 1, s->rtol);
    compare(&worst.simulate, "psi", out.psi, c->psi, 1, c->m2, 1, s->rtol);
    compare(&worst.simulate, "A", out.A, c->A, m, n, 0, s->rtol);
    compare(&worst.simulate, "b", out.b, c->b, 1, m, 1, s->rtol);
    for (int i = 0; i < n; i++)
      for (int j = 0; j < i; j++) compare(&worst.simulate, "M'", &out.M[i * n + j], &out.M[j * n + i], 1, 1, 0, 0);
  }
  free(out.M), free(out.Q), free(out.phi), free(out.phi_dot), free(out.psi), free(out.A), free(out.b);
}

static void check_residual(const subject *s) {
  double *actual = numbers(s->calls->n), *expected = numbers(s->calls->n);
  if (s->f->residual && eom_residual(s->calls, expected, s->qdd, s->q, s->qd, s->t) == EOM_OK &&
      ran("residual", s->f->residual(s->params, s->q, s->qd, s->t, s->qdd, actual, s->work)))
    compare(&worst.residual, "r", actual, expected, 1, s->calls->n, s->force, s->rtol);
  free(actual), free(expected);
}

/* r_y, g_y by calls, row-major. */
static void by_calls(const subject *s, double *r_y, double *g_y) {
  const eom_workspace *ws = s->calls->workspace;
  const int n = s->calls->n, m = s->calls->m;
  for (int j = 0; j < 2 * n; j++) {
    for (int i = 0; i < n; i++) r_y[i * 2 * n + j] = -ws->rhs1[j * n + i];
    for (int i = 0; i < m; i++) g_y[i * 2 * n + j] = -ws->rhs2[j * m + i];
  }
}

static void check_linearise(const subject *s, const double *r_y, const double *g_y) {
  const int n = s->calls->n, m = s->calls->m;
  double *r = numbers(2 * n * n), *g = numbers(2 * n * m);
  if (s->f->linearise && ran("linearise", s->f->linearise(s->params, s->q, s->qd, s->t, s->qdd, s->lambda, r, g, s->work))) {
    compare(&worst.linearise, "r_y", r, r_y, n, 2 * n, s->force, s->rtol);
    compare(&worst.linearise, "g_y", g, g_y, m, 2 * n, 1, s->rtol);
  }
  free(r), free(g);
}

/* c = a w for a (rows x d), w (d x k). */
static void multiply(int rows, int d, int k, double *c, const double *a, const double *w) {
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < k; j++) {
      c[i * k + j] = 0;
      for (int l = 0; l < d; l++) c[i * k + j] += a[i * d + l] * w[l * k + j];
    }
}

static void check_tangent(const subject *s, const double *r_y, const double *g_y, const double *w, int k) {
  const int n = s->calls->n, m = s->calls->m;
  double *r = numbers(n * k), *g = numbers(m * k), *r_w = numbers(n * k), *g_w = numbers(m * k);
  multiply(n, 2 * n, k, r_w, r_y, w);
  multiply(m, 2 * n, k, g_w, g_y, w);
  if (s->f->tangent && ran("tangent", s->f->tangent(s->params, s->q, s->qd, s->t, s->qdd, s->lambda, k, w, r, g, s->work))) {
    compare(&worst.tangent, "r_w", r, r_w, n, k, fmax(s->force, largest(r_y, 2 * n * n)), s->rtol);
    compare(&worst.tangent, "g_w", g, g_w, m, k, fmax(1, largest(g_y, 2 * n * m)), s->rtol);
  }
  free(r), free(g), free(r_w), free(g_w);
}

/* ---- solved forms ---- */

/* Where calls find M positive definite by far, errors may grow by its condition; where they do not, the solved forms must say so. */
static void check_solved(const subject *s, const double *w, int k) {
  eom_system *c = s->calls;
  const int n = c->n;
  double *qdd = numbers(n), *qdd_y = numbers(2 * n * n), *dqdd = numbers(n * k), *expected = numbers(n * k);
  const eom_status status = eom_linearise(c, s->q, s->qd, s->t);
  const double limit = s->rtol / c->report.pivot;
  const int a = s->f->acceleration(s->params, s->q, s->qd, s->t, qdd, s->work);
  if (status != EOM_OK) {
    if (a != EOM_MOTION_PIVOT) ran("acceleration without inertia", a ? a : 99);
  } else if (ran("acceleration", a)) {
    compare(&worst.acceleration, "qdd", qdd, c->qdd, 1, n, 0, limit);
    if (s->f->jacobian && ran("jacobian", s->f->jacobian(s->params, s->q, s->qd, s->t, qdd, qdd_y, s->work))) {
      compare(&worst.jacobian, "qdd with its derivative", qdd, c->qdd, 1, n, 0, limit);
      compare(&worst.jacobian, "qdd_y", qdd_y, c->qdd_y, n, 2 * n, 0, limit / c->report.pivot);
    }
    multiply(n, 2 * n, k, expected, c->qdd_y, w);
    if (s->f->directional && ran("directional", s->f->directional(s->params, s->q, s->qd, s->t, k, w, qdd, dqdd, s->work))) {
      compare(&worst.directional, "qdd with directions", qdd, c->qdd, 1, n, 0, limit);
      compare(&worst.directional, "dqdd", dqdd, expected, n, k, largest(c->qdd_y, 2 * n * n), limit / c->report.pivot);
    }
  }
  free(qdd), free(qdd_y), free(dqdd), free(expected);
}

/* The solved form of constrained equations squares the condition of the rows. It may give way where the equations are not well
 * conditioned, and only there. */
static void check_constrained(const subject *s) {
  eom_system *c = s->calls;
  const int n = c->n, m = c->m;
  double *qdd = numbers(n), *lambda = numbers(m), *Qc = numbers(n);
  const eom_status status = eom_acceleration(c, s->q, s->qd, s->t);
  const int code = s->f->constrained(s->params, s->q, s->qd, s->t, qdd, lambda, Qc, s->work);
  const double of_rows = c->report.condition * c->report.condition;
  if (status != EOM_OK || c->report.rank < m || c->report.weighted) {
    if (code != EOM_MOTION_PIVOT) ran("constrained equations that are not safe", code ? code : 99);
  } else if (code != EOM_MOTION_PIVOT || (of_rows < 10 && c->report.pivot > 0.1)) {
    const double limit = s->rtol * of_rows / c->report.pivot, size = largest(c->Qc, n);
    if (ran("constrained", code)) {
      compare(&worst.constrained, "qdd", qdd, c->qdd, 1, n, 0, limit);
      compare(&worst.constrained, "lambda", lambda, c->lambda, 1, m, 0, limit);
      compare(&worst.constrained, "Qc", Qc, c->Qc, 1, n, size, limit);
    }
  }
  free(qdd), free(lambda), free(Qc);
}

/* ---- lanes ---- */

/* Numbers of lanes: element i of lane l is at [i*lanes + l]. */
static tl_real *lane_numbers(int count, int lanes) {
  tl_real *a = aligned_alloc(EOM_MOTION_ALIGNMENT, (size_t)(count * lanes + EOM_MOTION_ALIGNMENT) * sizeof *a / EOM_MOTION_ALIGNMENT *
                                                       EOM_MOTION_ALIGNMENT);
  if (!a) exit(EXIT_FAILURE);
  memset(a, 0, (size_t)(count * lanes) * sizeof *a);
  return a;
}

static void take_lane(int count, int lanes, int lane, double *to, const tl_real *from) {
  for (int i = 0; i < count; i++) to[i] = from[i * lanes + lane];
}

/* The functions for several states at once, at this state and near ones, against those for one. */
static void check_lanes(const subject *s, const double *w, int k) {
  const eom_motion *f = s->f;
  const int n = s->calls->n, lanes = f->lanes;
  tl_real *q = lane_numbers(n, lanes), *qd = lane_numbers(n, lanes), *t = lane_numbers(1, lanes), *all_w = lane_numbers(2 * n * k, lanes);
  tl_real *qdd = lane_numbers(n, lanes), *qdd_y = lane_numbers(2 * n * n, lanes), *dqdd = lane_numbers(n * k, lanes);
  tl_real *work = lane_numbers((int)f->work, lanes);
  double *one = numbers(n), *one_d = numbers(n), *expected = numbers(n), *derivative = numbers(n * (2 * n > k ? 2 * n : k));
  double *actual = numbers(n * (2 * n > k ? 2 * n : k));
  int code = 0;
  for (int l = 0; l < lanes; l++) {
    t[l] = s->t;
    for (int i = 0; i < n; i++) q[i * lanes + l] = s->q[i] * (1 + 1e-3 * l), qd[i * lanes + l] = s->qd[i] * (1 - 1e-3 * l);
    for (int i = 0; i < 2 * n * k; i++) all_w[i * lanes + l] = w[i];
  }
#define LANES(a) ((const tl_lanes *)(const void *)(a))
#define OUT(a) ((tl_lanes *)(void *)(a))
  const int acceleration = f->acceleration_lanes ? f->acceleration_lanes(s->params, LANES(q), LANES(qd), LANES(t), OUT(qdd), OUT(work)) : 0;
  const int jacobian =
      f->jacobian_lanes ? f->jacobian_lanes(s->params, LANES(q), LANES(qd), LANES(t), OUT(qdd), OUT(qdd_y), OUT(work)) : acceleration;
  const int directional = f->directional_lanes ? f->directional_lanes(s->params, LANES(q), LANES(qd), LANES(t), k, LANES(all_w), OUT(qdd),
                                                                      OUT(dqdd), OUT(work))
                                               : acceleration;
  for (int l = 0; l < lanes; l++) {
    take_lane(n, lanes, l, one, q), take_lane(n, lanes, l, one_d, qd);
    const int alone = f->acceleration(s->params, one, one_d, s->t, expected, s->work);
    code = code ? code : alone;
    if (alone != 0 || acceleration != 0) continue;
    const double limit = s->rtol / s->calls->report.pivot;
    take_lane(n, lanes, l, actual, qdd);
    compare(&worst.lanes, "qdd of a lane", actual, expected, 1, n, 0, 10 * limit);
    if (f->jacobian && f->jacobian_lanes && f->jacobian(s->params, one, one_d, s->t, expected, derivative, s->work) == 0) {
      take_lane(2 * n * n, lanes, l, actual, qdd_y);
      compare(&worst.lanes, "qdd_y of a lane", actual, derivative, n, 2 * n, 0, 10 * limit / s->calls->report.pivot);
    }
    if (f->directional && f->directional_lanes && f->directional(s->params, one, one_d, s->t, k, w, expected, derivative, s->work) == 0) {
      take_lane(n * k, lanes, l, actual, dqdd);
      compare(&worst.lanes, "dqdd of a lane", actual, derivative, n, k, largest(qdd_y, 2 * n * n * lanes), 10 * limit / s->calls->report.pivot);
    }
  }
  if (f->acceleration_lanes && (acceleration != 0) != (code != 0)) ran("lanes fail where a state does, and only there", acceleration ? acceleration : 99);
  if (acceleration == 0) ran("jacobian of lanes", jacobian), ran("directional of lanes", directional);
  free(q), free(qd), free(t), free(all_w), free(qdd), free(qdd_y), free(dqdd), free(work);
  free(one), free(one_d), free(expected), free(derivative), free(actual);
}

/* ---- parameters ---- */

/* (r - A' lambda, A qdd - b) by calls at the parameters as they are. */
static bool balance(const subject *s, double *rows) {
  eom_system *c = s->calls;
  const int n = c->n, m = c->m;
  if (eom_assemble(c, s->q, s->qd, s->t) != EOM_OK) return false;
  for (int i = 0; i < n; i++) {
    rows[i] = -c->Q[i];
    for (int j = 0; j < n; j++) rows[i] += c->M[i * n + j] * s->qdd[j];
    for (int r = 0; r < m; r++) rows[i] -= c->A[r * n + i] * s->lambda[r];
  }
  for (int r = 0; r < m; r++) {
    rows[n + r] = -c->b[r];
    for (int j = 0; j < n; j++) rows[n + r] += c->A[r * n + j] * s->qdd[j];
  }
  return true;
}

/* Column k of the derivative of balance by differences of order 8. */
static bool difference(const subject *s, int k, double *column) {
  static const double weight[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  const int rows = s->calls->n + s->calls->m;
  double *p = (double *)((char *)s->params + subject_offset[k]), *side = numbers(rows);
  const double value = *p, h = DIFFERENCE_STEP * fmax(fabs(value), 1);
  bool good = true;
  memset(column, 0, (size_t)rows * sizeof *column);
  for (int i = 1; i <= 4; i++)
    for (int sign = -1; sign <= 1; sign += 2) {
      *p = value + sign * i * h;
      good = good && balance(s, side);
      for (int r = 0; r < rows; r++) column[r] += sign * weight[i - 1] * side[r] / h;
    }
  *p = value;
  free(side);
  return good;
}

static void check_parameters(const subject *s) {
  const int n = s->calls->n, m = s->calls->m, np = s->f->np;
  if (np != subject_noffset) {
    faults++;
    fprintf(stderr, "%d parameters, %d expected\n", np, subject_noffset);
    return;
  }
  double *r_p = numbers(n * np), *g_p = numbers(m * np), *column = numbers(n + m), *actual = numbers(n + m);
  if (ran("parameters", s->f->parameters(s->params, s->q, s->qd, s->t, s->qdd, s->lambda, r_p, g_p, s->work)))
    for (int k = 0; k < np; k++) {
      if (!difference(s, k, column)) continue;
      for (int i = 0; i < n; i++) actual[i] = r_p[i * np + k];
      for (int i = 0; i < m; i++) actual[n + i] = g_p[i * np + k];
      compare(&worst.parameters, s->f->parameter[k], actual, column, 1, n + m, s->force, DIFFERENCE_RTOL);
    }
  free(r_p), free(g_p), free(column), free(actual);
}

/* ---- a whole state ---- */

/* Where calls have no value there is nothing to compare with. */
static void check_state(subject *s, rng *r) {
  eom_system *c = s->calls;
  const int n = c->n, m = c->m;
  for (int i = 0; i < n; i++) s->qdd[i] = rng_uniform(r, -1, 1);
  for (int i = 0; i < m; i++) s->lambda[i] = rng_uniform(r, -1, 1);
  if (eom_assemble(c, s->q, s->qd, s->t) != EOM_OK) return;
  s->force = fmax(largest(c->Q, n), largest(c->M, n * n));
  check_simulate(s);
  check_energy(s);
  check_residual(s);
  double *r_y = numbers(2 * n * n), *g_y = numbers(2 * n * m), *w = numbers(2 * n * DIRECTIONS);
  for (int i = 0; i < 2 * n * DIRECTIONS; i++) w[i] = rng_uniform(r, -1, 1);
  memcpy(c->qdd, s->qdd, (size_t)n * sizeof *c->qdd);
  for (int i = 0; i < m; i++) c->lambda[i] = s->lambda[i];
  if (eom_linearised_terms(c, s->q, s->qd, s->t) == EOM_OK) {
    by_calls(s, r_y, g_y);
    check_linearise(s, r_y, g_y);
    check_tangent(s, r_y, g_y, w, 1);
    check_tangent(s, r_y, g_y, w, DIRECTIONS);
    if (s->f->acceleration) check_solved(s, w, DIRECTIONS);
    if (s->f->acceleration) check_solved(s, w, 1);
    if (s->f->acceleration && s->f->lanes) check_lanes(s, w, DIRECTIONS);
    if (s->f->constrained) check_constrained(s);
    if (s->f->parameters) check_parameters(s);
  }
  free(r_y), free(g_y), free(w);
}

static void check_random(subject *s, rng *r) {
  s->rtol = RTOL;
  for (int k = 0; k < RANDOM_STATES; k++) {
    for (int i = 0; i < s->calls->n; i++) {
      s->q[i] = rng_uniform(r, -1, 1);
      s->qd[i] = rng_uniform(r, -1, 1);
    }
    s->t = rng_uniform(r, -1, 1);
    check_state(s, r);
  }
}

/* Each side may be off by condition * DBL_EPSILON. */
static double limit_of(const point *p) {
  double condition = 1;
  for (int i = 0; i < p->nblock; i++) condition = fmax(condition, p->blocks[i].condition);
  return strcmp(p->kind, "generic") == 0 ? RTOL : fmax(RTOL, 2 * condition * DBL_EPSILON);
}

static void check_points(subject *s, rng *r, const char *path) {
  const int n = s->calls->n;
  reference points = reference_read(path);
  for (int i = 0; i < points.npoint; i++) {
    memcpy(s->q, points.points[i].state, (size_t)n * sizeof *s->q);
    memcpy(s->qd, points.points[i].state + n, (size_t)n * sizeof *s->qd);
    s->t = points.points[i].state[2 * n];
    s->rtol = limit_of(&points.points[i]);
    check_state(s, r);
  }
  reference_free(&points);
}

static eom_system *start(const void *params, unsigned needs, eom_emitter emitter) {
  eom_options options = eom_options_default();
  options.needs = needs;
  options.emitter = emitter;
  eom_system *sys;
  if (eom_system_create(&sys, subject_model(), params, &options) == EOM_OK) return sys;
  fprintf(stderr, "no system of model %s\n", subject_model()->name);
  exit(3);
}

static void print_errors(int lanes) {
  printf("%s: energy %.0e  simulate %.0e  residual %.0e  linearise %.0e  tangent %.0e  parameters %.0e  acceleration %.0e  jacobian "
         "%.0e  directional %.0e  constrained %.0e  %d lanes %.0e\n",
         subject_model()->name, worst.energy, worst.simulate, worst.residual, worst.linearise, worst.tangent, worst.parameters,
         worst.acceleration, worst.jacobian, worst.directional, worst.constrained, lanes, worst.lanes);
}

int main(int argc, char **argv) {
  const size_t size = subject_model()->params_size;
  void *params = size > 0 ? malloc(size) : NULL;
  if (params) memcpy(params, subject_params(), size);
  eom_system *by_motion = start(params, EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT, EOM_EMITTER_AUTO);
  const eom_motion *f = by_motion->motion;
  if (!f) {
    fprintf(stderr, "no motion functions of model %s\n", subject_model()->name);
    return 3;
  }
  subject s = {.calls = start(params, EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL, EOM_EMITTER_CALLS), .f = f, .params = params};
  s.q = numbers(f->n), s.qd = numbers(f->n), s.qdd = numbers(f->n), s.lambda = numbers(s.calls->m);
  s.work = aligned_alloc(EOM_MOTION_ALIGNMENT, (f->work * sizeof(tl_real) / EOM_MOTION_ALIGNMENT + 1) * EOM_MOTION_ALIGNMENT);
  rng r = {20161104};
  if (argc > 1)
    check_points(&s, &r, argv[1]);
  else
    check_random(&s, &r);
  print_errors(f->lanes);
  eom_system_destroy(by_motion);
  eom_system_destroy(s.calls);
  free(s.q), free(s.qd), free(s.qdd), free(s.lambda), free(s.work), free(params);
  return faults ? EXIT_FAILURE : EXIT_SUCCESS;
}
