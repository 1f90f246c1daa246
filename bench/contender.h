/* What the benchmark asks of a contender: a shared object that exports bench_open. */
#ifndef BENCH_CONTENDER_H
#define BENCH_CONTENDER_H

#ifdef __cplusplus
extern "C" {
#endif

/* A planar chain of point masses on massless rods, hung from a fixed pivot. */
typedef struct bench_case {
  const char *model;    /* "pendulum": absolute angles; "relative_chain": each angle relative to the link before; "cartesian_pendulum":
                           absolute angles to the timer, while contenders work in x and y of each mass with rods as constraints */
  int n;                /* links = coordinates */
  double gravity;       /* m/s^2 */
  const double *mass;   /* n: at the end of each rod, kg */
  const double *length; /* n: of each rod, m; all 1 for relative_chain, and so are its masses */
} bench_case;

/* The three computations that are timed. A null member: the contender does not have it. Each returns 0, or another number where it
 * failed. q, qd: n; w = (dq, dqd): 2n; qdd, dqdd: n; qdd_y = d qdd/d(q,qd): n x 2n, row-major. All arrays begin on 64 bytes. */
typedef struct bench_contender {
  void *self; /* handed back to every function */
  int lanes;  /* states per call: 1, or the width of a batch (at most BENCH_STATES); then every array is [number][lane] */
  int (*acceleration)(void *self, const double *q, const double *qd, double *qdd);                               /* F */
  int (*jacobian)(void *self, const double *q, const double *qd, double *qdd, double *qdd_y);                    /* J */
  int (*directional)(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd); /* V */

  /* Null where coordinates and layout are the model's. Never timed: what a user of the contender would not compute at each state. */
  void (*to_native)(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd,
                    double *native_w);
  /* The results of one call of need 'F', 'J' or 'V' at (q, qd) of the model become those of the model, in place. qdd_y has room for
   * 4n^2 numbers, so that a contender may leave it in parts. */
  void (*from_native)(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd);
  int coordinates; /* of native states and accelerations, at least n; 0: n */
  int approximate; /* 1: it solves another, softened problem: it is timed with whatever error it has, which the tables tell */
} bench_contender;

enum { BENCH_STATES = 8 }; /* that are cycled */

/* Fills *contender for a case, which outlives it; 0, or another number where the contender does not have that case. */
#ifdef __GNUC__
__attribute__((visibility("default")))
#endif
int bench_open(const bench_case *problem, bench_contender *contender);

#ifdef __cplusplus
}
#endif

#endif
