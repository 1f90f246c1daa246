/* Differences of the functions of a model in quad precision.
 *
 * With the motion q(s) = q + s qd + s^2/2 qdd, qd(s) = qd + s qdd, t(s) = t + s and the momentum u_i = dL/dqd_i:
 *
 *   r = d/ds dL/dqd - dL/dq - Gamma - A'lambda = M qdd - Q - A'lambda,   g = d^2/ds^2 phi, d/ds psi = A qdd - b   at s = 0,
 *
 * first derivatives by (f(x-2h) - 8 f(x-h) + 8 f(x+h) - f(x+2h))/(12h), of error h^4/30 f'''''. */
#include "reference.h"
#include "path.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

typedef __float128 quad;

/* h: a third derivative has a rounding error of 1e-34/h^3 = 1e-16, and a truncation error of 3e-26 of the fifth derivative. Where the
 * function is so steep that this shows, a quarter of it serves besides: rounding is then 1e-14 of a value that is small beside its
 * derivatives. */
static const quad STEP = 0x1p-20Q, SHORTER_STEP = 0x1p-22Q;

/* With N(h) = N + a h^4 + b h^6 + .., N(4h) - N(h) = 255 a h^4, and N(h) + (N(h) - N(4h))/255 = N - 16 b h^6. Of a function with slopes
 * near s the terms are near (hs)^4 and (hs)^6. */
static const double EXTRAPOLATION = 1.0 / 255.0, NEXT_TERM = 16.0;

/* Beyond these the equations are not solved, so that the solution is good for 1e-12 and better. */
static const double LARGEST_CONDITION = 1e4, SMALLEST_PIVOT = 1e-3;

/* A number above this in a model of numbers near 1 comes from a pole or from growth without bound. */
static const double LARGEST_NUMBER = 1e6;

/* Of a number of the state, relative: some hundred operations, each with a rounding of 2^-53 at random, add up to ten of these. */
static const double ROUNDINGS = 0x1p-49;

static const double CANCELLATION = 1e-3;

enum {
  MAX_N = 8,
  MAX_COLUMNS = FUZZ_MAX_PARAMETERS,
  MAX_X = 2 * MAX_N + 1,
  MAX_M = 4,
  MAX_K = MAX_N + MAX_M,
  MAX_FUNCTIONS = 2 + MAX_M,
  MOVED_STATES = 4
};

static const struct {
  int shift, weight; /* weight / (12h) */
} first[] = {{-2, 1}, {-1, -8}, {1, 8}, {2, -1}}, second[] = {{-2, -1}, {-1, 16}, {0, -30}, {1, 16}, {2, -1}};
enum { FIRST = 4, SECOND = 5 };

typedef struct evaluation {
  const fuzz_model *model;
  int n, m1, m2, m;
  uint64_t path[MAX_FUNCTIONS]; /* of each function at the centre */
  bool known[MAX_FUNCTIONS];
  bool rough;
  quad h;
  quad *moved, centre; /* a parameter that is being moved, and where it belongs */
  jmp_buf give_up;
} evaluation;

static int function_count(const eom_model *m) { return 1 + (m->force.jet != NULL) + m->nholonomic + m->nnonholonomic; }

/* Function number f of those that the model has: Lagrangian, force, holonomic, nonholonomic constraints. */
static const eom_function *function(const eom_model *m, int f) {
  if (f == 0) return &m->lagrangian;
  if (m->force.jet && --f == 0) return &m->force;
  return f <= m->nholonomic ? &m->holonomic[f - 1] : &m->nonholonomic[f - 1 - m->nholonomic];
}

static void call(evaluation *e, int f, quad *out, const quad *x) {
  quad copy[MAX_X];
  memcpy(copy, x, (size_t)(2 * e->n + 1) * sizeof *x);
  path_start(&e->give_up);
  e->model->test->functions[f](out, copy, copy + e->n, copy[2 * e->n], e->model->quad_params);
  if (!e->known[f]) e->path[f] = path_taken();
  e->known[f] = true;
  if (e->path[f] != path_taken()) e->rough = true;
}

static quad lagrangian(evaluation *e, const quad *x) {
  quad value = 0;
  call(e, 0, &value, x);
  return value;
}

static void force(evaluation *e, quad *out, const quad *x) {
  for (int i = 0; i < e->n; i++) out[i] = 0;
  if (e->model->test->model->force.jet) call(e, 1, out, x);
}

/* All rows: phi above psi. */
static void constraints(evaluation *e, quad *out, const quad *x) {
  const eom_model *m = e->model->test->model;
  for (int f = 1 + (m->force.jet != NULL); f < function_count(m); f++) {
    call(e, f, out, x);
    out += function(m, f)->rows(e->model->params);
  }
}

/* to = x moved along the motion by s. */
static void move(const evaluation *e, quad *to, const quad *x, const quad *qdd, quad s) {
  const int n = e->n;
  for (int i = 0; i < n; i++) {
    to[i] = x[i] + s * x[n + i] + s * s / 2 * qdd[i];
    to[n + i] = x[n + i] + s * qdd[i];
  }
  to[2 * n] = x[2 * n] + s;
}

/* dL/dx_i */
static quad slope(evaluation *e, const quad *x, int i) {
  quad y[MAX_X], sum = 0;
  memcpy(y, x, (size_t)(2 * e->n + 1) * sizeof *x);
  for (int a = 0; a < FIRST; a++) {
    y[i] = x[i] + first[a].shift * e->h;
    sum += first[a].weight * lagrangian(e, y);
  }
  return sum / (12 * e->h);
}

static void matrix_of_constraints(evaluation *e, quad *A, const quad *x) {
  quad y[MAX_X], rows[MAX_M];
  for (int i = 0; i < e->m * e->n; i++) A[i] = 0;
  for (int i = 0; e->m && i < 2 * e->n; i++)
    for (int a = 0; a < FIRST; a++) {
      memcpy(y, x, (size_t)(2 * e->n + 1) * sizeof *x);
      y[i] += first[a].shift * e->h;
      constraints(e, rows, y);
      for (int c = i < e->n ? 0 : e->m1; c < (i < e->n ? e->m1 : e->m); c++)
        A[c * e->n + i % e->n] += first[a].weight * rows[c] / (12 * e->h);
    }
}

/* r, with A'lambda where lambda is not null. */
static void residual(evaluation *e, quad *r, const quad *x, const quad *qdd, const quad *lambda) {
  quad y[MAX_X], A[MAX_M * MAX_N];
  force(e, r, x);
  for (int i = 0; i < e->n; i++) {
    r[i] = -r[i] - slope(e, x, i);
    for (int a = 0; a < FIRST; a++) {
      move(e, y, x, qdd, first[a].shift * e->h);
      r[i] += first[a].weight * slope(e, y, e->n + i) / (12 * e->h);
    }
  }
  if (!lambda) return;
  matrix_of_constraints(e, A, x);
  for (int c = 0; c < e->m; c++)
    for (int i = 0; i < e->n; i++) r[i] -= lambda[c] * A[c * e->n + i];
}

/* g; and phi_dot where it is not null. */
static void constraint_motion(evaluation *e, quad *g, quad *phi_dot, const quad *x, const quad *qdd) {
  quad y[MAX_X], rows[MAX_M];
  for (int c = 0; c < e->m; c++) g[c] = 0;
  for (int c = 0; phi_dot && c < e->m1; c++) phi_dot[c] = 0;
  for (int a = 0; a < SECOND && e->m; a++) {
    move(e, y, x, qdd, second[a].shift * e->h);
    constraints(e, rows, y);
    for (int c = 0; c < e->m1; c++) g[c] += second[a].weight * rows[c] / (12 * e->h * e->h);
  }
  for (int a = 0; a < FIRST && e->m; a++) {
    move(e, y, x, qdd, first[a].shift * e->h);
    constraints(e, rows, y);
    for (int c = 0; phi_dot && c < e->m1; c++) phi_dot[c] += first[a].weight * rows[c] / (12 * e->h);
    for (int c = e->m1; c < e->m; c++) g[c] += first[a].weight * rows[c] / (12 * e->h);
  }
}

/* The number in quad precision of parameter k. */
static quad *parameter(const fuzz_model *m, int k) {
  int place = m->parameters[k];
  const tlgen_member *member = m->test->params->members;
  for (; place >= (int)member->count; member++) place -= (int)member->count;
  return (quad *)(void *)((char *)m->quad_params + member->quad_offset + (size_t)place * member->quad_size);
}

/* d(r,g)/dx_j (column j of r_y and g_y), or by parameter k where j < 0. */
static void derivative(evaluation *e, quad *r, quad *g, int j, int k, const quad *x, const quad *qdd, const quad *lambda) {
  quad y[MAX_X], r1[MAX_N], g1[MAX_M], *const p = j < 0 ? parameter(e->model, k) : NULL, centre = p ? *p : x[j];
  memcpy(y, x, (size_t)(2 * e->n + 1) * sizeof *x);
  e->moved = p;
  e->centre = centre;
  for (int i = 0; i < e->n; i++) r[i] = 0;
  for (int c = 0; c < e->m; c++) g[c] = 0;
  for (int a = 0; a < FIRST; a++) {
    *(p ? p : &y[j]) = centre + first[a].shift * e->h;
    residual(e, r1, y, qdd, lambda);
    constraint_motion(e, g1, NULL, y, qdd);
    for (int i = 0; i < e->n; i++) r[i] += first[a].weight * r1[i] / (12 * e->h);
    for (int c = 0; c < e->m; c++) g[c] += first[a].weight * g1[c] / (12 * e->h);
  }
  if (p) *p = centre;
  e->moved = NULL;
}

static double magnitude(quad x) { return fabs((double)x); }

/* Inverse of K by Gauss-Jordan with row exchanges; the largest row sum of it, HUGE_VAL where K is singular. K is destroyed. */
static double invert(int size, quad *K, quad *inverse) {
  double norm = 0.0;
  for (int i = 0; i < size * size; i++) inverse[i] = i / size == i % size;
  for (int k = 0; k < size; k++) {
    int best = k;
    for (int i = k + 1; i < size; i++)
      if (magnitude(K[i * size + k]) > magnitude(K[best * size + k])) best = i;
    const quad pivot = K[best * size + k];
    if (!(magnitude(pivot) > 1e-20)) return HUGE_VAL;
    for (int j = 0; j < size; j++) {
      const quad a = K[best * size + j], b = inverse[best * size + j];
      K[best * size + j] = K[k * size + j], inverse[best * size + j] = inverse[k * size + j];
      K[k * size + j] = a / pivot, inverse[k * size + j] = b / pivot;
    }
    for (int i = 0; i < size; i++) {
      const quad factor = i == k ? 0 : K[i * size + k];
      for (int j = 0; j < size; j++) {
        K[i * size + j] -= factor * K[k * size + j];
        inverse[i * size + j] -= factor * inverse[k * size + j];
      }
    }
  }
  for (int i = 0; i < size; i++) {
    double sum = 0.0;
    for (int j = 0; j < size; j++) sum += magnitude(inverse[i * size + j]);
    norm = fmax(norm, sum);
  }
  return norm;
}

/* The smallest pivot of the Cholesky factorisation of M, each relative to its diagonal element; negative where there is none. */
static double smallest_pivot(int n, const double *M) {
  double smallest = HUGE_VAL, L[MAX_N * MAX_N];
  for (int j = 0; j < n; j++) {
    double pivot = M[j * n + j];
    for (int k = 0; k < j; k++) pivot -= L[j * n + k] * L[j * n + k];
    if (!(pivot > 0.0)) return -1.0;
    smallest = fmin(smallest, pivot / M[j * n + j]);
    for (int i = j; i < n; i++) {
      double sum = M[i * n + j];
      for (int k = 0; k < j; k++) sum -= L[i * n + k] * L[j * n + k];
      L[i * n + j] = sum / sqrt(pivot);
    }
  }
  return smallest;
}

/* [M -A'; A 0] and its inverse; the inverse's norm, 0 where the equations are not to be solved. */
static double factorise(const fuzz_numbers *v, quad *inverse) {
  const int n = v->sizes.n, size = n + v->sizes.m;
  quad K[MAX_K * MAX_K] = {0};
  double norm = 0.0;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) K[i * size + j] = (quad)v->group[FUZZ_MASS][i * n + j];
  for (int c = 0; c < v->sizes.m; c++)
    for (int j = 0; j < n; j++) {
      K[(n + c) * size + j] = (quad)v->group[FUZZ_CONSTRAINT][c * n + j];
      K[j * size + n + c] = -K[(n + c) * size + j];
    }
  for (int i = 0; i < size; i++) {
    double sum = 0.0;
    for (int j = 0; j < size; j++) sum += magnitude(K[i * size + j]);
    norm = fmax(norm, sum);
  }
  const double inverse_norm = invert(size, K, inverse);
  return smallest_pivot(n, v->group[FUZZ_MASS]) > SMALLEST_PIVOT && norm * inverse_norm < LARGEST_CONDITION ? inverse_norm : 0.0;
}

/* to (count columns: upper rows of n, lower of m) = inverse [upper; lower]. */
static void solve(const fuzz_sizes *s, const quad *inverse, double *to_upper, double *to_lower, const quad *upper, const quad *lower,
                  int count) {
  const int n = s->n, size = n + s->m;
  for (int i = 0; i < size; i++)
    for (int c = 0; c < count; c++) {
      quad sum = 0;
      for (int j = 0; j < size; j++) sum += inverse[i * size + j] * (j < n ? upper[j * count + c] : lower[(j - n) * count + c]);
      if (i < n)
        to_upper[i * count + c] = (double)sum;
      else
        to_lower[(i - n) * count + c] = (double)sum;
    }
}

static void round_to(double *to, const quad *from, int count) {
  for (int i = 0; i < count; i++) to[i] = (double)from[i];
}

static void widen(quad *to, const double *from, int count) {
  for (int i = 0; i < count; i++) to[i] = (quad)from[i];
}

/* L, momentum and its rate, energy, M, Q, and the residual at the trial accelerations. Returns the largest of L's first derivatives. */
static double unconstrained(evaluation *e, fuzz_numbers *v, const quad *x, const quad *trial) {
  const int n = e->n;
  const quad rest[MAX_N] = {0};
  quad y[MAX_X], r[MAX_N], momentum, energy = -lagrangian(e, x);
  force(e, r, x);
  double largest = 0.0;
  v->group[FUZZ_LAGRANGIAN][0] = -(double)energy;
  for (int i = 0; i < n; i++) {
    momentum = slope(e, x, n + i);
    energy += momentum * x[n + i];
    v->group[FUZZ_MOMENTUM][i] = (double)momentum;
    v->group[FUZZ_RATE][i] = (double)(slope(e, x, i) + r[i]);
    largest = fmax(largest, fmax(magnitude(momentum), magnitude(slope(e, x, i))));
    for (int j = 0; j <= i; j++) {
      quad sum = 0;
      memcpy(y, x, sizeof y);
      for (int a = 0; a < FIRST; a++) {
        y[n + i] = x[n + i] + first[a].shift * e->h;
        sum += first[a].weight * slope(e, y, n + j) / (12 * e->h);
      }
      v->group[FUZZ_MASS][i * n + j] = v->group[FUZZ_MASS][j * n + i] = (double)sum;
    }
  }
  v->group[FUZZ_ENERGY][0] = (double)energy;
  residual(e, r, x, rest, NULL);
  for (int i = 0; i < n; i++) v->group[FUZZ_FORCE][i] = -(double)r[i];
  residual(e, r, x, trial, NULL);
  round_to(v->group[FUZZ_RESIDUAL], r, n);
  return largest;
}

static void constrained(evaluation *e, fuzz_numbers *v, const quad *x) {
  const quad rest[MAX_N] = {0};
  quad rows[MAX_M], A[MAX_M * MAX_N], g[MAX_M], phi_dot[MAX_M];
  constraints(e, rows, x);
  round_to(v->group[FUZZ_PHI], rows, e->m1);
  round_to(v->group[FUZZ_PSI], rows + e->m1, e->m2);
  matrix_of_constraints(e, A, x);
  round_to(v->group[FUZZ_CONSTRAINT], A, e->m * e->n);
  constraint_motion(e, g, phi_dot, x, rest);
  round_to(v->group[FUZZ_PHI_DOT], phi_dot, e->m1);
  for (int c = 0; c < e->m; c++) v->group[FUZZ_B][c] = -(double)g[c];
}

/* The derivatives by the state and by the parameters: r_y, g_y, r_p, g_p; and with the sign of a right-hand side in minus_r and
 * minus_g. */
static void linearised(evaluation *e, fuzz_numbers *v, const fuzz_point *p, const quad *x, quad minus_r[2][MAX_N * MAX_COLUMNS],
                       quad minus_g[2][MAX_M * MAX_COLUMNS]) {
  const int n = e->n, m = e->m, columns[] = {2 * n, v->sizes.np};
  quad qdd[MAX_N], lambda[MAX_M], r[MAX_N], g[MAX_M];
  widen(qdd, p->qdd, n);
  widen(lambda, p->lambda, m);
  for (int by = 0; by < 2; by++)
    for (int j = 0; j < columns[by]; j++) {
      derivative(e, r, g, by ? -1 : j, j, x, qdd, lambda);
      for (int i = 0; i < n; i++) minus_r[by][i * columns[by] + j] = -r[i];
      for (int c = 0; c < m; c++) minus_g[by][c * columns[by] + j] = -g[c];
      for (int i = 0; i < n; i++) v->group[by ? FUZZ_R_P : FUZZ_R_Y][i * columns[by] + j] = (double)r[i];
      for (int c = 0; c < m; c++) v->group[by ? FUZZ_G_P : FUZZ_G_Y][c * columns[by] + j] = (double)g[c];
    }
}

/* to = matrix w, with that many rows. */
static void along(const fuzz_sizes *s, double *to, int rows, const double *matrix, const double *w) {
  for (int i = 0; i < rows; i++)
    for (int c = 0; c < s->k; c++) {
      quad sum = 0;
      for (int j = 0; j < 2 * s->n; j++) sum += (quad)matrix[i * 2 * s->n + j] * (quad)w[j * s->k + c];
      to[i * s->k + c] = (double)sum;
    }
}

/* What the errors of each group are relative to: its largest number; where that is small, a part of the largest of those that it is
 * computed from, which may cancel. */
static void set_scales(const fuzz_numbers *v, double slopes, double inverse_norm, double *scale) {
  double lagrangian = 0.0, constraint = 0.0;
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) {
    const bool of_constraint = g == FUZZ_PHI || g == FUZZ_PHI_DOT || g == FUZZ_PSI || g == FUZZ_CONSTRAINT || g == FUZZ_B ||
                               g == FUZZ_G_Y || g == FUZZ_G_W || g == FUZZ_G_P;
    const double largest = fuzz_group_largest(v, g);
    const double before = of_constraint ? constraint : g < FUZZ_QDD ? lagrangian : inverse_norm * lagrangian;
    scale[g] = fmax(largest, CANCELLATION * before);
    if (of_constraint)
      constraint = fmax(constraint, largest);
    else if (g < FUZZ_QDD)
      lagrangian = fmax(lagrangian, largest);
    if (g == FUZZ_LAGRANGIAN) lagrangian = fmax(lagrangian, slopes);
    if (g == FUZZ_B || g == FUZZ_G_Y) lagrangian = fmax(lagrangian, constraint); /* r_y holds d(A'lambda) */
  }
}

/* Solves the assembled equations where that is sound. Returns the norm of the inverse, else 0. */
static double accelerations(const fuzz_point *p, fuzz_numbers *v, quad *inverse) {
  const int n = v->sizes.n, m = v->sizes.m;
  quad Q[MAX_N], b[MAX_M];
  const double inverse_norm = factorise(v, inverse);
  memcpy(p->qdd, p->trial, (size_t)n * sizeof *p->qdd);
  if (!(inverse_norm > 0.0)) return 0.0;
  widen(Q, v->group[FUZZ_FORCE], n);
  widen(b, v->group[FUZZ_B], m);
  solve(&v->sizes, inverse, v->group[FUZZ_QDD], v->group[FUZZ_LAMBDA], Q, b, 1);
  memcpy(p->qdd, v->group[FUZZ_QDD], (size_t)n * sizeof *p->qdd);
  memcpy(v->group[FUZZ_QDD_J], p->qdd, (size_t)n * sizeof *p->qdd);
  memcpy(v->group[FUZZ_QDD_V], p->qdd, (size_t)n * sizeof *p->qdd);
  if (m) memcpy(p->lambda, v->group[FUZZ_LAMBDA], (size_t)m * sizeof *p->lambda);
  return inverse_norm;
}

static fuzz_smoothness evaluate(evaluation *e, const fuzz_point *p, fuzz_numbers *v, double *scale) {
  const int n = e->n, m = e->m;
  quad x[MAX_X] = {0}, trial[MAX_N], r[2][MAX_N * MAX_COLUMNS], g[2][MAX_M * MAX_COLUMNS], inverse[MAX_K * MAX_K];
  widen(x, p->x, 2 * n + 1);
  widen(trial, p->trial, n);
  const double slopes = unconstrained(e, v, x, trial);
  constrained(e, v, x);
  const double inverse_norm = accelerations(p, v, inverse);
  if (e->rough) return FUZZ_ROUGH;
  linearised(e, v, p, x, r, g);
  along(&v->sizes, v->group[FUZZ_R_W], n, v->group[FUZZ_R_Y], p->w);
  along(&v->sizes, v->group[FUZZ_G_W], m, v->group[FUZZ_G_Y], p->w);
  if (inverse_norm > 0.0) {
    solve(&v->sizes, inverse, v->group[FUZZ_QDD_Y], v->group[FUZZ_LAMBDA_Y], r[0], g[0], 2 * n);
    solve(&v->sizes, inverse, v->group[FUZZ_QDD_P], v->group[FUZZ_LAMBDA_P], r[1], g[1], v->sizes.np);
    along(&v->sizes, v->group[FUZZ_QDD_W], n, v->group[FUZZ_QDD_Y], p->w);
    along(&v->sizes, v->group[FUZZ_LAMBDA_W], m, v->group[FUZZ_LAMBDA_Y], p->w);
  } else {
    fuzz_make_absent(v, FUZZ_QDD, FUZZ_GROUP_COUNT);
  }
  set_scales(v, slopes, inverse_norm, scale);
  for (int i = 0; i < FUZZ_GROUP_COUNT; i++)
    if (!(scale[i] < LARGEST_NUMBER)) return FUZZ_TOO_LARGE;
  return e->rough ? FUZZ_ROUGH : FUZZ_SMOOTH;
}

static fuzz_smoothness evaluate_with(quad step, const fuzz_model *m, const fuzz_point *p, fuzz_numbers *v, double *scale) {
  const fuzz_sizes *s = &m->sizes;
  evaluation e = {.model = m, .n = s->n, .m1 = s->m1, .m2 = s->m2, .m = s->m, .h = step};
  volatile fuzz_smoothness smoothness = FUZZ_TOO_LARGE;
  if (setjmp(e.give_up) == 0)
    smoothness = evaluate(&e, p, v, scale);
  else if (e.moved)
    *e.moved = e.centre;
  path_stop();
  return smoothness;
}

fuzz_smoothness reference_evaluate(const fuzz_model *m, const fuzz_point *p, fuzz_numbers *v, double scale[FUZZ_GROUP_COUNT]) {
  return evaluate_with(STEP, m, p, v, scale);
}

/* From numbers with both steps to those without the first term of the truncation error. Returns the largest such term of the finer
 * ones, relative to the scale. */
static double extrapolate(fuzz_numbers *v, const fuzz_numbers *finer, const double *scale) {
  double largest = 0.0;
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) {
    if (!finer->group[g]) v->group[g] = NULL;
    for (int i = 0; v->group[g] && i < fuzz_group_size(&v->sizes, g); i++) {
      const double term = EXTRAPOLATION * (finer->group[g][i] - v->group[g][i]);
      v->group[g][i] = finer->group[g][i] + term;
      if (term != 0.0) largest = fmax(largest, fabs(term) / scale[g]);
    }
  }
  return largest;
}

fuzz_smoothness reference_refine(const fuzz_model *m, const fuzz_point *p, double tolerance, fuzz_numbers *v,
                                 double scale[FUZZ_GROUP_COUNT]) {
  fuzz_numbers finer;
  fuzz_numbers_start(&finer, m->sizes);
  fuzz_smoothness smoothness = evaluate_with(SHORTER_STEP, m, p, &finer, scale);
  if (smoothness == FUZZ_SMOOTH) {
    const double term = extrapolate(v, &finer, scale);
    if (!(NEXT_TERM * pow(term, 1.5) <= tolerance)) smoothness = FUZZ_TOO_LARGE;
    if (v->group[FUZZ_QDD]) memcpy(p->qdd, v->group[FUZZ_QDD], (size_t)m->sizes.n * sizeof *p->qdd);
    if (v->group[FUZZ_LAMBDA] && m->sizes.m) memcpy(p->lambda, v->group[FUZZ_LAMBDA], (size_t)m->sizes.m * sizeof *p->lambda);
  }
  fuzz_numbers_free(&finer);
  return smoothness;
}

static void widen_moves(double *moves, const fuzz_numbers *a, const fuzz_numbers *b, const double *scale) {
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++)
    for (int i = 0; a->group[g] && b->group[g] && i < fuzz_group_size(&a->sizes, g); i++) {
      const double difference = fabs(a->group[g][i] - b->group[g][i]);
      if (difference != 0.0) moves[g] = fmax(moves[g], difference / scale[g]);
    }
}

/* The state, each number moved up or down as the bits of a number say that is another for each of the moved states. */
static void move_state(double *to, const double *from, int count, int which) {
  const unsigned bits = 0x9E3779B9u * (unsigned)(which + 1);
  for (int i = 0; i < count; i++) to[i] = from[i] * (1.0 + (bits >> (i + 8) & 1 ? ROUNDINGS : -ROUNDINGS));
}

fuzz_smoothness reference_moves(const fuzz_model *m, const fuzz_point *p, const double scale[FUZZ_GROUP_COUNT],
                                double moves[FUZZ_GROUP_COUNT]) {
  double x[MAX_X], qdd[MAX_N], lambda[MAX_M], unused[FUZZ_GROUP_COUNT];
  const fuzz_point moved = {x, p->trial, qdd, lambda, p->w};
  fuzz_numbers centre, there;
  fuzz_numbers_start(&centre, m->sizes);
  fuzz_numbers_start(&there, m->sizes);
  memset(moves, 0, FUZZ_GROUP_COUNT * sizeof *moves);
  memcpy(x, p->x, (size_t)(2 * m->sizes.n + 1) * sizeof *x);
  memcpy(lambda, p->lambda, (size_t)m->sizes.m * sizeof *lambda);
  fuzz_smoothness smoothness = evaluate_with(STEP, m, &moved, &centre, unused);
  for (int k = 0; k < MOVED_STATES && smoothness == FUZZ_SMOOTH; k++) {
    move_state(x, p->x, 2 * m->sizes.n + 1, k);
    smoothness = evaluate_with(STEP, m, &moved, &there, unused);
    if (smoothness == FUZZ_SMOOTH) widen_moves(moves, &centre, &there, scale);
  }
  fuzz_numbers_free(&centre);
  fuzz_numbers_free(&there);
  return smoothness;
}
