/* Steps of a discrete Lagrangian: the nodes, their equations and Newton's method. The formulas are in eom/variational.h. */
#include "eom/variational.h"

#include "eom/assemble.h"
#include "eom/project.h"
#include "eom/solve.h"
#include "evaluate.h"
#include "factor.h"
#include "step.h"

#include <assert.h>
#include <string.h>

enum { NODES = EOM_VARIATIONAL_NODES, MOST_ITERATIONS = 100 };

/* ---- nodes ---- */

/* D of Lobatto's nodes. Its rows must add up to zero exactly, or momentum would grow by as much each step: sqrt(5) is cut to a length
 * whose multiples here are exact. */
static void set_nodes(eom_variational *v, int s) {
  const tl_real cut = TL_C(1.0) / (TL_C(16.0) * TL_EPSILON), root5 = TL_LIBM(floor)(TL_LIBM(sqrt)(TL_C(5.0)) * cut) / cut;
  const tl_real c[NODES][NODES] = {
      {0}, {0, 1}, {0, TL_C(0.5), 1}, {0, TL_C(0.5) - root5 / TL_C(10.0), TL_C(0.5) + root5 / TL_C(10.0), 1}};
  const tl_real D[NODES][2][NODES] = {{{0}},
                                      {{-1, 1}},
                                      {{-3, 4, -1}, {-1, 0, 1}},
                                      {{-6, TL_C(2.5) * (TL_C(1.0) + root5), TL_C(2.5) * (TL_C(1.0) - root5), 1},
                                       {TL_C(-0.5) * (TL_C(1.0) + root5), 0, root5, TL_C(0.5) * (TL_C(1.0) - root5)}}};
  const tl_real b[NODES] = {0, TL_C(0.5), TL_C(1.0) / TL_C(6.0), TL_C(1.0) / TL_C(12.0)};
  v->s = s;
  for (int j = 0; j <= s; j++) {
    const int outer = j == 0 || j == s;
    v->c[j] = c[s][j];
    v->b[j] = outer ? b[s] : (TL_C(1.0) - TL_C(2.0) * b[s]) / (tl_real)(s - 1);
    for (int i = 0; i <= s; i++) v->D[j][i] = 2 * j <= s ? D[s][j][i] : -D[s][s - j][s - i];
  }
}

/* K and its inverse by Gauss and Jordan, whose pivots are at least 1. */
static void set_stiffness(eom_variational *v) {
  const int s = v->s;
  tl_real K[NODES][NODES];
  for (int i = 0; i < s; i++)
    for (int k = 0; k < s; k++) {
      K[i][k] = TL_C(0.0);
      for (int j = 0; j <= s; j++) K[i][k] += v->b[j] * v->D[j][i] * v->D[j][k + 1];
      v->K[i][k] = K[i][k];
      v->inverse[i][k] = i == k ? TL_C(1.0) : TL_C(0.0);
    }
  for (int j = 0; j < s; j++) {
    const tl_real pivot = K[j][j];
    for (int k = 0; k < s; k++) K[j][k] /= pivot, v->inverse[j][k] /= pivot;
    for (int i = 0; i < s; i++) {
      const tl_real factor = K[i][j];
      for (int k = 0; i != j && k < s; k++) K[i][k] -= factor * K[j][k], v->inverse[i][k] -= factor * v->inverse[j][k];
    }
  }
}

/* V_j = sum_k D_jk Z_k / h and Q_j = q0 + Z_j. */
static void set_node(const eom_variational *v, const eom_integrator *it, int j, tl_real h) {
  const int n = v->sys->n;
  for (int i = 0; i < n; i++) {
    tl_real sum = TL_C(0.0);
    for (int k = 1; k <= v->s; k++) sum += v->D[j][k] * v->Z[(k - 1) * n + i];
    v->V[i] = sum / h;
    v->Q[i] = j == 0 ? it->y[i] : it->y[i] + (v->Z[(j - 1) * n + i] + it->carry[i]);
  }
}

/* ---- evaluations ---- */

/* p and f but for constraint forces, counted. */
static eom_status evaluate(eom_integrator *it, eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  it->evaluations++;
  return eom_energy(sys, q, qd, t);
}

/* phi and A. */
static eom_status constraints_at(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  return (eom_by_motion(sys, EOM_TASK_ASSEMBLE) ? eom_assemble_parts : eom_size_rows)(sys, q, qd, t);
}

/* x += a A' l. */
static void add_constraint_force(const eom_system *sys, tl_real *x, tl_real a, const tl_real *A, const tl_real *l) {
  for (int r = 0; r < sys->m; r++)
    for (int i = 0; i < sys->n; i++) x[i] += a * l[r] * A[r * sys->n + i];
}

/* M and A at a state, and their factors. */
static eom_status factor_at(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_start(sys, q, qd, t) != EOM_OK || eom_assemble_parts(sys, q, qd, t) != EOM_OK) return sys->report.status;
  return eom_factor_rows(sys);
}

/* ---- the equations of a step ---- */

/* What node j adds to R, to h sum b f in v->sum, and its phi. The last node's multipliers come later. Each product is rounded with its
 * number: products of weights, rounded once for all, would change momentum by their errors in each step. */
static eom_status add_node(eom_variational *v, eom_integrator *it, int j, tl_real h, tl_real t) {
  eom_system *sys = v->sys;
  const int n = sys->n, m = sys->m, s = v->s;
  set_node(v, it, j, h);
  if (evaluate(it, sys, v->Q, v->V, t) != EOM_OK) return sys->report.status;
  if (m > 0 && j > 0) {
    if (constraints_at(sys, v->Q, v->V, t) != EOM_OK) return sys->report.status;
    memcpy(v->phi + (j - 1) * m, sys->phi, (size_t)m * sizeof(tl_real));
  }
  tl_real *f = sys->momentum_rate;
  if (j < s) add_constraint_force(sys, f, TL_C(1.0), j == 0 ? v->A0 : sys->A, v->lambda + j * m);
  for (int i = 0; i < n; i++) v->sum[i] += h * (v->b[j] * f[i]);
  for (int i = 0; j < s && i < n; i++) v->R[j * n + i] += h * (v->b[j] * f[i]);
  for (int k = 0; k < s; k++)
    for (int i = 0; i < n; i++) v->R[k * n + i] += v->b[j] * (v->D[j][k] * sys->momentum[i]);
  return EOM_OK;
}

static eom_status miss(eom_variational *v, eom_integrator *it, tl_real h, tl_real t1) {
  const size_t n = (size_t)v->sys->n, s = (size_t)v->s;
  memset(v->sum, 0, n * sizeof(tl_real));
  memset(v->R, 0, s * n * sizeof(tl_real));
  memcpy(v->R, v->p, n * sizeof(tl_real));
  for (int j = 0; j <= v->s; j++)
    if (add_node(v, it, j, h, j == v->s ? t1 : it->t + v->c[j] * h) != EOM_OK) return v->sys->report.status;
  return EOM_OK;
}

/* A step of Newton's method with M and A as factored: M dZ_k - A' mu_k = -h sum_i inverse_ki R_i, A dZ_k = -phi_k, where
 * mu_k = -h^2 sum_i inverse_ki b_i dlambda_i. */
static void improve(eom_variational *v, tl_real h) {
  eom_system *sys = v->sys;
  const int n = sys->n, m = sys->m, s = v->s;
  for (int k = 0; k < s; k++) {
    for (int i = 0; i < n; i++) {
      v->r1[i] = TL_C(0.0);
      for (int j = 0; j < s; j++) v->r1[i] -= h * v->inverse[k][j] * v->R[j * n + i];
    }
    for (int r = 0; r < m; r++) v->r2[r] = -v->phi[k * m + r];
    eom_factor_apply(sys, v->dZ + k * n, v->mu + k * m, v->r1, v->r2);
  }
  for (int i = 0; i < s * n; i++) v->Z[i] += v->dZ[i];
  for (int i = 0; i < s; i++)
    for (int r = 0; r < m; r++)
      for (int k = 0; k < s; k++) v->lambda[i * m + r] -= v->K[i][k] * v->mu[k * m + r] / (h * h * v->b[i]);
}

/* The largest number of count vectors of n, coordinates scaled to unit inertia, and in *most the coordinate. */
static tl_real extent(const eom_system *sys, int count, const tl_real *x, int *most) {
  tl_real largest = TL_C(0.0);
  for (int k = 0; k < count * sys->n; k++) {
    const tl_real size = TL_LIBM(fabs)(x[k] / sys->workspace->factor.S[k % sys->n]);
    if (!(size <= largest)) largest = size, *most = k % sys->n;
  }
  return largest;
}

/* Whether a change is the rounding of what changes: of its own last digits, or, where it no longer falls, of those of the sums behind
 * it, which are longer by the coordinates in phi. */
static bool is_rounding(tl_real change, tl_real last, tl_real own, tl_real behind) {
  const tl_real steady = TL_C(0.9), most = TL_C(1e4);
  return change <= TL_C(2.0) * TL_EPSILON * own || (change >= steady * last && change <= most * TL_EPSILON * (own + behind));
}

static eom_status not_solved(eom_system *sys, int coordinate) {
  sys->report = (eom_report){.index = coordinate, .rank = -1};
  return sys->report.status = EOM_NO_STEP;
}

/* At the end v->sum is that of the settled nodes: what the last change leaves out would add up, step by step. */
static eom_status solve_step(eom_variational *v, eom_integrator *it, tl_real h, tl_real t1) {
  eom_system *sys = v->sys;
  int most = 0, ignored;
  const tl_real behind = extent(sys, 1, it->y, &ignored);
  tl_real last = TL_MAX;
  for (int tries = 0; tries < MOST_ITERATIONS; tries++) {
    const eom_status status = miss(v, it, h, t1);
    if (status == EOM_NOT_FINITE && tries > 0) break; /* the nodes went far away */
    if (status != EOM_OK) return status;
    improve(v, h);
    v->iterations++;
    const tl_real change = extent(sys, v->s, v->dZ, &most), own = extent(sys, v->s, v->Z, &ignored);
    if (is_rounding(change, last, own, behind)) return miss(v, it, h, t1);
    if (!(change <= TL_MAX)) break;
    last = change;
  }
  return not_solved(sys, most);
}

/* ---- a step ---- */

/* The momentum of the state, where that has been changed since the last step. */
static eom_status begin(eom_variational *v, eom_integrator *it) {
  eom_system *sys = v->sys;
  const size_t bytes = (size_t)sys->n * sizeof(tl_real);
  if (it->slope0 != SLOPE0_UNKNOWN) return EOM_OK;
  if (evaluate(it, sys, it->y, it->y + sys->n, it->t) != EOM_OK) return sys->report.status;
  memcpy(v->p, sys->momentum, bytes);
  memset(v->p_low, 0, bytes);
  it->slope0 = SLOPE0_AT_END;
  return EOM_OK;
}

/* Factors of the beginning, and a motion of constant acceleration as first guess. */
static eom_status guess(eom_variational *v, const eom_integrator *it, tl_real h) {
  eom_system *sys = v->sys;
  const int n = sys->n, m = sys->m;
  const tl_real *qd = it->y + n;
  if (factor_at(sys, it->y, qd, it->t) != EOM_OK) return sys->report.status;
  eom_factor_apply(sys, v->x, v->r2, sys->Q, sys->b);
  if (m > 0) memcpy(v->A0, sys->A, (size_t)m * (size_t)n * sizeof(tl_real));
  for (int k = 0; k < v->s; k++) {
    const tl_real time = v->c[k + 1] * h;
    for (int i = 0; i < n; i++) v->Z[k * n + i] = time * (qd[i] + time / TL_C(2.0) * v->x[i]);
    for (int r = 0; r < m; r++) v->lambda[k * m + r] = v->r2[r];
  }
  return EOM_OK;
}

/* The velocity of momentum p + sum + A' mu at (q1, t1) with phi_dot = 0: M dqd - A' dmu = p + sum + A' mu - dL/dqd, A dqd = -phi_dot.
 * A' mu is added to v->sum. */
static eom_status find_velocity(eom_variational *v, eom_integrator *it, const tl_real *q1, tl_real *qd1, tl_real t1) {
  eom_system *sys = v->sys;
  const int n = sys->n, m = sys->m;
  int most = 0, ignored;
  tl_real last = TL_MAX;
  if (factor_at(sys, q1, qd1, t1) != EOM_OK) return sys->report.status;
  for (int tries = 0; tries < MOST_ITERATIONS; tries++) {
    if (evaluate(it, sys, q1, qd1, t1) != EOM_OK) return sys->report.status;
    for (int i = 0; i < n; i++) v->r1[i] = v->p[i] + (v->p_low[i] + v->sum[i]) - sys->momentum[i];
    for (int r = 0; r < m; r++) v->r2[r] = -sys->phi_dot[r];
    eom_factor_apply(sys, v->x, v->mu, v->r1, v->r2);
    for (int i = 0; i < n; i++) qd1[i] += v->x[i];
    add_constraint_force(sys, v->sum, TL_C(1.0), sys->A, v->mu);
    for (int r = 0; r < m; r++)
      for (int i = 0; i < n; i++) sys->phi_dot[r] += sys->A[r * n + i] * v->x[i];
    const tl_real change = extent(sys, 1, v->x, &most), own = extent(sys, 1, qd1, &ignored);
    if (is_rounding(change, last, own, TL_C(0.0))) return EOM_OK;
    if (!(change <= TL_MAX)) break;
    last = change;
  }
  return not_solved(sys, most);
}

/* The new state in it->trial; it->y, v->p and what they carry change only where all is well. */
static eom_status try_step(eom_variational *v, eom_integrator *it, tl_real h, tl_real t1) {
  const int n = v->sys->n, s = v->s;
  const size_t bytes = (size_t)n * sizeof(tl_real);
  eom_status status = begin(v, it);
  if (status == EOM_OK) status = guess(v, it, h);
  if (status == EOM_OK) status = solve_step(v, it, h, t1);
  if (status != EOM_OK) return status;
  for (int i = 0; i < n; i++) it->trial[i] = eom_sum_up(it->y[i], v->Z[(s - 1) * n + i] + it->carry[i], &it->kept[i]);
  set_node(v, it, s, h);
  memcpy(it->trial + n, v->V, bytes);
  status = find_velocity(v, it, it->trial, it->trial + n, t1);
  return status;
}

static eom_status step(eom_integrator *it, tl_real h, tl_real t1) {
  eom_variational *v = it->own;
  const int n = v->sys->n;
  it->interpolates = INTERPOLATES_NOT;
  const eom_status status = try_step(v, it, h, t1);
  it->rhs_code = (int)status;
  if (status != EOM_OK) return status == EOM_NO_STEP ? EOM_NO_STEP : EOM_RHS_FAILED;
  for (int i = 0; i < n; i++) v->p[i] = eom_sum_up(v->p[i], v->sum[i] + v->p_low[i], &v->p_low[i]);
  memcpy(it->carry, it->kept, (size_t)n * sizeof(tl_real));
  memcpy(it->before, it->y, 2 * (size_t)n * sizeof(tl_real));
  memcpy(it->y, it->trial, 2 * (size_t)n * sizeof(tl_real));
  it->t_before = it->t;
  it->t = it->t_after = t1;
  it->interpolates = INTERPOLATES;
  it->steps++;
  return EOM_OK;
}

/* ---- inside a step ---- */

/* Accelerations at both ends. */
static eom_status prepare(eom_integrator *it) {
  eom_status status = eom_evaluate(it, it->t_before, it->before, eom_slope(it, 0));
  if (status == EOM_OK) status = eom_evaluate(it, it->t_after, it->trial, eom_slope(it, 2));
  if (status == EOM_OK) it->interpolates = INTERPOLATES_READY;
  return status;
}

/* Hermite's quintic and its derivative. With D = q1 - q0 - h qd0 - h^2 qdd0/2 and likewise E, F of h qd and h^2 qdd,
 *   q = q0 + x h qd0 + x^2 h^2 qdd0/2 + x^3 (10 D - 4 E + F/2 + x (-15 D + 7 E - F + x (6 D - 3 E + F/2))). */
static eom_status interpolate(eom_integrator *it, tl_real x, tl_real *y) {
  const eom_status status = it->interpolates == INTERPOLATES_READY ? EOM_OK : prepare(it);
  if (status != EOM_OK) return status;
  const int n = it->dim / 2;
  const tl_real h = it->t_after - it->t_before, half = TL_C(0.5);
  for (int i = 0; i < n; i++) {
    const tl_real q0 = it->before[i], v0 = h * it->before[n + i], a0 = h * h * eom_slope(it, 0)[n + i];
    const tl_real v1 = h * it->trial[n + i], a1 = h * h * eom_slope(it, 2)[n + i];
    const tl_real D = it->trial[i] - q0 - v0 - half * a0, E = v1 - v0 - a0, F = a1 - a0;
    const tl_real c3 = TL_C(10.0) * D - TL_C(4.0) * E + half * F, c4 = TL_C(-15.0) * D + TL_C(7.0) * E - F;
    const tl_real c5 = TL_C(6.0) * D - TL_C(3.0) * E + half * F;
    y[i] = q0 + x * (v0 + x * (half * a0 + x * (c3 + x * (c4 + x * c5))));
    y[n + i] = (v0 + x * (a0 + x * (TL_C(3.0) * c3 + x * (TL_C(4.0) * c4 + x * TL_C(5.0) * c5)))) / h;
  }
  return EOM_OK;
}

/* ---- start ---- */

static const eom_scheme scheme = {.step = step, .interpolate = interpolate};

/* What an integrator says of them; slopes 0 and 2 are those of both ends of a step, slope 1 is room for a state inside it. */
static const eom_method methods[NODES] = {{0},
                                          {.name = "variational2", .order = 2, .stages = 2, .dense_order = 4},
                                          {.name = "variational4", .order = 4, .stages = 2, .dense_order = 4},
                                          {.name = "variational6", .order = 6, .stages = 2, .dense_order = 4}};

static int degree(int order) { return order == 2 || order == 4 || order == 6 ? order / 2 : 0; }

/* Carves work behind the integrator's part; with work null it only counts. */
static size_t lay_out(eom_variational *v, const eom_system *sys, int s, tl_real *work) {
  const size_t n = (size_t)sys->n, m = (size_t)sys->m, count = (size_t)s;
  size_t used = eom_integrator_size(&methods[s], 2 * sys->n);
  const struct {
    tl_real **place;
    size_t size;
  } all[] = {{&v->p, n},
             {&v->p_low, n},
             {&v->Z, count * n},
             {&v->dZ, count * n},
             {&v->R, count * n},
             {&v->phi, count * m},
             {&v->lambda, count * m},
             {&v->mu, count * m},
             {&v->sum, n},
             {&v->A0, m * n},
             {&v->Q, n},
             {&v->V, n},
             {&v->r1, n},
             {&v->x, n},
             {&v->r2, m}};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
    if (work) *all[i].place = work + used;
    used += all[i].size;
  }
  return used;
}

size_t eom_variational_size(const eom_system *sys, int order) {
  eom_variational ignored;
  return degree(order) ? lay_out(&ignored, sys, degree(order), NULL) : 0;
}

eom_status eom_variational_init(eom_variational *v, eom_integrator *it, eom_system *sys, int order, tl_real t, const tl_real *y,
                                tl_real h, tl_real *work) {
  assert(v && it && sys && y && work);
  const int s = degree(order);
  if (s == 0 || sys->m2 > 0) return EOM_BAD_OPTION;
  *v = (eom_variational){.sys = sys};
  (void)lay_out(v, sys, s, work);
  set_nodes(v, s);
  set_stiffness(v);
  eom_integrator_init(it, &methods[s], eom_rhs, sys, 2 * sys->n, t, y, h, work);
  it->scheme = &scheme;
  it->own = v;
  if (sys->m == 0) return EOM_OK;
  it->correct = eom_project_state; /* at events */
  return eom_project(sys, it->y, it->y + sys->n, t, NULL);
}
