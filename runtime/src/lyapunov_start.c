/* The start of a run of Lyapunov exponents: options, memory, the first directions. */
#include "lyapunov.h"

#include "eom/assemble.h"
#include "eom/project.h"
#include "eom/solve.h"
#include "step.h"

#include <assert.h>
#include <string.h>

/* ---- options ---- */

eom_lyapunov_options eom_lyapunov_options_default(void) {
  return (eom_lyapunov_options){
      .scheme = EOM_LYAPUNOV_DISCRETE, .control = {.rtol = TL_C(1e-10), .atol = TL_C(1e-10)}, .tangent_tolerance = TL_C(1e-6)};
}

static bool is_bound(tl_real x) { return x >= TL_C(0.0) && x <= TL_MAX; }

static bool stop_is_valid(const eom_lyapunov_options *o, int most) {
  if (!is_bound(o->stop_half_width) || !is_bound(o->stop_after)) return false;
  return o->stop_half_width == TL_C(0.0) || (o->stop_exponent >= 0 && o->stop_exponent < (o->k > 0 ? o->k : most));
}

static bool scheme_is_valid(const eom_system *sys, const eom_lyapunov_options *o) {
  switch (o->scheme) {
  case EOM_LYAPUNOV_DISCRETE:
  case EOM_LYAPUNOV_CONTINUOUS:
    return true;
  case EOM_LYAPUNOV_PAPER:
    return sys->m == 0 && (o->k == 0 || o->k == 2 * sys->n);
  }
  return false;
}

/* How many exponents there are where no row depends on others; more where some do. */
static int exponents_at_least(const eom_system *sys) { return 2 * (sys->n - sys->m1) - sys->m2; }

/* What an evaluation with k tangents costs, one of the motion alone being 1: as measured with generated pendulums of 2, 6 and 16 links.
 */
static tl_real cost_of(const eom_system *sys, eom_lyapunov_product product, int k) {
  const tl_real n = (tl_real)sys->n, directions = (tl_real)k;
  return product == EOM_LYAPUNOV_BY_JACOBIAN ? TL_C(0.6) + n / TL_C(5.0) + directions / TL_C(12.0)
                                             : TL_C(1.2) + n * directions / TL_C(25.0);
}

/* BY_COST where the system was asked for nothing that would do. */
static eom_lyapunov_product choose_product(const eom_system *sys, const eom_lyapunov_options *o) {
  const bool jacobian = sys->options.needs & EOM_NEED_LINEARISE, directions = sys->options.needs & EOM_NEED_TANGENT;
  const bool all = o->k == 0 || o->k >= exponents_at_least(sys);
  switch (o->product) {
  case EOM_LYAPUNOV_BY_JACOBIAN:
    return jacobian ? o->product : EOM_LYAPUNOV_BY_COST;
  case EOM_LYAPUNOV_BY_DIRECTIONS:
    return directions ? o->product : EOM_LYAPUNOV_BY_COST;
  case EOM_LYAPUNOV_BY_COST:
    break;
  }
  if (!directions) return jacobian ? EOM_LYAPUNOV_BY_JACOBIAN : EOM_LYAPUNOV_BY_COST;
  if (!jacobian) return EOM_LYAPUNOV_BY_DIRECTIONS;
  if (all || eom_system_emitter(sys, EOM_TASK_TANGENT) == EOM_EMITTER_CALLS) return EOM_LYAPUNOV_BY_JACOBIAN;
  const bool cheaper = cost_of(sys, EOM_LYAPUNOV_BY_DIRECTIONS, o->k) < cost_of(sys, EOM_LYAPUNOV_BY_JACOBIAN, o->k);
  return cheaper ? EOM_LYAPUNOV_BY_DIRECTIONS : EOM_LYAPUNOV_BY_JACOBIAN;
}

static bool options_are_valid(const eom_system *sys, const eom_lyapunov_options *o) {
  if (!scheme_is_valid(sys, o) || o->k < 0 || o->k > 2 * sys->n) return false;
  if (o->interval == TL_C(0.0) || !TL_ISFINITE(o->interval) || !is_bound(o->h)) return false;
  if (o->h == TL_C(0.0) ? !(o->tangent_tolerance > TL_C(0.0)) : o->taylor) return false;
  return stop_is_valid(o, 2 * sys->n);
}

/* The options as they hold; BAD_OPTION. Steps of a fixed length are of one sign with the interval and divide it. */
static eom_status settle_options(const eom_system *sys, const eom_lyapunov_options *given, eom_lyapunov_options *o) {
  *o = given ? *given : eom_lyapunov_options_default();
  if (o->product != EOM_LYAPUNOV_BY_COST && o->product != EOM_LYAPUNOV_BY_JACOBIAN && o->product != EOM_LYAPUNOV_BY_DIRECTIONS)
    return EOM_BAD_OPTION;
  if (!options_are_valid(sys, o)) return EOM_BAD_OPTION;
  o->product = choose_product(sys, o);
  if (!o->method) o->method = &eom_dop853;
  return o->product == EOM_LYAPUNOV_BY_COST ? EOM_BAD_OPTION : EOM_OK;
}

/* ---- memory ---- */

/* Steps of the tangents' own save evaluations of derivatives, and may cost three more of the motion in each of its steps to
 * interpolate. Of pendulums by dop853 it was measured that tangents take 1.35 ratio^(1/8) of the motion's steps, ratio that of the two
 * tolerances, and that most steps of the motion need no further evaluations where its tolerance^(5/8) is below a 50th of the tangents'.
 */
static bool pay_off(const eom_system *sys, const eom_lyapunov_options *o) {
  const eom_method *m = o->method;
  const int d = exponents_at_least(sys), k = o->k > 0 ? o->k : d > 0 ? d : 1;
  const tl_real tolerance = TL_LIBM(fmax)(o->control.rtol, o->control.atol), q = (tl_real)m->error_power;
  const tl_real steps = TL_C(1.35) * TL_LIBM(pow)(tolerance / o->tangent_tolerance, TL_C(1.0) / q);
  const bool from_ends = TL_C(50.0) * TL_LIBM(pow)(tolerance, TL_C(5.0) / q) < o->tangent_tolerance;
  const tl_real evaluations = (tl_real)(m->stages + (from_ends ? 0 : m->dense_stages));
  return evaluations < (tl_real)m->stages * cost_of(sys, o->product, k) * (TL_C(1.0) - steps);
}

/* Of Taylor series tangents have no part. Else y and tangents go together where steps are fixed, or it does not pay to part them; and
 * where the rows that are held (eom_hold) are those of the last step's end, at which tangents must then be. */
static bool go_together(const eom_system *sys, const eom_lyapunov_options *o) {
  if (o->taylor) return false;
  return o->h > TL_C(0.0) || (sys->m > 0 && sys->options.hold.on) || !pay_off(sys, o);
}

static int dimension(const eom_system *sys, const eom_lyapunov_options *o, int k) {
  return 2 * sys->n * (1 + k) + (o->scheme == EOM_LYAPUNOV_DISCRETE ? 0 : k) + 1;
}

/* What k does not change. */
static void lay_out_rows(eom_lyapunov *ly, eom_lyapunov_work *w, eom_arena *a) {
  const eom_system *sys = ly->sys;
  const size_t d = 2 * (size_t)sys->n;
  w->rows = sys->m1 + sys->m;
  ly->work = eom_arena_take(a, 1, sizeof(eom_lyapunov_work));
  w->C = eom_arena_reals(a, (size_t)w->rows * d);
  w->rates = eom_arena_reals(a, (size_t)sys->m * (size_t)sys->n);
  w->tau_C = eom_arena_reals(a, d);
  w->pivot = eom_arena_take(a, (size_t)w->rows, sizeof(int));
  w->tau = eom_arena_reals(a, d);
  w->column = eom_arena_reals(a, d);
  w->seen = eom_arena_reals(a, d);
}

/* Of a step that is kept, by any interpolation. */
static int path_rows(const eom_lyapunov_options *o) {
  const int rows = o->taylor ? EOM_SERIES_ROWS : eom_kept_rows(o->method);
  return rows > EOM_MOTION_ROWS ? rows : EOM_MOTION_ROWS;
}

static void lay_out_tangents(eom_lyapunov *ly, eom_lyapunov_work *w, eom_arena *a, int most) {
  const eom_system *sys = ly->sys;
  const eom_lyapunov_options *o = &ly->options;
  const bool discrete = o->scheme == EOM_LYAPUNOV_DISCRETE, chosen = o->h == TL_C(0.0);
  const size_t d = 2 * (size_t)sys->n, k = (size_t)most;
  w->dim = dimension(sys, o, most);
  const size_t dim = (size_t)w->dim;
  w->vectors = eom_arena_reals(a, k * d);
  w->log_R = eom_arena_reals(a, k);
  w->FX = eom_arena_reals(a, discrete ? 0 : d * k);
  w->K = eom_arena_reals(a, discrete ? 0 : k * k);
  w->dlambda = eom_arena_reals(a, o->product == EOM_LYAPUNOV_BY_DIRECTIONS ? (size_t)sys->m * k : 0);
  w->together = go_together(sys, o);
  const int first = w->together ? w->dim : (int)d, second = w->dim - first;
  w->integrator = eom_arena_reals(a, o->taylor ? eom_taylor_size(sys) : eom_integrator_size(o->method, first));
  w->tangents = eom_arena_reals(a, second > 0 ? eom_integrator_size(o->method, second) : 0);
  w->path.size = second > 0 ? (size_t)path_rows(o) * d : 0;
  w->path.kept = eom_arena_reals(a, w->path.size * EOM_PATH_STEPS);
  w->y = eom_arena_reals(a, d);
  w->rtol = eom_arena_reals(a, chosen ? dim : 0);
  w->atol = eom_arena_reals(a, chosen ? dim : 0);
  w->mark.z = eom_arena_reals(a, dim);
  w->mark.carry = eom_arena_reals(a, d);
  w->mark.rho = eom_arena_reals(a, k);
  w->scratch = eom_arena_reals(a, dim);
  ly->block = eom_arena_reals(a, k * EOM_LYAPUNOV_BLOCKS);
  ly->block_start = eom_arena_reals(a, k);
  ly->rho = eom_arena_reals(a, discrete ? k : 0);
}

size_t eom_lyapunov_bytes(const eom_system *sys, const eom_lyapunov_options *options) {
  eom_system sizes = *sys;
  eom_lyapunov ly = {.sys = &sizes};
  eom_lyapunov_work work;
  eom_arena count = {0};
  if (settle_options(sys, options, &ly.options) != EOM_OK) return 0;
  lay_out_rows(&ly, &work, &count);
  lay_out_tangents(&ly, &work, &count, ly.options.k > 0 ? ly.options.k : 2 * sys->n);
  return count.overflow ? 0 : count.used + EOM_ALIGNMENT;
}

/* ---- the start ---- */

/* What scales of a group of numbers are divided by, so that the error is that of the group: see eom_step_control, whose mean is taken
 * over all numbers of an integrator. */
static tl_real share(int count, int all) { return TL_LIBM(sqrt)((tl_real)count / (tl_real)all); }

/* Tolerances: those given for y; one for the tangents and rho; none for the integral of trace F, which is a check. all_y, all_X: how
 * many numbers the integrators of both have. */
static bool set_tolerances(eom_lyapunov *ly, int all_y, int all_X) {
  const eom_lyapunov_work *w = ly->work;
  const eom_lyapunov_options *o = &ly->options;
  const int d = 2 * ly->sys->n, tangents = w->dim - d - 1;
  const tl_real none = TL_C(1.0) / TL_EPSILON, y_share = share(d, all_y);
  const tl_real tolerance = TL_LIBM(fmin)(o->tangent_tolerance * share(tangents, all_X), none);
  for (int i = 0; i < d; i++) {
    w->rtol[i] = (o->control.rtol_each ? o->control.rtol_each[i] : o->control.rtol) * y_share;
    w->atol[i] = (o->control.atol_each ? o->control.atol_each[i] : o->control.atol) * y_share;
    if (w->rtol[i] == TL_C(0.0) && w->atol[i] == TL_C(0.0)) return false;
  }
  for (int i = d; i < d + tangents; i++) w->rtol[i] = w->atol[i] = tolerance;
  w->rtol[w->dim - 1] = TL_C(0.0);
  w->atol[w->dim - 1] = none;
  return true;
}

static eom_status control_steps(eom_lyapunov *ly) {
  const eom_lyapunov_work *w = ly->work;
  eom_step_control control = ly->options.control;
  if (!set_tolerances(ly, ly->it.dim, w->together ? ly->it.dim : ly->tangents.dim)) return EOM_BAD_OPTION;
  control.most_steps = 0; /* of an interval, not of a step */
  control.tested = 0;
  control.rtol_each = w->rtol;
  control.atol_each = w->atol;
  eom_status status = eom_integrator_control(&ly->it, &control);
  if (status != EOM_OK || w->together) return status;
  control.rtol_each = w->rtol + ly->it.dim;
  control.atol_each = w->atol + ly->it.dim;
  return eom_integrator_control(&ly->tangents, &control);
}

/* After a step the state is brought onto the constraints. */
static int project_state(void *user, tl_real t, tl_real *z) {
  eom_lyapunov *ly = user;
  eom_lyapunov_forget(ly);
  return eom_project_state(ly->sys, t, z);
}

/* The motion alone. */
static int motion(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  eom_lyapunov *ly = user;
  eom_lyapunov_forget(ly);
  return eom_rhs(ly->sys, t, y, ydot);
}

/* Motion and tangents. */
static int both(void *user, tl_real t, const tl_real *z, tl_real *zdot) {
  eom_lyapunov *ly = user;
  const int d = 2 * ly->sys->n;
  return (int)eom_lyapunov_rates(ly, t, z, z + d, zdot, zdot + d);
}

/* The tangents along the motion that is ahead. */
static int tangents(void *user, tl_real t, const tl_real *X, tl_real *Xdot) {
  eom_lyapunov *ly = user;
  const eom_status status = eom_lyapunov_path_at(ly, t, ly->work->y);
  return (int)(status == EOM_OK ? eom_lyapunov_rates(ly, t, ly->work->y, X, NULL, Xdot) : status);
}

/* Fixed steps are of one sign with the interval and divide it. */
static void divide_interval(eom_lyapunov *ly) {
  eom_lyapunov_options *o = &ly->options;
  const tl_real parts = TL_LIBM(ceil)(TL_LIBM(fabs)(o->interval) / o->h * (TL_C(1.0) - TL_C(64.0) * TL_EPSILON));
  ly->work->steps_per_mark = parts > TL_C(1.0) ? (long)parts : 1;
  o->h = o->interval / (tl_real)ly->work->steps_per_mark;
}

/* The integrator of y, or of all. */
static eom_status start_motion(eom_lyapunov *ly, tl_real t, const tl_real *z) {
  eom_lyapunov_work *w = ly->work;
  const eom_lyapunov_options *o = &ly->options;
  const int d = 2 * ly->sys->n;
  if (o->taylor) return eom_taylor_init(&w->taylor, &ly->it, ly->sys, t, z, o->h, w->integrator);
  eom_integrator_init(&ly->it, o->method, w->together ? both : motion, ly, w->together ? w->dim : d, t, z, o->h, w->integrator);
  return EOM_OK;
}

/* z: y, then what tangents integrate. */
static eom_status start_integration(eom_lyapunov *ly, tl_real t, const tl_real *z) {
  eom_lyapunov_work *w = ly->work;
  eom_lyapunov_options *o = &ly->options;
  const bool chosen = o->h == TL_C(0.0);
  const int d = 2 * ly->sys->n;
  if (!chosen) divide_interval(ly);
  const eom_status status = start_motion(ly, t, z);
  if (status != EOM_OK) return status;
  if (!w->together) eom_integrator_init(&ly->tangents, o->method, tangents, ly, w->dim - d, t, z + d, o->h, w->tangents);
  if (ly->sys->m > 0) ly->it.correct = project_state;
  ly->y = ly->it.y;
  ly->Q = eom_lyapunov_X(ly);
  if (o->scheme != EOM_LYAPUNOV_DISCRETE) ly->rho = eom_lyapunov_X(ly) + eom_lyapunov_rho_at(ly);
  return chosen ? control_steps(ly) : EOM_OK;
}

/* The first directions: Q of z. */
static eom_status start_directions(eom_lyapunov *ly, tl_real *Q) {
  const tl_real *start = ly->options.start;
  ly->options.start = NULL;
  eom_lyapunov_span(ly, Q);
  if (!start) return EOM_OK;
  memcpy(Q, start, 2 * (size_t)ly->sys->n * (size_t)ly->k * sizeof(tl_real));
  const eom_status status = eom_lyapunov_orthonormalise(ly, Q);
  return status == EOM_OK && ly->work->loss > -TL_LIBM(log)(TL_LIBM(sqrt)(TL_EPSILON)) ? EOM_NOT_FINITE : status;
}

/* y on the constraints, and how many exponents there are. */
static eom_status start_state(eom_lyapunov *ly, tl_real t, tl_real *y) {
  eom_system *sys = ly->sys;
  const int n = sys->n;
  eom_status status = sys->m > 0 ? eom_project(sys, y, y + n, t, NULL) : EOM_OK;
  if (status == EOM_OK) status = eom_energy(sys, y, y + n, t);
  if (status != EOM_OK) return status;
  ly->energy0 = ly->energy = sys->energy;
  status = eom_lyapunov_factor_rows(ly, t, y);
  ly->work->log_volume_0 = ly->work->log_volume;
  ly->d = 2 * n - ly->work->rank;
  ly->k = ly->options.k > 0 ? ly->options.k : ly->d;
  if (status == EOM_OK && (ly->k > ly->d || ly->d == 0)) return EOM_BAD_OPTION;
  ly->options.k = ly->k;
  return status;
}

/* The first QR is due after the first step: before there was one nobody knows how fast tangents grow. */
static eom_status start(eom_lyapunov *ly, tl_real t, const tl_real *y, eom_arena *arena) {
  eom_lyapunov_work *w = ly->work;
  const size_t d = 2 * (size_t)ly->sys->n;
  memcpy(w->seen, y, d * sizeof(tl_real));
  eom_status status = start_state(ly, t, w->seen);
  if (status != EOM_OK) return status;
  lay_out_tangents(ly, w, arena, ly->k);
  tl_real *z = w->mark.z;
  memcpy(z, w->seen, d * sizeof(tl_real));
  status = start_directions(ly, z + d);
  if (status == EOM_OK) status = start_integration(ly, t, z);
  if (status == EOM_OK) status = eom_lyapunov_hold_rows(ly, t, z);
  if (status != EOM_OK) return status;
  ly->t0 = ly->t = w->t_qr = t;
  ly->block_marks = 1;
  eom_lyapunov_keep_mark(ly);
  return EOM_OK;
}

eom_status eom_lyapunov_init(eom_lyapunov *ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                             void *memory, size_t bytes) {
  assert(ly && sys && y);
  *ly = (eom_lyapunov){.sys = sys};
  const eom_status status = settle_options(sys, options, &ly->options);
  if (status != EOM_OK) return status;
  const size_t need = eom_lyapunov_bytes(sys, options);
  if (need == 0 || bytes < need || !memory) return EOM_NO_MEMORY;
  memset(memory, 0, bytes);
  eom_arena arena = eom_arena_at(memory);
  eom_lyapunov_work work = {0};
  lay_out_rows(ly, &work, &arena);
  *ly->work = work;
  return start(ly, t, y, &arena);
}
