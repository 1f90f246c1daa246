/* Newton's method on the constraint rows, in the mass metric: M delta - A' mu = 0, A delta = -miss, with the factors of eom_solve. */
#include "eom/project.h"

#include "evaluate.h"
#include "factor.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

enum { MOST_STEPS = 30 };

/* One of the two levels: rows 0..count-1 of A move x, the coordinates or the velocities, to where what they miss is zero. */
typedef struct level {
  tl_real *x;
  const unsigned char *keep;
  int count;
  void (*misses)(const eom_system *sys, tl_real *miss);
  int *steps;   /* of Newton's method so far */
  int *rank;    /* held from the last projection; -1: not known */
  tl_real size; /* of x, in coordinates scaled to unit inertia */
  tl_real left; /* the last step, too short to be made, in parts of size */
} level;

static void misses_of_coordinates(const eom_system *sys, tl_real *miss) {
  for (int r = 0; r < sys->m1; r++) miss[r] = sys->phi[r];
}

static void misses_of_velocities(const eom_system *sys, tl_real *miss) {
  for (int r = 0; r < sys->m1; r++) miss[r] = sys->phi_dot[r];
  for (int r = 0; r < sys->m2; r++) miss[sys->m1 + r] = sys->psi[r];
}

/* What is kept does not move: no row acts on it, and it has an inertia of its own. */
static void hold(eom_system *sys, const unsigned char *keep) {
  const int n = sys->n;
  for (int i = 0; keep && i < n; i++) {
    if (!keep[i]) continue;
    for (int j = 0; j < n; j++) sys->M[i * n + j] = sys->M[j * n + i] = TL_C(0.0);
    sys->M[i * n + i] = TL_C(1.0);
    for (int r = 0; r < sys->m; r++) sys->A[r * n + i] = TL_C(0.0);
  }
}

/* The largest number of x, coordinates scaled to unit inertia. */
static tl_real extent(const eom_system *sys, const tl_real *x) {
  tl_real most = TL_C(0.0);
  for (int i = 0; i < sys->n; i++) most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i] / sys->workspace->factor.S[i]));
  return most;
}

/* Rows that are dependent on the manifold look independent beside it, by about the way that is left: where their rank is not known they
 * are taken as dependent, or the step along their difference would be as long as they are alike. */
static void factor_near(eom_system *sys, const level *l, tl_real way) {
  const tl_real given = sys->options.rank_tolerance, most = TL_C(1e-3);
  const bool known = *l->rank >= 0;
  const tl_real near = TL_LIBM(fmax)(given, TL_LIBM(fmin)(way, most));
  const eom_selection rows = {NULL, l->count, known ? *l->rank : l->count, known ? given : near};
  (void)eom_factor_make(sys, &rows);
}

/* delta and multipliers of one step, in sys->qdd and sys->lambda. */
static eom_status find_step(eom_system *sys, const level *l, tl_real way) {
  const eom_workspace *ws = sys->workspace;
  const int m = sys->m;
  sys->m = l->count; /* the rows of this level come first */
  hold(sys, l->keep);
  l->misses(sys, ws->miss);
  for (int r = 0; r < sys->m; r++) ws->miss[r] = -ws->miss[r];
  factor_near(sys, l, way);
  if (sys->report.status == EOM_OK) {
    memset(sys->Qc, 0, (size_t)sys->n * sizeof(tl_real));
    eom_kkt_solve(sys, sys->qdd, sys->lambda, sys->Qc, ws->miss);
    for (int i = 0; i < sys->n; i++)
      if (l->keep && l->keep[i]) sys->qdd[i] = TL_C(0.0);
    (void)eom_check_finite(sys, "step of the projection", sys->qdd, sys->n);
  }
  sys->m = m;
  return sys->report.status;
}

/* Names the rows that still miss by more than rounding, each miss as a length in the mass metric. Rows that are dropped are parallel to
 * others up to take; the state may have left the constraints across them by as much as the largest of them added, ahead. */
static eom_status judge(eom_system *sys, const level *l) {
  const eom_workspace *ws = sys->workspace;
  const eom_hold *hold = &sys->options.hold;
  const tl_real given = sys->options.consistency_tolerance, most = hold->take * TL_LIBM(fmax)(hold->take, hold->ahead);
  const bool dropped = *l->rank >= 0 && *l->rank < l->count;
  const tl_real tolerance = dropped ? TL_LIBM(fmax)(given, most) : given;
  for (int r = 0; r < l->count; r++) {
    if (TL_LIBM(fabs)(ws->miss[r]) * ws->factor.D[r] <= tolerance * l->size) continue;
    sys->report.status = EOM_INCONSISTENT;
    if (sys->report.nrow < EOM_REPORT_ROWS) {
      sys->report.row[sys->report.nrow] = eom_system_row(sys, r);
      sys->report.row[sys->report.nrow].kind = EOM_ROW_INCONSISTENT;
    }
    sys->report.nrow++;
  }
  return sys->report.status;
}

/* Steps until they are rounding, or no longer fall though they are nearly that: the last digit of the rows then. */
static eom_status descend(eom_system *sys, level *l, const tl_real *q, const tl_real *qd, tl_real t) {
  const tl_real rounding = TL_C(4.0) * TL_EPSILON, nearly = TL_LIBM(sqrt)(TL_EPSILON);
  tl_real last = TL_MAX, way = TL_C(0.0);
  for (int step = 0; step < MOST_STEPS; step++) {
    if (eom_assemble_parts(sys, q, qd, t) != EOM_OK || find_step(sys, l, way) != EOM_OK) return sys->report.status;
    const tl_real change = extent(sys, sys->qdd), size = TL_LIBM(fmax)(extent(sys, l->x), change);
    l->size = size;
    l->left = size > TL_C(0.0) ? change / size : TL_C(0.0);
    if (!(change > rounding * size) || (!(change < last / TL_C(2.0)) && change <= nearly * size)) return EOM_OK;
    for (int i = 0; i < sys->n; i++) l->x[i] += sys->qdd[i];
    ++*l->steps;
    last = change;
    way = l->left;
  }
  (void)judge(sys, l);
  return sys->report.status = EOM_NO_CONSISTENT_STATE;
}

/* The rank of the rows last factored: as it was between the two tolerances. What is left of the way blurs it. */
static int decide(const eom_system *sys, const level *l) {
  const tl_real drop = TL_LIBM(fmax)(sys->options.hold.drop, l->left), take = TL_LIBM(fmax)(sys->options.hold.take, drop);
  const int least = eom_factor_rank(sys, take), most = eom_factor_rank(sys, drop), was = *l->rank;
  return was < 0 || was > most ? most : was < least ? least : was;
}

/* Brings x onto the rows and decides on their rank. Rows that are taken back may miss: once more with them. */
static eom_status settle(eom_system *sys, level *l, bool hold, const tl_real *q, const tl_real *qd, tl_real t) {
  if (descend(sys, l, q, qd, t) != EOM_OK) return sys->report.status;
  const int was = *l->rank, rank = hold ? decide(sys, l) : was;
  *l->rank = rank;
  if (was >= 0 && rank > was && descend(sys, l, q, qd, t) != EOM_OK) return sys->report.status;
  return judge(sys, l);
}

/* How many of the first rank rows are held: not those whose pivots fall so fast that the next step would pass zero, a step that may be
 * a quarter longer than the last. All of them or none: rows that are held in a position where others are dropped do as much harm as
 * all. None where the step takes the first of them further than ahead, which would then be missed for too long. */
static int look_ahead(const eom_system *sys, int rank) {
  const tl_real longer = TL_C(1.25);
  for (int j = 0; j < rank; j++) {
    const tl_real pivot = eom_factor_pivot(sys, j), fall = sys->workspace->held.pivot[j] - pivot;
    if (pivot < longer * fall) return fall < sys->options.hold.ahead ? j : rank;
  }
  return rank;
}

/* Holds the rows that came first in the last factorisation, that of all rows at the state projected. */
static void hold_rows(eom_system *sys, int was) {
  eom_held *held = &sys->workspace->held;
  const eom_factor *f = &sys->workspace->factor;
  const int least = sys->n < sys->m ? sys->n : sys->m;
  if (was >= 0) held->rank = look_ahead(sys, held->rank);
  for (int j = 0; j < held->rank; j++) held->row[j] = f->pivot[j];
  for (int j = 0; j < least; j++) held->pivot[j] = eom_factor_pivot(sys, j);
  if (was >= 0 && was != held->rank) sys->rank_changes++;
  sys->held_rank = held->rank;
  (void)eom_mark_rows(sys, held->rank);
  sys->report.rank = held->rank;
}

/* After a step velocities may change by options.most_jump of the largest one so far; what rounding of coordinates makes of a system at
 * rest is no jump. */
static eom_status judge_jump(eom_system *sys, const tl_real *q, const tl_real *qd) {
  eom_held *held = &sys->workspace->held;
  const tl_real *was_qd = sys->workspace->was + sys->n;
  const int n = sys->n;
  for (int i = 0; i < n; i++) sys->qdd[i] = qd[i] - was_qd[i];
  const tl_real rest = TL_LIBM(sqrt)(TL_EPSILON) * extent(sys, q);
  held->speed = TL_LIBM(fmax)(held->speed, extent(sys, qd));
  if (extent(sys, sys->qdd) <= TL_LIBM(fmax)(sys->options.most_jump * held->speed, rest)) return EOM_OK;
  (void)eom_largest_change(n, qd, was_qd, &sys->report.index);
  return sys->report.status = EOM_VELOCITY_JUMP;
}

static eom_status project(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *p) {
  eom_held *held = &sys->workspace->held;
  level coordinates = {q, p->keep_q, sys->m1, misses_of_coordinates, &p->steps_q, &held->rank_q, TL_C(0.0), TL_C(0.0)};
  level velocities = {qd, p->keep_qd, sys->m, misses_of_velocities, &p->steps_qd, &held->rank, TL_C(0.0), TL_C(0.0)};
  const bool hold = sys->options.hold.on && !p->keep_q && !p->keep_qd;
  const int was = held->rank;
  if (sys->m1 > 0 && settle(sys, &coordinates, hold, q, qd, t) != EOM_OK) return sys->report.status;
  if (sys->m > 0 && settle(sys, &velocities, hold, q, qd, t) != EOM_OK) return sys->report.status;
  if (p->after_step && sys->m > 0 && judge_jump(sys, q, qd) != EOM_OK) return sys->report.status;
  if (hold) hold_rows(sys, was);
  return EOM_OK;
}

/* ---- from near the rows ---- */

/* Steps of integration end near the rows. There the first factorisation serves for all steps of Newton's method, and A M^-1 A' may
 * square the condition of A, since each step corrects the one before: with M = L L' and B = A L^-T, the step is L^-T B' (B B')^-1
 * -miss. Where this is not as plain as that, nothing is lost but its time. */

/* a = L L', in its place. diagonal: n, of a. Whether all pivots are safe. */
static bool factor_safely(const eom_linalg *la, int n, tl_real *a, tl_real *diagonal) {
  for (int i = 0; i < n; i++) diagonal[i] = a[i * n + i];
  if (la->cholesky(n, a) != 0) return false;
  for (int i = 0; i < n; i++)
    if (!(a[i * n + i] * a[i * n + i] > EOM_MOTION_SAFE_PIVOT * diagonal[i])) return false;
  return true;
}

/* L in factor.L, B' in factor.B, and what brings the diagonal of M near 1 in factor.S. */
static bool factor_near_mass(eom_system *sys) {
  const eom_linalg *la = sys->workspace->linalg;
  eom_factor *f = &sys->workspace->factor;
  const size_t n = (size_t)sys->n, m = (size_t)sys->m;
  memcpy(f->L, sys->M, n * n * sizeof(tl_real));
  memcpy(f->B, sys->A, m * n * sizeof(tl_real));
  f->kept = false;
  if (!factor_safely(la, sys->n, f->L, f->y)) return false;
  for (int i = 0; i < sys->n; i++) f->S[i] = TL_LIBM(ldexp)(TL_C(1.0), -(TL_LIBM(ilogb)(f->y[i]) / 2));
  la->solve_lower(sys->n, f->L, sys->m, f->B);
  return true;
}

/* B B' = U U' of the first count rows. */
static bool factor_near_rows(eom_system *sys, int count) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  for (int r = 0; r < count; r++)
    for (int s = 0; s <= r; s++) {
      tl_real sum = TL_C(0.0);
      for (int i = 0; i < n; i++) sum += f->B[r * n + i] * f->B[s * n + i];
      f->U[r * count + s] = sum;
    }
  return factor_safely(sys->workspace->linalg, count, f->U, f->v);
}

/* The step for the misses of these rows in workspace->miss, in sys->qdd. */
static void find_near_step(eom_system *sys, int count) {
  const eom_workspace *ws = sys->workspace;
  const eom_linalg *la = ws->linalg;
  const eom_factor *f = &ws->factor;
  const int n = sys->n;
  la->solve_lower(count, f->U, 1, ws->miss);
  la->solve_lower_transposed(count, f->U, 1, ws->miss);
  memset(sys->qdd, 0, (size_t)n * sizeof(tl_real));
  for (int r = 0; r < count; r++)
    for (int i = 0; i < n; i++) sys->qdd[i] -= f->B[r * n + i] * ws->miss[r];
  la->solve_lower_transposed(n, f->L, 1, sys->qdd);
}

/* Where the equations are assembled at q and qd, steps until they are rounding, each far shorter than the one before. */
static bool descend_near(eom_system *sys, level *l, const tl_real *q, const tl_real *qd, tl_real t) {
  const tl_real near = TL_C(1e-3), rounding = TL_C(4.0) * TL_EPSILON, nearly = TL_C(64.0) * TL_EPSILON;
  tl_real last = TL_MAX;
  for (int step = 0;; step++) {
    if (step > 0 && eom_assemble_parts(sys, q, qd, t) != EOM_OK) return false;
    l->misses(sys, sys->workspace->miss);
    find_near_step(sys, l->count);
    const tl_real change = extent(sys, sys->qdd), size = TL_LIBM(fmax)(extent(sys, l->x), change);
    if (change <= rounding * size) return true;
    if (!(change <= near * size)) return false;
    if (!(change < near * last)) return change <= nearly * size;
    for (int i = 0; i < sys->n; i++) l->x[i] += sys->qdd[i];
    ++*l->steps;
    last = change;
  }
}

/* As project does after a step, where nothing is held or kept; false: not so plain. */
static bool project_near(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *p) {
  level coordinates = {.x = q, .count = sys->m1, .misses = misses_of_coordinates, .steps = &p->steps_q};
  level velocities = {.x = qd, .count = sys->m, .misses = misses_of_velocities, .steps = &p->steps_qd};
  if (sys->m == 0 || sys->m > sys->n || eom_assemble_parts(sys, q, qd, t) != EOM_OK || !factor_near_mass(sys)) return false;
  if (sys->m1 > 0 && !(factor_near_rows(sys, sys->m1) && descend_near(sys, &coordinates, q, qd, t))) return false;
  if (sys->m2 > 0 && !factor_near_rows(sys, sys->m)) return false;
  if (!descend_near(sys, &velocities, q, qd, t)) return false;
  for (int r = 0; r < sys->m; r++) sys->row_kind[r] = EOM_ROW_INDEPENDENT;
  sys->report.rank = sys->m;
  sys->report.condition = TL_C(-1.0);
  return true;
}

/* ---- the choice ---- */

/* Afresh: whatever was held is forgotten. */
static void release(eom_system *sys) {
  eom_held *held = &sys->workspace->held;
  held->rank_q = held->rank = sys->held_rank = -1;
  held->speed = TL_C(0.0);
}

static eom_status bring_onto_rows(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *p) {
  if (p->after_step && !sys->options.hold.on && !p->keep_q && !p->keep_qd) {
    const size_t bytes = (size_t)sys->n * sizeof(tl_real);
    if (project_near(sys, q, qd, t, p)) return judge_jump(sys, q, qd);
    memcpy(q, sys->workspace->was, bytes);
    memcpy(qd, sys->workspace->was + sys->n, bytes);
    p->steps_q = p->steps_qd = 0;
    if (eom_start(sys, q, qd, t) != EOM_OK) return sys->report.status;
  }
  return project(sys, q, qd, t, p);
}

eom_status eom_project(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *projection) {
  assert(sys && q && qd);
  eom_projection ignored = {0}, *p = projection ? projection : &ignored;
  const int n = sys->n;
  const size_t bytes = (size_t)n * sizeof(tl_real);
  tl_real *was_q = sys->workspace->was, *was_qd = was_q + n;
  if (!p->after_step) release(sys);
  const eom_held held = sys->workspace->held;
  if (eom_start(sys, q, qd, t) != EOM_OK) return sys->report.status;
  memcpy(was_q, q, bytes);
  memcpy(was_qd, qd, bytes);
  p->steps_q = p->steps_qd = 0;
  if (bring_onto_rows(sys, q, qd, t, p) != EOM_OK) {
    memcpy(q, was_q, bytes);
    memcpy(qd, was_qd, bytes);
    sys->workspace->held = held;
  }
  p->change_q = eom_largest_change(n, q, was_q, &p->most_q);
  p->change_qd = eom_largest_change(n, qd, was_qd, &p->most_qd);
  return sys->report.status;
}

int eom_project_state(void *user, tl_real t, tl_real *y) {
  eom_system *sys = user;
  eom_projection p = {.after_step = 1};
  return (int)eom_project(sys, y, y + sys->n, t, &p);
}

/* ---- changes of a state ---- */

/* Solves with the first count rows, of which at most rank are independent (-1: not known): the shortest sys->qdd with A qdd = -miss. */
static eom_status find_change(eom_system *sys, int count, int rank) {
  const eom_workspace *ws = sys->workspace;
  const eom_selection rows = {NULL, count, rank >= 0 ? rank : count, sys->options.rank_tolerance};
  const int m = sys->m;
  if (eom_factor_make(sys, &rows) != EOM_OK) return sys->report.status;
  for (int r = 0; r < count; r++) ws->miss[r] = -ws->miss[r];
  memset(sys->Qc, 0, (size_t)sys->n * sizeof(tl_real));
  sys->m = count;
  eom_kkt_solve(sys, sys->qdd, sys->lambda, sys->Qc, ws->miss);
  sys->m = m;
  return EOM_OK;
}

/* x + the shortest change with A (x + change) = 0 in the first count rows. plain: factor_near_mass was good. */
static eom_status turn(eom_system *sys, tl_real *x, int count, int rank, bool plain) {
  const eom_workspace *ws = sys->workspace;
  if (count == 0) return EOM_OK;
  eom_multiply(count, sys->n, 1, ws->miss, sys->A, x);
  if (plain && factor_near_rows(sys, count))
    find_near_step(sys, count);
  else if (find_change(sys, count, rank) != EOM_OK)
    return sys->report.status;
  for (int i = 0; i < sys->n; i++) x[i] += sys->qdd[i];
  return eom_check_finite(sys, "change of a state", x, sys->n);
}

eom_status eom_project_change(eom_system *sys, tl_real *dq, tl_real *dqd, const tl_real *q, const tl_real *qd, tl_real t) {
  assert(sys && dq && dqd && q && qd);
  const eom_held *held = &sys->workspace->held;
  if (eom_start(sys, q, qd, t) != EOM_OK || sys->m == 0) return sys->report.status;
  if (eom_assemble_parts(sys, q, qd, t) != EOM_OK) return sys->report.status;
  const bool plain = !sys->options.hold.on && sys->m <= sys->n && factor_near_mass(sys);
  if (turn(sys, dq, sys->m1, held->rank_q, plain) != EOM_OK) return sys->report.status;
  return turn(sys, dqd, sys->m, held->rank, plain);
}
