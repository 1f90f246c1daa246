/* A run of Lyapunov exponents: steps, the QRs between them, and marks. */
#include "lyapunov.h"

#include "eom/assemble.h"
#include "eom/project.h"
#include "step.h"

#include <string.h>

/* ---- QR ---- */

/* A QR may lose this many digits (as a natural logarithm) of the directions that grow least, beside those that grow most: thousandfold,
 * which rounding makes 1e-13. The next QR is due after the time that this would take at the rate of the last one. */
static const tl_real most_loss = TL_C(6.9);
static const tl_real most_change = TL_C(2.0); /* of that time from one QR to the next */

static void plan_next_qr(eom_lyapunov *ly) {
  eom_lyapunov_work *w = ly->work;
  const tl_real t = eom_lyapunov_stepper(ly)->t, taken = TL_LIBM(fabs)(t - w->t_qr);
  const tl_real factor = w->loss * most_change > most_loss ? most_loss / w->loss : most_change;
  w->span = taken * TL_LIBM(fmax)(factor, TL_C(1.0) / most_change);
  w->t_qr = t;
}

/* X = Q R. For DISCRETE rho_i += log R_ii; for CONTINUOUS R is the error that steps have left over. */
static eom_status make_orthonormal(eom_lyapunov *ly) {
  eom_lyapunov_work *w = ly->work;
  eom_integrator *it = eom_lyapunov_stepper(ly);
  eom_status status = EOM_OK;
  if (w->rows > 0) {
    if (!w->together) status = eom_lyapunov_path_at(ly, it->t, w->y);
    if (status == EOM_OK) status = eom_lyapunov_factor_rows(ly, it->t, w->together ? it->y : w->y);
  }
  if (status != EOM_OK) return status;
  if (w->rank != 2 * ly->sys->n - ly->d) return EOM_RANK_FELL;
  status = eom_lyapunov_orthonormalise(ly, eom_lyapunov_X(ly));
  if (status != EOM_OK) return status;
  for (int i = 0; i < ly->k && ly->options.scheme == EOM_LYAPUNOV_DISCRETE; i++) ly->rho[i] += w->log_R[i];
  eom_restart_behind(it, w->together ? 2 * ly->sys->n : 0);
  ly->qrs++;
  plan_next_qr(ly);
  return EOM_OK;
}

static bool is_qr_due(const eom_lyapunov *ly, tl_real t, bool at_mark) {
  switch (ly->options.scheme) {
  case EOM_LYAPUNOV_DISCRETE:
    return at_mark || TL_LIBM(fabs)(t - ly->work->t_qr) >= ly->work->span;
  case EOM_LYAPUNOV_CONTINUOUS:
    return true;
  case EOM_LYAPUNOV_PAPER:
    break;
  }
  return false;
}

/* ---- steps ---- */

static int stop_after_step(void *observer, const eom_integrator *it) {
  (void)observer;
  (void)it;
  return 1;
}

/* Steps that were tried since the last mark. */
static long tries(const eom_integrator *it, const eom_integrator *before) {
  return it->steps + it->rejected + it->failed - before->steps - before->rejected - before->failed;
}

static bool is_worked_out(const eom_lyapunov *ly) {
  const eom_lyapunov_moment *mark = &ly->work->mark;
  const long most = ly->options.control.most_steps;
  return most > 0 && tries(&ly->it, &mark->it) + tries(&ly->tangents, &mark->tangents) >= most;
}

/* One step of a fixed length. */
static eom_status fixed_step(eom_lyapunov *ly, bool *at_mark) {
  const eom_status status = eom_integrator_step(&ly->it);
  *at_mark = ly->it.steps - ly->work->mark.it.steps == ly->work->steps_per_mark;
  return status;
}

/* ---- steps of the tangents' own ---- */

/* Where the motion is fast its steps are short, and so must be those of the tangents: they are chosen as a number of steps of the
 * motion, which is ahead and knows. All of these are kept, and those at both ends, which are begun. */
static const tl_real most_reach = (tl_real)(EOM_PATH_STEPS - 4);

/* Of a mark the lengths of both next steps are kept. */
static void reach_from_mark(eom_lyapunov *ly) { ly->work->reach = ly->it.h == TL_C(0.0) ? TL_C(0.0) : ly->tangents.h / ly->it.h; }

static void reach_to_mark(eom_lyapunov *ly) { ly->tangents.h = ly->work->reach * ly->it.h; }

/* The length of the next step; the first one of all is the integrator's choice, and where steps of the motion would be lost h is kept.
 */
static eom_status plan_step(eom_lyapunov *ly) {
  eom_integrator *it = &ly->tangents;
  tl_real end = it->t;
  if (!(ly->work->reach > TL_C(0.0))) return EOM_OK;
  const eom_status status = eom_lyapunov_path_after(ly, it->t, TL_LIBM(fmin)(ly->work->reach, most_reach), &end);
  if (status == EOM_OK) it->h = end - it->t;
  return status == EOM_NOT_IN_STEP ? EOM_OK : status;
}

static eom_status own_step(eom_lyapunov *ly, tl_real t_mark) {
  eom_lyapunov_work *w = ly->work;
  eom_integrator *it = &ly->tangents;
  eom_status status = plan_step(ly);
  if (status == EOM_OK) status = eom_integrate(it, t_mark, stop_after_step, NULL);
  if (w->path.status != EOM_OK) return w->path.status;
  if (status == EOM_STOPPED) w->reach = eom_lyapunov_path_steps(ly, it->t_before, it->t) * it->h / (it->t - it->t_before);
  return status;
}

/* One step that is chosen. */
static eom_status chosen_step(eom_lyapunov *ly, tl_real t_mark, bool *at_mark) {
  if (is_worked_out(ly)) return EOM_TOO_MUCH_WORK;
  const eom_status status = ly->work->together ? eom_integrate(&ly->it, t_mark, stop_after_step, NULL) : own_step(ly, t_mark);
  *at_mark = eom_lyapunov_stepper(ly)->t == t_mark;
  return status == EOM_STOPPED ? EOM_OK : status;
}

/* One step towards the mark. */
static eom_status advance(eom_lyapunov *ly, tl_real t_mark, bool *at_mark) {
  const eom_status status = ly->it.controlled ? chosen_step(ly, t_mark, at_mark) : fixed_step(ly, at_mark);
  return status == EOM_RHS_FAILED ? (eom_status)eom_lyapunov_stepper(ly)->rhs_code : status;
}

static eom_status to_mark(eom_lyapunov *ly) {
  const tl_real t_mark = ly->t0 + (tl_real)(ly->marks + 1) * ly->options.interval;
  eom_lyapunov_path_begin(ly, t_mark);
  if (!ly->work->together) reach_from_mark(ly);
  for (bool at_mark = false; !at_mark;) {
    eom_status status = advance(ly, t_mark, &at_mark);
    if (status == EOM_OK && is_qr_due(ly, eom_lyapunov_stepper(ly)->t, at_mark)) status = make_orthonormal(ly);
    if (status != EOM_OK) return status;
  }
  return eom_lyapunov_take_mark(ly);
}

/* ---- marks ---- */

/* Closes the block under way when it is full; when all blocks are, merges neighbours. */
static void record_block(eom_lyapunov *ly) {
  const int k = ly->k;
  if (++ly->block_fill < ly->block_marks) return;
  tl_real *block = ly->block + ly->nblock * k;
  for (int i = 0; i < k; i++) {
    block[i] = ly->rho[i] - ly->block_start[i];
    ly->block_start[i] = ly->rho[i];
  }
  ly->block_fill = 0;
  if (++ly->nblock < EOM_LYAPUNOV_BLOCKS) return;
  for (int b = 0; b < EOM_LYAPUNOV_BLOCKS / 2; b++)
    for (int i = 0; i < k; i++) ly->block[b * k + i] = ly->block[2 * b * k + i] + ly->block[(2 * b + 1) * k + i];
  ly->nblock = EOM_LYAPUNOV_BLOCKS / 2;
  ly->block_marks *= 2;
}

eom_status eom_lyapunov_hold_rows(eom_lyapunov *ly, tl_real t, const tl_real *y) {
  eom_system *sys = ly->sys;
  const int n = sys->n;
  if (sys->m == 0) return EOM_OK;
  eom_lyapunov_forget(ly);
  memcpy(ly->work->column, y, 2 * (size_t)n * sizeof(tl_real));
  return eom_project(sys, ly->work->column, ly->work->column + n, t, NULL);
}

/* What integrators keep from their last step is not in a checkpoint, but for what rounding of y has lost. */
static void restart(eom_lyapunov *ly) {
  eom_restart_behind(&ly->it, 2 * ly->sys->n);
  if (!ly->work->together) eom_integrator_restart(&ly->tangents);
}

eom_status eom_lyapunov_take_mark(eom_lyapunov *ly) {
  const int n = ly->sys->n;
  const tl_real *y = ly->it.y;
  const eom_status status = eom_lyapunov_hold_rows(ly, ly->it.t, y);
  if (status != EOM_OK) return status;
  restart(ly);
  if (!ly->work->together) reach_to_mark(ly);
  return eom_energy(ly->sys, y, y + n, ly->it.t);
}

/* The volume of k = d tangents grows by the divergence of the motion within the constraints. c = (phi, phi_dot, psi) follows c' = N c,
 * trace N = -2 alpha m1 - alpha m2, so that its rows C of unit growth take trace F's part -(log det C C')'/2 + trace N away. */
static tl_real divergence_at_mark(const eom_lyapunov *ly) {
  const eom_system *sys = ly->sys;
  const eom_lyapunov_work *w = ly->work;
  const tl_real rate = sys->options.baumgarte.alpha * (tl_real)(2 * sys->m1 + sys->m2);
  return eom_lyapunov_X(ly)[w->dim - 2 * sys->n - 1] + (w->log_volume - w->log_volume_0) + rate * (ly->it.t - ly->t0);
}

void eom_lyapunov_keep_mark(eom_lyapunov *ly) {
  eom_lyapunov_moment *mark = &ly->work->mark;
  const size_t d = 2 * (size_t)ly->sys->n;
  ly->divergence = divergence_at_mark(ly);
  mark->it = ly->it;
  mark->tangents = ly->tangents;
  memcpy(mark->z, ly->it.y, d * sizeof(tl_real));
  memcpy(mark->z + d, eom_lyapunov_X(ly), ((size_t)ly->work->dim - d) * sizeof(tl_real));
  memcpy(mark->carry, ly->it.carry, d * sizeof(tl_real));
  memcpy(mark->rho, ly->rho, (size_t)ly->k * sizeof(tl_real));
  mark->span = ly->work->span;
  mark->qrs = ly->qrs;
}

void eom_lyapunov_put_mark(eom_lyapunov *ly) {
  const tl_real *z = ly->work->mark.z;
  const size_t d = 2 * (size_t)ly->sys->n;
  memcpy(ly->it.y, z, d * sizeof(tl_real));
  memcpy(eom_lyapunov_X(ly), z + d, ((size_t)ly->work->dim - d) * sizeof(tl_real));
  memcpy(ly->it.carry, ly->work->mark.carry, d * sizeof(tl_real));
  restart(ly);
}

static void go_back(eom_lyapunov *ly) {
  const eom_lyapunov_moment *mark = &ly->work->mark;
  ly->it = mark->it;
  ly->tangents = mark->tangents;
  eom_lyapunov_put_mark(ly);
  memcpy(ly->rho, mark->rho, (size_t)ly->k * sizeof(tl_real));
  ly->work->span = mark->span;
  ly->work->t_qr = ly->t;
  ly->qrs = mark->qrs;
}

eom_status eom_lyapunov_step(eom_lyapunov *ly) {
  const eom_status status = to_mark(ly);
  if (status != EOM_OK) {
    go_back(ly);
    return status;
  }
  ly->marks++;
  ly->t = ly->it.t;
  ly->energy = ly->sys->energy;
  ly->energy_error = TL_LIBM(fmax)(ly->energy_error, TL_LIBM(fabs)(ly->energy - ly->energy0));
  record_block(ly);
  eom_lyapunov_keep_mark(ly);
  return EOM_OK;
}

eom_status eom_lyapunov_to(eom_lyapunov *ly, tl_real t_end, eom_lyapunov_observe_fn *observe, void *observer) {
  const tl_real nearly = TL_C(1e-6); /* of an interval: rounding of t_end, which is no further mark */
  const tl_real interval = ly->options.interval;
  if (!((t_end - ly->t) / interval >= -nearly)) return EOM_BAD_OPTION;
  while ((t_end - ly->t) / interval > nearly && !eom_lyapunov_settled(ly)) {
    const eom_status status = eom_lyapunov_step(ly);
    if (status != EOM_OK) return status;
    if (observe && observe(observer, ly) != 0) return EOM_STOPPED;
  }
  return EOM_OK;
}
