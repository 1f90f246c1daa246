/* Systems: validation of the model, sizes, and one visible layout of all memory. */
#include "baumgarte.h"
#include "evaluate.h"
#include "stage.h"

#include "eom/bytes.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

eom_options eom_options_default(void) {
  const tl_real drop = TL_LIBM(cbrt)(TL_EPSILON * TL_C(4503.6)); /* 1e-4 in double */
  return (eom_options){.needs = EOM_NEED_LINEARISE,
                       .weights = NULL,
                       .rank_tolerance = TL_EPSILON * TL_C(450360.0), /* 1e-10 in double */
                       .consistency_tolerance = TL_LIBM(sqrt)(TL_EPSILON),
                       .linalg = EOM_LINALG_AUTO,
                       .emitter = EOM_EMITTER_AUTO,
                       .baumgarte = {TL_C(0.0), TL_C(0.0)},
                       .hold = {.on = 0, .drop = drop, .take = TL_C(3.0) * drop, .ahead = TL_C(50.0) * drop},
                       .most_jump = TL_C(0.1)};
}

/* ---- memory ---- */

eom_arena eom_arena_at(void *memory) {
  const size_t off = (uintptr_t)memory % EOM_ALIGNMENT;
  return (eom_arena){.base = (char *)memory + (off ? EOM_ALIGNMENT - off : 0)};
}

void *eom_arena_take(eom_arena *arena, size_t count, size_t size) {
  const size_t start = (arena->used + EOM_ALIGNMENT - 1) / EOM_ALIGNMENT * EOM_ALIGNMENT;
  if (start < arena->used || (size > 0 && count > (SIZE_MAX - start) / size)) {
    arena->overflow = true;
    return NULL;
  }
  arena->used = start + count * size;
  return arena->base && count > 0 ? arena->base + start : NULL;
}

tl_real *eom_arena_reals(eom_arena *arena, size_t count) { return eom_arena_take(arena, count, sizeof(tl_real)); }

static void take_arrays(eom_system *sys, eom_workspace *ws, eom_arena *arena) {
  const size_t n = (size_t)sys->n, m1 = (size_t)sys->m1, m2 = (size_t)sys->m2;
  const size_t linearise = EOM_LINEARISES(sys->options.needs), solves = EOM_SOLVES(sys->options.needs);
  const size_t vectors = ws->emitter[EOM_TASK_LINEARISE] == EOM_EMITTER_CALLS ? 2 * n : 1;
  const size_t constant_mass = sys->motion && sys->motion->constant_mass, weighted = sys->options.weights != NULL;
  const size_t stabilised = eom_is_stabilised(sys), work = sys->motion ? sys->motion->work : 0;
#define EOM_TAKE(place, type, count) place = eom_arena_take(arena, count, sizeof(type));
  EOM_SYSTEM_ARRAYS(EOM_TAKE, n, m1, m2, linearise, solves, vectors, constant_mass, weighted, stabilised, work, ws->njets, ws->ncontext)
#undef EOM_TAKE
}

/* ---- the plan of a system: sizes, shapes, stages ---- */

static bool function_is_complete(const eom_function *f) { return f->jet && f->rows && f->frame && f->name; }

/* Rows of a list of constraint functions, or -1. */
static int count_rows(const eom_function *list, int count, const void *params) {
  if (count < 0 || (count > 0 && !list)) return -1;
  int rows = 0;
  for (int i = 0; i < count; i++) {
    if (!function_is_complete(&list[i])) return -1;
    const int r = list[i].rows(params);
    if (r <= 0 || r > INT32_MAX - rows) return -1;
    rows += r;
  }
  return rows;
}

static bool plan_sizes(eom_system *sys, const eom_model *model, const void *params) {
  if (!model || !model->dof) return false;
  sys->model = model;
  sys->params = params;
  sys->n = model->dof(params);
  if (sys->n <= 0) return false;
  const eom_function *l = &model->lagrangian, *force = &model->force, *dissipation = &model->dissipation;
  if (!function_is_complete(l) || l->rows(params) != 1) return false;
  if (force->jet && (!function_is_complete(force) || force->rows(params) != sys->n)) return false;
  if (dissipation->jet && (!function_is_complete(dissipation) || dissipation->rows(params) != 1)) return false;
  sys->m1 = count_rows(model->holonomic, model->nholonomic, params);
  sys->m2 = count_rows(model->nonholonomic, model->nnonholonomic, params);
  if (model->nmotion < 0 || (model->nmotion > 0 && !model->motion)) return false;
  if (sys->m1 < 0 || sys->m2 < 0 || sys->m1 > INT32_MAX - sys->m2) return false;
  sys->m = sys->m1 + sys->m2;
  return true;
}

bool eom_sizes_hold(const eom_system *sys) {
  const eom_model *model = sys->model;
  if (sys->motion) return sys->motion->fits(sys->params);
  return model->dof(sys->params) == sys->n && count_rows(model->holonomic, model->nholonomic, sys->params) == sys->m1 &&
         count_rows(model->nonholonomic, model->nnonholonomic, sys->params) == sys->m2;
}

static bool is_gain(tl_real x) { return x >= TL_C(0.0) && x <= TL_MAX; }

static bool plan_options(eom_system *sys, const eom_options *given) {
  sys->options = given ? *given : eom_options_default();
  const eom_options *o = &sys->options;
  if (o->needs & ~(unsigned)EOM_NEED_ALL) return false;
  if (!(o->rank_tolerance >= TL_C(0.0) && o->rank_tolerance < TL_C(1.0))) return false;
  if (!(o->consistency_tolerance >= TL_C(0.0) && o->consistency_tolerance < TL_C(1.0))) return false;
  if (!is_gain(o->baumgarte.alpha) || !is_gain(o->baumgarte.beta)) return false;
  if (eom_is_stabilised(sys) && o->needs & EOM_NEED_PARAMETERS) return false;
  if (o->hold.on &&
      !(o->rank_tolerance <= o->hold.drop && o->hold.drop <= o->hold.take && o->hold.take < TL_C(1.0) && o->hold.ahead >= TL_C(0.0)))
    return false;
  if (!(o->most_jump > TL_C(0.0))) return false;
  if (o->weights)
    for (int i = 0; i < sys->m; i++)
      if (!(o->weights[i] > TL_C(0.0) && o->weights[i] <= TL_MAX)) return false;
  return true;
}

/* Coordinates from which LAPACK is used: on one thread it is twice as fast as the plain code at 26 for Cholesky and QR, and slower
 * below 8. */
#define EOM_LAPACK_FROM 24

static const eom_linalg *choose_linalg(const eom_system *sys) {
  const eom_linalg_choice choice = sys->options.linalg;
#ifdef EOM_HAVE_LAPACKE
  const eom_linalg *lapack = &eom_linalg_lapacke;
#else
  const eom_linalg *lapack = NULL;
#endif
  if (choice == EOM_LINALG_CORE) return &eom_linalg_core;
  if (choice == EOM_LINALG_LAPACK) return lapack;
  if (choice != EOM_LINALG_AUTO) return NULL;
  return lapack && sys->n >= EOM_LAPACK_FROM ? lapack : &eom_linalg_core;
}

static void use_stage(eom_workspace *ws, eom_stage_id id, tl_spec spec, int first_q, int first_qd) {
  eom_stage *s = &ws->stage[id];
  s->used = true;
  s->spec = spec;
  s->first_q = first_q;
  s->first_qd = first_qd;
}

/* Makes room in a stage for a function. */
static void admit(eom_stage *stage, const eom_function *f, const void *params) {
  const size_t frame = f->frame(params), rows = (size_t)f->rows(params);
  if (frame > stage->frame) stage->frame = frame;
  if (rows > stage->rows) stage->rows = rows;
}

static void admit_all(eom_stage *stage, const eom_function *list, int count, const void *params) {
  for (int i = 0; i < count; i++) admit(&stage[0], &list[i], params);
}

/* A stage for a function of which the model has one or none. */
static void plan_function(const eom_system *sys, eom_workspace *ws, const eom_function *f, eom_stage_id id, tl_spec spec, int first_q,
                          int first_qd) {
  if (!f->jet) return;
  use_stage(ws, id, spec, first_q, first_qd);
  admit(&ws->stage[id], f, sys->params);
}

static void plan_lagrangian(const eom_system *sys, eom_workspace *ws, eom_stage_id id, tl_spec spec, int first_q, int first_qd) {
  plan_function(sys, ws, &sys->model->lagrangian, id, spec, first_q, first_qd);
}

static void plan_force(const eom_system *sys, eom_workspace *ws, eom_stage_id id, tl_spec spec, int first_q, int first_qd) {
  plan_function(sys, ws, &sys->model->force, id, spec, first_q, first_qd);
}

static void plan_dissipation(const eom_system *sys, eom_workspace *ws, eom_stage_id id, tl_spec spec, int first_q, int first_qd) {
  plan_function(sys, ws, &sys->model->dissipation, id, spec, first_q, first_qd);
}

/* Their values. */
static void plan_forces(const eom_system *sys, eom_workspace *ws) {
  plan_force(sys, ws, STAGE_GAMMA, tl_univariate(0), -1, -1);
  plan_dissipation(sys, ws, STAGE_DISSIPATION, tl_jacobian(sys->n), -1, 0);
}

static void plan_holonomic(const eom_system *sys, eom_workspace *ws, eom_stage_id id, tl_spec spec) {
  if (sys->m1 == 0) return;
  use_stage(ws, id, spec, 0, -1);
  admit_all(&ws->stage[id], sys->model->holonomic, sys->model->nholonomic, sys->params);
}

static void plan_nonholonomic(const eom_system *sys, eom_workspace *ws, eom_stage_id id, tl_spec spec, int first_q, int first_qd) {
  if (sys->m2 == 0) return;
  use_stage(ws, id, spec, first_q, first_qd);
  admit_all(&ws->stage[id], sys->model->nonholonomic, sys->model->nnonholonomic, sys->params);
}

/* The stages of what calls evaluate, and those that motion functions need beside them: see eom_size_rows, eom_motion_verdict and
 * eom_linearise_minimal. */
static void plan_stages(const eom_system *sys, eom_workspace *ws) {
  const int n = sys->n;
  plan_holonomic(sys, ws, STAGE_HOLONOMIC, tl_motion(2, n));
  if (eom_is_stabilised(sys) || EOM_BY_COORDINATES(sys->options.needs, sys->m2))
    plan_nonholonomic(sys, ws, STAGE_NONHOLONOMIC_Q, tl_jacobian(n), 0, -1);
  if (ws->emitter[EOM_TASK_ENERGY] == EOM_EMITTER_CALLS) {
    plan_lagrangian(sys, ws, STAGE_ENERGY, tl_jacobian(2 * n), 0, n);
    plan_forces(sys, ws);
  }
  if (ws->emitter[EOM_TASK_ASSEMBLE] == EOM_EMITTER_CALLS) {
    plan_lagrangian(sys, ws, STAGE_MASS, tl_hessian(n), -1, 0);
    plan_nonholonomic(sys, ws, STAGE_NONHOLONOMIC, tl_motion(1, n), -1, 0);
  }
  if (ws->emitter[EOM_TASK_ASSEMBLE] == EOM_EMITTER_CALLS || ws->emitter[EOM_TASK_RESIDUAL] == EOM_EMITTER_CALLS) {
    plan_lagrangian(sys, ws, STAGE_FORCE, tl_motion(1, 2 * n), 0, n);
    plan_forces(sys, ws);
  }
  if (sys->motion) {
    plan_lagrangian(sys, ws, STAGE_LOCATE, tl_univariate(2), -1, -1);
    plan_force(sys, ws, STAGE_LOCATE, tl_univariate(2), -1, -1);
    plan_dissipation(sys, ws, STAGE_LOCATE, tl_univariate(2), -1, -1);
    admit_all(&ws->stage[STAGE_LOCATE], sys->model->holonomic, sys->model->nholonomic, sys->params);
    admit_all(&ws->stage[STAGE_LOCATE], sys->model->nonholonomic, sys->model->nnonholonomic, sys->params);
  }
  if (ws->emitter[EOM_TASK_LINEARISE] != EOM_EMITTER_CALLS) return;
  plan_lagrangian(sys, ws, STAGE_LINEARISE, (tl_spec){.curve = 1, .nvar = 2 * n, .order = 2}, 0, n);
  admit_all(&ws->stage[STAGE_LINEARISE], sys->model->nonholonomic, sys->model->nnonholonomic, sys->params);
  plan_force(sys, ws, STAGE_GAMMA_LINEARISE, tl_jacobian(2 * n), 0, n);
  plan_dissipation(sys, ws, STAGE_DISSIPATION_LINEARISE, tl_hessian(2 * n), 0, n);
  plan_holonomic(sys, ws, STAGE_CURVATURE, tl_hessian(n));
}

/* Numbers that the jets and the context of each stage take: all stages share one piece of memory, as large as the largest. */
static bool plan_memory(const eom_system *sys, eom_workspace *ws) {
  for (int id = 0; id < STAGE_COUNT; id++) {
    eom_stage *s = &ws->stage[id];
    if (!s->used) continue;
    const int ncoef = tl_ncoef(s->spec);
    const size_t jets = 2 * (size_t)sys->n + 1 + s->rows;
    if (ncoef <= 0 || jets > SIZE_MAX / sizeof(tl_real) / (size_t)ncoef) return false;
    if (s->frame > SIZE_MAX / sizeof(tl_real) / (size_t)ncoef / 2) return false;
    /* tl_ctx_size reads nothing of a shape but its number of coefficients */
    const tl_shape shape = {.ncoef = ncoef};
    s->context = tl_ctx_size(&shape, s->frame);
    if (jets * (size_t)ncoef > ws->njets) ws->njets = jets * (size_t)ncoef;
    if (s->context > ws->ncontext) ws->ncontext = s->context;
  }
  return true;
}

static eom_status plan(eom_system *sys, eom_workspace *ws, const eom_model *model, const void *params, const eom_options *options) {
  *sys = (eom_system){0};
  *ws = (eom_workspace){0};
  if (model && model->params_size > 0 && !params) return EOM_NO_PARAMS;
  if (!plan_sizes(sys, model, params)) return EOM_BAD_MODEL;
  if (!plan_options(sys, options)) return EOM_BAD_OPTION;
  ws->linalg = choose_linalg(sys);
  if (!ws->linalg || !eom_choose_emitters(sys, ws)) return EOM_BAD_OPTION;
  ws->factor.nwork = eom_linalg_work(sys->n > sys->m ? sys->n : sys->m, sys->m);
  plan_stages(sys, ws);
  return plan_memory(sys, ws) ? EOM_OK : EOM_NO_MEMORY;
}

/* Lays out everything: with a base, also starts the shapes. */
static bool lay_out(eom_system *sys, eom_workspace **ws, eom_arena *arena) {
  _Static_assert(sizeof(eom_workspace) <= EOM_WORKSPACE_BYTES, "EOM_WORKSPACE_BYTES in eom/bytes.h is too small");
  eom_workspace *kept = eom_arena_take(arena, 1, EOM_WORKSPACE_BYTES);
  if (kept) {
    *kept = **ws;
    *ws = kept;
  }
  for (int id = 0; id < STAGE_COUNT; id++) {
    eom_stage *s = &(*ws)->stage[id];
    if (!s->used) continue;
    const size_t bytes = tl_shape_bytes(s->spec);
    void *table = eom_arena_take(arena, bytes, 1);
    s->shape = eom_arena_take(arena, 1, sizeof(tl_shape));
    if (arena->base && tl_shape_init(s->shape, s->spec, table, bytes) != 0) return false;
  }
  take_arrays(sys, *ws, arena);
  if ((*ws)->weights) {
    memcpy((*ws)->weights, sys->options.weights, (size_t)sys->m * sizeof(tl_real));
    sys->options.weights = (*ws)->weights;
  }
  return !arena->overflow;
}

size_t eom_system_bytes(const eom_model *model, const void *params, const eom_options *options) {
  eom_system sys;
  eom_workspace local, *ws = &local;
  eom_arena count = {0};
  if (plan(&sys, ws, model, params, options) != EOM_OK || !lay_out(&sys, &ws, &count)) return 0;
  return EOM_ROUNDED(count.used) + EOM_ALIGNMENT; /* the memory may start anywhere */
}

eom_status eom_system_init(eom_system *sys, const eom_model *model, const void *params, const eom_options *options, void *memory,
                           size_t bytes) {
  eom_workspace local, *ws = &local;
  const eom_status status = plan(sys, ws, model, params, options);
  if (status != EOM_OK) return status;
  const size_t need = eom_system_bytes(model, params, options);
  if (need == 0 || bytes < need || !memory) return EOM_NO_MEMORY;
  eom_arena arena = eom_arena_at(memory);
  memset(memory, 0, bytes);
  if (!lay_out(sys, &ws, &arena)) return EOM_NO_MEMORY;
  sys->workspace = ws;
  sys->report = (eom_report){.status = EOM_OK, .index = -1, .rank = -1};
  ws->held.rank_q = ws->held.rank = sys->held_rank = -1;
  return EOM_OK;
}

eom_row eom_system_row(const eom_system *sys, int i) {
  assert(i >= 0 && i < sys->m);
  const eom_row_kind kind = sys->row_kind[i];
  const bool holonomic = i < sys->m1;
  const eom_function *f = holonomic ? sys->model->holonomic : sys->model->nonholonomic;
  int row = holonomic ? i : i - sys->m1;
  while (row >= f->rows(sys->params)) row -= (f++)->rows(sys->params);
  return (eom_row){.name = f->name, .source = f->source, .row = row, .kind = kind};
}
