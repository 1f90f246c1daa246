/* heyoka as a contender: calls the machine code that it printed for one chain.
 *   N: links; LANES: states per call; HAS_F, HAS_J, HAS_V: the needs that are linked; TAPE: heyoka's compact mode, numbers of scratch
 * per lane. Only the copies into heyoka's one array of inputs, and of accelerations out of its one array of outputs, come on top. */
#include "contender.h"

#include <stdlib.h>
#include <string.h>

typedef struct chain {
  _Alignas(64) double in[4 * N * LANES];  /* q, qd, w */
  _Alignas(64) double out[2 * N * LANES]; /* F, V: qdd, dqdd */
#ifdef TAPE
  _Alignas(64) double tape[TAPE * LANES];
#endif
} chain;

/* What heyoka asks for after (out, in, parameters, time): the tape in compact mode, the distance of variables where there are lanes. */
#ifdef TAPE
#define TAPE_TYPE , void *
#define TAPE_HERE , c->tape
#else
#define TAPE_TYPE
#define TAPE_HERE
#endif
#if LANES > 1
#define STRIDE_TYPE , size_t
#define STRIDE_HERE , LANES
#else
#define STRIDE_TYPE
#define STRIDE_HERE
#endif
typedef void function(double *, const double *, const double *, const double *TAPE_TYPE STRIDE_TYPE);
function heyoka_F, heyoka_J, heyoka_V;
#define CALL(need, out) heyoka_##need(out, c->in, NULL, NULL TAPE_HERE STRIDE_HERE)

static void put(chain *c, const double *q, const double *qd) {
  memcpy(c->in, q, N * LANES * sizeof(double));
  memcpy(c->in + N * LANES, qd, N * LANES * sizeof(double));
}

#ifdef HAS_F
static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain *c = self;
  put(c, q, qd);
  CALL(F, qdd);
  return 0;
}
#endif

#ifdef HAS_J
/* qdd_y begins with qdd: see from_native. */
static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  chain *c = self;
  (void)qdd;
  put(c, q, qd);
  CALL(J, qdd_y);
  return 0;
}
#endif

#ifdef HAS_V
static int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  chain *c = self;
  put(c, q, qd);
  memcpy(c->in + 2 * N * LANES, w, 2 * N * LANES * sizeof(double));
  CALL(V, c->out);
  memcpy(qdd, c->out, N * LANES * sizeof(double));
  memcpy(dqdd, c->out + N * LANES, N * LANES * sizeof(double));
  return 0;
}
#endif

static void from_native(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd) {
  (void)self, (void)q, (void)qd, (void)dqdd;
  if (need != 'J') return;
  memcpy(qdd, qdd_y, N * LANES * sizeof(double));
  memmove(qdd_y, qdd_y + N * LANES, 2 * N * N * LANES * sizeof(double));
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  if (problem->n != N) return 1;
  memset(contender, 0, sizeof *contender);
  contender->self = aligned_alloc(64, sizeof(chain));
  if (contender->self == NULL) return 1;
  contender->lanes = LANES;
#ifdef HAS_F
  contender->acceleration = acceleration;
#endif
#ifdef HAS_J
  contender->jacobian = jacobian;
#endif
#ifdef HAS_V
  contender->directional = directional;
#endif
  contender->from_native = from_native;
  return 0;
}
