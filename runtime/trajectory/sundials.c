/* Trajectories by SUNDIALS (6.1 to 7): CVODE's Adams and BDF methods, and explicit Runge-Kutta methods of ARKODE.
 *
 * CVODE and ARKODE have the same functions under other names; a table of them serves for all but the
 * start. */
#include "stepper.h"

#include "eom/linearise.h"
#include "eom/project.h"
#include "eom/solve.h"

#include <arkode/arkode_erkstep.h>
#include <cvodes/cvodes.h>
#include <cvodes/cvodes_proj.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(sizeof(sunrealtype) == sizeof(tl_real), "SUNDIALS was built for another type of number");

#if SUNDIALS_VERSION_MAJOR >= 7
#define NO_COMMUNICATOR SUN_COMM_NULL
#define ERKSTEP(name) ARKode##name
#else
#define NO_COMMUNICATOR NULL
#define ERKSTEP(name) ERKStep##name
#endif

/* Beyond these SUNDIALS would count as stuck by itself; the caller's most_steps is the bound. */
#define NO_BOUND 2000000000L

/* The functions of one of the two packages, of the same arguments. */
typedef struct package {
  int (*evolve)(void *memory, sunrealtype t_end, N_Vector y, sunrealtype *t, int task);
  int (*interpolate)(void *memory, sunrealtype t, int derivative, N_Vector y);
  int (*begin_with)(void *memory, sunrealtype h);
  int (*stop_at)(void *memory, sunrealtype t);
  int (*tolerances)(void *memory, sunrealtype rtol, N_Vector atol);
  int (*watch)(void *memory, int count, int (*roots)(sunrealtype t, N_Vector y, sunrealtype *g, void *user));
  int (*watch_direction)(void *memory, int *direction);
  int (*watch_quietly)(void *memory);
  int (*roots_found)(void *memory, int *found);
  int (*steps)(void *memory, long *count);
  int (*rejected)(void *memory, long *count);
  void (*destroy)(void **memory);
} package;

typedef struct sundials {
  const eom_trajectory_method *method;
  const package *p;
  SUNContext context;
  void *memory; /* of the package */
  int dim;      /* of y: the trajectory's, but for columns that CVODES follows */
  N_Vector y, at, atol;
  int columns; /* that CVODES follows; 0: none */
  N_Vector *S, *S_atol;
  tl_real *z, *zdot; /* of the trajectory's dim, where there are such columns */
  SUNMatrix J;
  SUNLinearSolver solver;
  SUNNonlinearSolver iteration;
  int *found; /* count of events */
  int code;   /* what accelerations, events or projection returned where they failed */
  long evaluations, jacobians;
  long steps, rejected; /* before the last restart, as far as SUNDIALS does not count them any more */
  int direction;        /* of time: 1, -1; 0 before the first step */
} sundials;

/* ---- what SUNDIALS calls ---- */

/* As SUNDIALS wants it: 0, or a failure that a shorter step may cure. */
static int recoverable(sundials *s, int code) {
  if (code != 0) s->code = code;
  return code != 0;
}

static int right_hand_side(sunrealtype t, N_Vector y, N_Vector ydot, void *user) {
  eom_trajectory *r = user;
  sundials *s = r->data;
  s->evaluations++;
  const int alone = s->columns > 0;
  eom_rhs_fn *rhs = alone ? eom_rhs : eom_trajectory_rhs(r);
  return recoverable(s, rhs(alone ? r->sys : eom_trajectory_user(r), t, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot)));
}

/* z = (y, S) from CVODES' columns, and the other way. */
static void gather(const sundials *s, tl_real *z, N_Vector y, N_Vector *S) {
  memcpy(z, N_VGetArrayPointer(y), (size_t)s->dim * sizeof *z);
  for (int j = 0; j < s->columns; j++)
    for (int i = 0; i < s->dim; i++) z[s->dim + i * s->columns + j] = N_VGetArrayPointer(S[j])[i];
}

static void scatter(const sundials *s, N_Vector *S, const tl_real *z) {
  for (int j = 0; j < s->columns; j++)
    for (int i = 0; i < s->dim; i++) N_VGetArrayPointer(S[j])[i] = z[s->dim + i * s->columns + j];
}

/* S' of all columns. */
static int columns_rhs(int count, sunrealtype t, N_Vector y, N_Vector ydot, N_Vector *S, N_Vector *Sdot, void *user, N_Vector a,
                       N_Vector b) {
  eom_trajectory *r = user;
  sundials *s = r->data;
  (void)count, (void)ydot, (void)a, (void)b;
  s->evaluations++;
  gather(s, s->z, y, S);
  if (recoverable(s, eom_sensitivity_rhs(r->options.sensitivity, t, s->z, s->zdot))) return 1;
  scatter(s, Sdot, s->zdot);
  return 0;
}

/* F = [0 1; qdd_y] in columns. */
static int jacobian(sunrealtype t, N_Vector y, N_Vector ydot, SUNMatrix J, void *user, N_Vector a, N_Vector b, N_Vector c) {
  eom_trajectory *r = user;
  sundials *s = r->data;
  const int n = r->sys->n;
  const sunrealtype *x = N_VGetArrayPointer(y);
  (void)ydot, (void)a, (void)b, (void)c;
  s->jacobians++;
  if (recoverable(s, (int)eom_linearise(r->sys, x, x + n, t))) return 1;
  for (int j = 0; j < 2 * n; j++) {
    sunrealtype *column = SUNDenseMatrix_Column(J, j);
    for (int i = 0; i < n; i++) column[i] = j == n + i ? 1.0 : 0.0;
    for (int i = 0; i < n; i++) column[n + i] = r->sys->qdd_y[i * 2 * n + j];
  }
  return 0;
}

static const package cvode = {CVode,
                              CVodeGetDky,
                              CVodeSetInitStep,
                              CVodeSetStopTime,
                              CVodeSVtolerances,
                              CVodeRootInit,
                              CVodeSetRootDirection,
                              CVodeSetNoInactiveRootWarn,
                              CVodeGetRootInfo,
                              CVodeGetNumSteps,
                              CVodeGetNumErrTestFails,
                              CVodeFree};
static const package arkode = {ERKSTEP(Evolve),       ERKSTEP(GetDky),      ERKSTEP(SetInitStep),        ERKSTEP(SetStopTime),
                               ERKSTEP(SVtolerances), ERKSTEP(RootInit),    ERKSTEP(SetRootDirection),   ERKSTEP(SetNoInactiveRootWarn),
                               ERKSTEP(GetRootInfo),  ERKSTEP(GetNumSteps), ERKSTEP(GetNumErrTestFails), ERKSTEP(Free)};

/* Tolerances below which rounding of a projection counts beside them, and what an error estimate of its remainder is multiplied by. */
static const double fine_tolerance = 4096.0 * TL_EPSILON, remainder_weight = 8.0;

/* Of estimates CVODE tests the constrained part alone where tolerances are that fine. Rounding moves a projected state across the
 * constraints by digits of its largest component; the differences of backward differences multiply it, and small components would
 * answer by ever shorter steps. */
static int is_fine(const eom_step_control *c, int dim) {
  double least = c->atol;
  for (int i = 0; c->atol_each && i < dim; i++) least = i == 0 ? c->atol_each[i] : fmin(least, c->atol_each[i]);
  return c->rtol < fine_tolerance && least < fine_tolerance;
}

/* What the constraints allow of an error estimate of the state y (E. Eich, SIAM J. Numer. Anal. 30 (1993)). The weight makes up for
 * the rest, which shortens the steps of other tolerances. */
static int project_error(eom_trajectory *r, sunrealtype t, const tl_real *y, tl_real *error) {
  const int n = r->sys->n;
  const int code = (int)eom_project_change(r->sys, error, error + n, y, y + n, t);
  for (int i = 0; i < 2 * n; i++) error[i] *= remainder_weight;
  return code;
}

/* CVODE's projection: the change that the state needs. */
static int projection(sunrealtype t, N_Vector y, N_Vector change, sunrealtype tolerance, N_Vector error, void *user) {
  eom_trajectory *r = user;
  const size_t dim = 2 * (size_t)r->sys->n;
  sunrealtype *to = N_VGetArrayPointer(change);
  const sunrealtype *from = N_VGetArrayPointer(y);
  (void)tolerance;
  memcpy(to, from, dim * sizeof *to);
  if (recoverable(r->data, eom_project_state(r->sys, t, to))) return 1;
  if (error && recoverable(r->data, project_error(r, t, to, N_VGetArrayPointer(error)))) return 1;
  for (size_t i = 0; i < dim; i++) to[i] -= from[i];
  return 0;
}

/* ARKODE's: in place. */
static int postprocess(sunrealtype t, N_Vector y, void *user) {
  eom_trajectory *r = user;
  return recoverable(r->data, eom_trajectory_correct(r)(eom_trajectory_user(r), t, N_VGetArrayPointer(y)));
}

static int roots(sunrealtype t, N_Vector y, sunrealtype *g, void *user) {
  eom_trajectory *r = user;
  const eom_events *events = r->options.events;
  return recoverable(r->data, events->root(events->user, t, N_VGetArrayPointer(y), g));
}

/* ---- start ---- */

static int set_tolerances(const eom_trajectory *r, const sundials *s) {
  const eom_step_control *c = &r->options.control;
  sunrealtype *atol = N_VGetArrayPointer(s->atol);
  for (int i = 0; i < s->dim; i++) atol[i] = c->atol_each ? c->atol_each[i] : c->atol;
  return s->p->tolerances(s->memory, c->rtol, s->atol);
}

static int set_events(const eom_trajectory *r, const sundials *s) {
  const eom_events *events = r->options.events;
  if (!events) return 0;
  int *direction = (int *)(uintptr_t)events->direction; /* not changed */
  int code = s->p->watch(s->memory, events->count, roots);
  if (code == 0 && direction) code = s->p->watch_direction(s->memory, direction);
  return code == 0 ? s->p->watch_quietly(s->memory) : code;
}

static int start_columns(eom_trajectory *r, const sundials *s) {
  const eom_step_control *c = &r->options.control;
  for (int j = 0; j < s->columns; j++)
    for (int i = 0; i < s->dim; i++)
      N_VGetArrayPointer(s->S_atol[j])[i] = c->atol_each ? c->atol_each[s->dim + i * s->columns + j] : c->atol;
  const int code = CVodeSensInit(s->memory, s->columns, CV_STAGGERED, columns_rhs, s->S);
  if (code != 0) return code;
  return CVodeSensSVtolerances(s->memory, c->rtol, s->S_atol) | CVodeSetSensErrCon(s->memory, c->tested == 0);
}

static int start_cvode(eom_trajectory *r, sundials *s, int implicit) {
  const eom_step_control *c = &r->options.control;
  if (!(s->memory = CVodeCreate(implicit ? CV_BDF : CV_ADAMS, s->context))) return 1;
  int code = CVodeInit(s->memory, right_hand_side, r->t, s->y);
  code |= CVodeSetUserData(s->memory, r) | set_tolerances(r, s) | CVodeSetMaxNumSteps(s->memory, NO_BOUND);
  code |= CVodeSetMaxHnilWarns(s->memory, -1) | CVodeSetMaxStep(s->memory, c->h_max);
  if (code != 0) return code;
  if (!implicit) {
    s->iteration = SUNNonlinSol_FixedPoint(s->y, 0, s->context);
    return s->iteration ? CVodeSetNonlinearSolver(s->memory, s->iteration) : 1;
  }
  s->J = SUNDenseMatrix(s->dim, s->dim, s->context);
  s->solver = s->J ? SUNLinSol_Dense(s->y, s->J, s->context) : NULL;
  if (!s->solver) return 1;
  code = CVodeSetLinearSolver(s->memory, s->solver, s->J) | CVodeSetJacFn(s->memory, jacobian);
  if (code == 0 && s->columns > 0) code = start_columns(r, s);
  if (code == 0 && r->options.project && r->sys->m > 0)
    code = CVodeSetProjFn(s->memory, projection) | CVodeSetProjErrEst(s->memory, is_fine(c, s->dim));
  return code;
}

static int start_arkode(eom_trajectory *r, sundials *s, const char *name) {
  const eom_step_control *c = &r->options.control;
  /* Not Verner's 6(5): SUNDIALS 6.4 takes its last stage for the slope of the next step (LLNL/sundials issue 311), and loses two
   * orders. */
  const ARKODE_ERKTableID table = strcmp(name, "arkode_dp5") == 0 ? ARKODE_DORMAND_PRINCE_7_4_5 : ARKODE_FEHLBERG_13_7_8;
  if (!(s->memory = ERKStepCreate(right_hand_side, r->t, s->y, s->context))) return 1;
  int code = ERKSTEP(SetUserData)(s->memory, r) | ERKStepSetTableNum(s->memory, table) | set_tolerances(r, s);
  code |= ERKSTEP(SetMaxNumSteps)(s->memory, NO_BOUND) | ERKSTEP(SetMaxStep)(s->memory, c->h_max);
  code |= ERKSTEP(SetMaxHnilWarns)(s->memory, -1);
  if (code == 0 && r->options.project && r->sys->m > 0) code = ERKSTEP(SetPostprocessStepFn)(s->memory, postprocess);
  return code;
}

/* SUNDIALS prints nothing; what went wrong is in the status. */
#if SUNDIALS_VERSION_MAJOR >= 7
static int silence(const sundials *s) { return (int)SUNContext_ClearErrHandlers(s->context); }
#else
static void say_nothing(int code, const char *module, const char *function, char *message, void *user) {
  (void)code, (void)module, (void)function, (void)message, (void)user;
}
static int silence(const sundials *s) {
  if (!s->memory) return 0;
  return s->p == &cvode ? CVodeSetErrHandlerFn(s->memory, say_nothing, NULL) : ERKStepSetErrHandlerFn(s->memory, say_nothing, NULL);
}
#endif

/* Makes the memory of the package, which begins at r->t from s->y. */
static int start(eom_trajectory *r) {
  sundials *s = r->data;
  const int code = s->p == &cvode ? start_cvode(r, s, s->method->implicit) : start_arkode(r, s, s->method->name);
  return code | silence(s) | set_events(r, s);
}

static int make_columns(sundials *s, int dim) {
  s->S = N_VCloneVectorArray(s->columns, s->y);
  s->S_atol = s->S ? N_VCloneVectorArray(s->columns, s->y) : NULL;
  s->z = calloc(2 * (size_t)dim, sizeof *s->z);
  s->zdot = s->z ? s->z + dim : NULL;
  return s->S_atol && s->z;
}

static void put_state(const eom_trajectory *r, const sundials *s) {
  memcpy(N_VGetArrayPointer(s->y), r->y, (size_t)s->dim * sizeof(tl_real));
  scatter(s, s->S, r->y);
}

static eom_status create(eom_trajectory *r, const eom_trajectory_method *method) {
  sundials *s = r->data = calloc(1, sizeof *s);
  if (!s) return EOM_NO_MEMORY;
  const eom_step_control *c = &r->options.control;
  const int columns = method->implicit && r->options.sensitivity ? r->options.sensitivity->k : 0;
  if (c->rtol_each || (c->tested != 0 && !(columns > 0 && c->tested == 2 * r->sys->n)) || c->h_min != 0.0 || !(c->rtol >= 0.0) ||
      !(c->atol >= 0.0) || !(c->h_max >= 0.0))
    return EOM_BAD_OPTION;
  s->method = method;
  s->p = strncmp(method->name, "cvode", strlen("cvode")) == 0 ? &cvode : &arkode;
  s->found = calloc(r->options.events ? (size_t)r->options.events->count + 1 : 1, sizeof *s->found);
  if (!s->found || SUNContext_Create(NO_COMMUNICATOR, &s->context) != 0) return EOM_NO_MEMORY;
  s->columns = columns;
  s->dim = columns > 0 ? 2 * r->sys->n : r->dim;
  s->y = N_VNew_Serial(s->dim, s->context);
  s->at = s->y ? N_VClone(s->y) : NULL;
  s->atol = s->at ? N_VClone(s->y) : NULL;
  if (!s->atol || (columns > 0 && !make_columns(s, r->dim))) return EOM_NO_MEMORY;
  put_state(r, s);
  return start(r) == 0 ? EOM_OK : EOM_NO_MEMORY;
}

static void destroy(eom_trajectory *r) {
  sundials *s = r->data;
  if (!s) return;
  if (s->memory) s->p->destroy(&s->memory);
  if (s->iteration) SUNNonlinSolFree(s->iteration);
  if (s->solver) SUNLinSolFree(s->solver);
  if (s->J) SUNMatDestroy(s->J);
  if (s->S) N_VDestroyVectorArray(s->S, s->columns);
  if (s->S_atol) N_VDestroyVectorArray(s->S_atol, s->columns);
  if (s->atol) N_VDestroy(s->atol);
  if (s->at) N_VDestroy(s->at);
  if (s->y) N_VDestroy(s->y);
  if (s->context) SUNContext_Free(&s->context);
  free(s->found);
  free(s->z);
  free(s);
}

/* ---- steps ---- */

static eom_status verdict(int flag) {
  switch (flag) {
  case CV_TOO_MUCH_WORK:
    return EOM_TOO_MUCH_WORK;
  case CV_ILL_INPUT: /* a component that is zero, without an absolute tolerance */
    return EOM_BAD_OPTION;
  case CV_RHSFUNC_FAIL:
  case CV_FIRST_RHSFUNC_ERR:
  case CV_REPTD_RHSFUNC_ERR:
  case CV_UNREC_RHSFUNC_ERR:
  case CV_RTFUNC_FAIL:
    return EOM_RHS_FAILED;
  default:
    return EOM_STEP_TOO_SMALL;
  }
}

/* The state at t in the last step, or null. */
static const tl_real *state_at(const eom_trajectory *r, tl_real t) {
  const sundials *s = r->data;
  if (s->p->interpolate(s->memory, t, 0, s->at) != 0) return NULL;
  if (s->columns == 0) return N_VGetArrayPointer(s->at);
  if (CVodeGetSensDky(s->memory, t, 0, s->S) != 0) return NULL;
  gather(s, s->z, s->at, s->S);
  return s->z;
}

/* The outputs up to now. The state at t itself is not interpolated. */
static eom_status write_outputs(eom_trajectory *r, tl_real before) {
  eom_outputs *o = r->options.outputs;
  const tl_real sign = r->t >= before ? TL_C(1.0) : TL_C(-1.0);
  for (; o && o->next < o->count; o->next++) {
    const tl_real t = o->times ? o->times[o->next] : o->first + (tl_real)o->next * o->every;
    if (sign * (t - r->t) > TL_C(0.0)) break;
    if (sign * (t - before) < TL_C(0.0)) return EOM_NOT_IN_STEP;
    const tl_real *y = t == r->t ? r->y : state_at(r, t);
    if (!y) return EOM_NOT_IN_STEP;
    o->write(o->user, t, y);
  }
  return EOM_OK;
}

/* As SUNDIALS counts. */
static void count(const sundials *s, long *steps, long *rejected) {
  *steps = *rejected = 0;
  s->p->steps(s->memory, steps);
  s->p->rejected(s->memory, rejected);
}

static eom_trajectory_work worked(const eom_trajectory *r) {
  const sundials *s = r->data;
  eom_trajectory_work w = {.evaluations = s->evaluations, .jacobians = s->jacobians};
  count(s, &w.steps, &w.rejected);
  w.steps += s->steps;
  w.rejected += s->rejected;
  return w;
}

/* Begins anew at r->t from the state r->y. ARKODE keeps the direction of time when it is only told of another state: it is made anew.
 */
static eom_status restart(eom_trajectory *r) {
  sundials *s = r->data;
  const eom_trajectory_work before = worked(r);
  put_state(r, s);
  s->direction = 0;
  s->steps = before.steps;
  s->rejected = before.rejected;
  if (s->p == &cvode) {
    int code = CVodeReInit(s->memory, r->t, s->y);
    if (code == 0 && s->columns > 0) code = CVodeSensReInit(s->memory, CV_STAGGERED, s->S);
    return code == 0 ? EOM_OK : EOM_STEP_TOO_SMALL;
  }
  s->p->destroy(&s->memory);
  return start(r) == 0 ? EOM_OK : EOM_NO_MEMORY;
}

/* Calls the handlers of the events at r->t. */
static eom_status handle_events(eom_trajectory *r) {
  sundials *s = r->data;
  eom_events *events = r->options.events;
  int changed = 0, stop = 0;
  if (s->p->roots_found(s->memory, s->found) != 0) return EOM_STEP_TOO_SMALL;
  for (int i = 0; i < events->count; i++) {
    if (s->found[i] == 0) continue;
    events->found++;
    events->last = i;
    const eom_event_action action = events->handle ? events->handle(events->user, i, r->t, r->y) : EOM_EVENT_STOP;
    changed |= action != EOM_EVENT_GO_ON && events->handle;
    stop |= action == EOM_EVENT_STOP;
  }
  const eom_status status = changed ? restart(r) : EOM_OK;
  return status == EOM_OK && stop ? EOM_STOPPED : status;
}

/* One step, or the part of it before an event. */
static eom_status step(eom_trajectory *r, tl_real t_end) {
  sundials *s = r->data;
  const tl_real before = r->t;
  sunrealtype t = before;
  s->code = 0;
  const int flag = s->p->evolve(s->memory, t_end, s->y, &t, CV_ONE_STEP);
  if (flag < 0) return s->code != 0 && verdict(flag) != EOM_TOO_MUCH_WORK ? EOM_RHS_FAILED : verdict(flag);
  r->t = t;
  if (s->columns > 0 && CVodeGetSens(s->memory, &t, s->S) != 0) return EOM_STEP_TOO_SMALL;
  gather(s, r->y, s->y, s->S);
  const eom_status written = write_outputs(r, before);
  return written == EOM_OK && flag == CV_ROOT_RETURN ? handle_events(r) : written;
}

/* SUNDIALS goes on in the direction that it began in. */
static eom_status head_for(eom_trajectory *r, tl_real t_end) {
  sundials *s = r->data;
  if (t_end == r->t) return EOM_OK;
  const int direction = t_end > r->t ? 1 : -1;
  const eom_status status = s->direction == -direction ? restart(r) : EOM_OK;
  if (status != EOM_OK) return status;
  if (s->direction == 0 && s->p->begin_with(s->memory, direction * fabs(r->options.h)) != 0) return EOM_BAD_OPTION;
  s->direction = direction;
  return s->p->stop_at(s->memory, t_end) == 0 ? EOM_OK : EOM_BAD_OPTION;
}

static eom_status to(eom_trajectory *r, tl_real t_end) {
  const long before = worked(r).steps, most = r->options.control.most_steps;
  eom_status status = write_outputs(r, r->t);
  while (status == EOM_OK && r->t != t_end) {
    if (most > 0 && worked(r).steps - before >= most) return EOM_TOO_MUCH_WORK;
    status = head_for(r, t_end);
    if (status == EOM_OK) status = step(r, t_end);
    const int good = status == EOM_OK || status == EOM_STOPPED;
    if (good && r->observe && r->observe(r->observer, r) != 0) return EOM_STOPPED;
  }
  return status;
}

const eom_stepper eom_sundials_stepper = {create, to, worked, destroy};
