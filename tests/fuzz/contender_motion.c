/* The generated motion functions, called as they are: what no function gives stays absent. */
#include "contender.h"

#include "eom/motion.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct call {
  const eom_motion *motion;
  const void *params;
  const fuzz_point *p;
  const double *q, *qd, *lambda;
  double t, *work;
  fuzz_numbers *v;
  char *text;
  size_t size;
} call;

/* Writes a message where the code of a function says that it failed. */
static void judge(const call *c, const char *function, int code) {
  if (code == 0 || *c->text) return;
  if (code > 0 && code <= c->motion->nsite)
    snprintf(c->text, c->size, "%s: no value at %s:%d", function, c->motion->sites[code - 1].file, c->motion->sites[code - 1].line);
  else
    snprintf(c->text, c->size, "%s: returns %d", function, code);
}

static void energy(const call *c) {
  double **g = c->v->group;
  if (c->motion->energy)
    judge(c, "energy",
          c->motion->energy(c->params, c->q, c->qd, c->t, g[FUZZ_MOMENTUM], g[FUZZ_RATE], g[FUZZ_LAGRANGIAN], g[FUZZ_ENERGY], c->work));
  else
    fuzz_make_absent(c->v, FUZZ_LAGRANGIAN, FUZZ_MASS);
}

static void simulate(const call *c) {
  double **g = c->v->group;
  const eom_parts parts = {g[FUZZ_MASS], g[FUZZ_FORCE], g[FUZZ_PHI], g[FUZZ_PHI_DOT], g[FUZZ_PSI], g[FUZZ_CONSTRAINT], g[FUZZ_B]};
  if (c->motion->simulate)
    judge(c, "simulate", c->motion->simulate(c->params, c->q, c->qd, c->t, &parts, c->work));
  else
    fuzz_make_absent(c->v, FUZZ_MASS, FUZZ_RESIDUAL);
}

static void residual(const call *c) {
  if (c->motion->residual)
    judge(c, "residual", c->motion->residual(c->params, c->q, c->qd, c->t, c->p->trial, c->v->group[FUZZ_RESIDUAL], c->work));
  else
    fuzz_make_absent(c->v, FUZZ_RESIDUAL, FUZZ_R_Y);
}

static void linearise(const call *c) {
  double **g = c->v->group;
  if (c->motion->linearise)
    judge(c, "linearise", c->motion->linearise(c->params, c->q, c->qd, c->t, c->p->qdd, c->lambda, g[FUZZ_R_Y], g[FUZZ_G_Y], c->work));
  else
    fuzz_make_absent(c->v, FUZZ_R_Y, FUZZ_R_W);
}

static void tangent(const call *c) {
  double **g = c->v->group;
  if (c->motion->tangent)
    judge(c, "tangent",
          c->motion->tangent(c->params, c->q, c->qd, c->t, c->p->qdd, c->lambda, c->v->sizes.k, c->p->w, g[FUZZ_R_W], g[FUZZ_G_W],
                             c->work));
  else
    fuzz_make_absent(c->v, FUZZ_R_W, FUZZ_R_P);
}

static void parameters(const call *c) {
  double **g = c->v->group;
  if (c->motion->parameters && c->v->sizes.np)
    judge(c, "parameters",
          c->motion->parameters(c->params, c->q, c->qd, c->t, c->p->qdd, c->lambda, g[FUZZ_R_P], g[FUZZ_G_P], c->work));
  else
    fuzz_make_absent(c->v, FUZZ_R_P, FUZZ_QDD);
}

/* ---- solved forms, of several states at once where there are such functions ---- */

/* A row of numbers in lanes: lane 0 the given ones, the others scaled by spread, or none given. */
static tl_real *in_lanes(const call *c, int count, const double *numbers, double spread) {
  const size_t bytes = (size_t)(count * c->motion->lanes + EOM_MOTION_ALIGNMENT) * sizeof(tl_real);
  tl_real *a = aligned_alloc(EOM_MOTION_ALIGNMENT, bytes / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT);
  for (int i = 0; i < count; i++)
    for (int l = 0; l < c->motion->lanes; l++) a[i * c->motion->lanes + l] = numbers ? numbers[i] * (1 - spread * l) : (tl_real)NAN;
  return a;
}

static void first_lane(const call *c, int count, double *to, const tl_real *from) {
  for (int i = 0; i < count; i++) to[i] = from[i * c->motion->lanes];
}

#define IN(a) ((const tl_lanes *)(const void *)(a))
#define OUT(a) ((tl_lanes *)(void *)(a))

/* The three by lanes, beside states at which other branches may hold; alone where one of those has no accelerations. */
static void solved_in_lanes(const call *c, double spread) {
  const eom_motion *m = c->motion;
  const int n = c->v->sizes.n, k = c->v->sizes.k;
  double **g = c->v->group;
  tl_real *q = in_lanes(c, n, c->q, spread), *qd = in_lanes(c, n, c->qd, spread), *t = in_lanes(c, 1, &c->t, 0.0);
  tl_real *w = in_lanes(c, 2 * n * k, c->p->w, 0.0), *qdd = in_lanes(c, n, NULL, 0.0), *qdd_y = in_lanes(c, 2 * n * n, NULL, 0.0);
  tl_real *dqdd = in_lanes(c, n * k, NULL, 0.0), *work = in_lanes(c, (int)m->work, NULL, 0.0);
  const int code = m->acceleration_lanes(c->params, IN(q), IN(qd), IN(t), OUT(qdd), OUT(work));
  if (code == 0 || spread == 0.0) {
    judge(c, "acceleration_lanes", code);
    first_lane(c, n, g[FUZZ_QDD], qdd);
    if (g[FUZZ_QDD_Y] && m->jacobian_lanes) {
      judge(c, "jacobian_lanes", m->jacobian_lanes(c->params, IN(q), IN(qd), IN(t), OUT(qdd), OUT(qdd_y), OUT(work)));
      first_lane(c, n, g[FUZZ_QDD_J], qdd), first_lane(c, 2 * n * n, g[FUZZ_QDD_Y], qdd_y);
    }
    if (g[FUZZ_QDD_W] && m->directional_lanes) {
      judge(c, "directional_lanes", m->directional_lanes(c->params, IN(q), IN(qd), IN(t), k, IN(w), OUT(qdd), OUT(dqdd), OUT(work)));
      first_lane(c, n, g[FUZZ_QDD_V], qdd), first_lane(c, n * k, g[FUZZ_QDD_W], dqdd);
    }
  }
  free(q), free(qd), free(t), free(w), free(qdd), free(qdd_y), free(dqdd), free(work);
  if (code != 0 && spread != 0.0) solved_in_lanes(c, 0.0);
}

static void solved_alone(const call *c) {
  const eom_motion *m = c->motion;
  double **g = c->v->group;
  judge(c, "acceleration", m->acceleration(c->params, c->q, c->qd, c->t, g[FUZZ_QDD], c->work));
  if (g[FUZZ_QDD_Y]) judge(c, "jacobian", m->jacobian(c->params, c->q, c->qd, c->t, g[FUZZ_QDD_J], g[FUZZ_QDD_Y], c->work));
  if (g[FUZZ_QDD_W])
    judge(c, "directional",
          m->directional(c->params, c->q, c->qd, c->t, c->v->sizes.k, c->p->w, g[FUZZ_QDD_V], g[FUZZ_QDD_W], c->work));
}

/* Where the reference has solved. */
static void solved(const call *c) {
  const eom_motion *m = c->motion;
  double **g = c->v->group;
  const int lanes = m->acceleration_lanes != NULL;
  fuzz_make_absent(c->v, FUZZ_LAMBDA, FUZZ_QDD_Y);
  fuzz_make_absent(c->v, FUZZ_LAMBDA_Y, FUZZ_QDD_W);
  fuzz_make_absent(c->v, FUZZ_LAMBDA_W, FUZZ_GROUP_COUNT);
  if (!m->acceleration) g[FUZZ_QDD] = NULL;
  if (!g[FUZZ_QDD] || (lanes ? !m->jacobian_lanes : !m->jacobian)) g[FUZZ_QDD_J] = g[FUZZ_QDD_Y] = NULL;
  if (!g[FUZZ_QDD] || (lanes ? !m->directional_lanes : !m->directional)) g[FUZZ_QDD_V] = g[FUZZ_QDD_W] = NULL;
  if (g[FUZZ_QDD] && lanes) solved_in_lanes(c, 0.3);
  if (g[FUZZ_QDD] && !lanes) solved_alone(c);
}

const eom_motion *contender_find_motion(const eom_model *model, const void *params) {
  for (int i = 0; i < model->nmotion; i++)
    if (model->motion[i]->fits(params)) return model->motion[i];
  return NULL;
}

void contender_motion(const eom_model *model, const void *params, const fuzz_point *p, fuzz_numbers *v, char *text, size_t size) {
  const int n = v->sizes.n;
  const eom_motion *motion = contender_find_motion(model, params);
  if (!motion) {
    fuzz_make_absent(v, 0, FUZZ_GROUP_COUNT);
    return;
  }
  const size_t bytes = (motion->work * sizeof(double) + EOM_MOTION_ALIGNMENT) / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT;
  call c = {motion, params, p, p->x, p->x + n, v->sizes.m ? p->lambda : NULL, p->x[2 * n], NULL, v, text, size};
  if (motion->work) c.work = aligned_alloc(EOM_MOTION_ALIGNMENT, bytes);
  if (c.work) memset(c.work, 0xff, bytes); /* NaN */
  energy(&c);
  simulate(&c);
  residual(&c);
  linearise(&c);
  tangent(&c);
  parameters(&c);
  solved(&c);
  free(c.work);
}
