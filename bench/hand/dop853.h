/* A step of DOP853 (Hairer, Norsett, Wanner) written out by hand: sizes, coefficients and zeros known to the compiler.
 *
 * Include with MOST defined, the most unknowns of a problem. A step's length is chosen by the first `judged` of `dim` unknowns. */
#ifndef BENCH_HAND_DOP853_H
#define BENCH_HAND_DOP853_H

#include "contender.h"

#include <math.h>
#include <string.h>

#include "../../runtime/src/method_dop853.c" /* its numbers, as constants */

#define DOP853_INLINE static inline __attribute__((always_inline))
#define DOP853_UNROLL _Pragma("GCC unroll 16")

enum { DOP853_STAGES = 12 };

typedef int dop853_rhs(void *user, double t, const double *y, double *ydot);

typedef struct dop853 {
  _Alignas(64) double k[DOP853_STAGES + 1][MOST], y[MOST], y1[MOST];
  double error, log_error;
  double h, most; /* the next step to try, s, and by how much it may grow */
  long steps, rejected;
} dop853;

#define DOP853_WEIGHTED(w, count)                                                                                                      \
  double sum = 0.0;                                                                                                                    \
  DOP853_UNROLL for (int j = 0; j < (count); j++) if ((w)[j] != 0.0) sum += (w)[j] * z->k[j][c]

DOP853_INLINE void dop853_point(dop853 *z, int dim, double h, int i) {
  for (int c = 0; c < dim; c++) {
    DOP853_WEIGHTED(dop853_a + i * (i - 1) / 2, i);
    z->y1[c] = z->y[c] + h * sum;
  }
}

DOP853_INLINE double dop853_squares(const dop853 *z, int judged, double tol, const double *e) {
  double total = 0.0;
  for (int c = 0; c < judged; c++) {
    DOP853_WEIGHTED(e, DOP853_STAGES);
    const double scaled = sum / (tol + tol * fmax(fabs(z->y[c]), fabs(z->y1[c])));
    total += scaled * scaled;
  }
  return total;
}

/* y1 from y; tol 0: without its error. */
DOP853_INLINE void dop853_step(dop853 *z, dop853_rhs *rhs, void *user, int dim, int judged, double t, double h, double tol) {
  DOP853_UNROLL for (int i = 1; i < DOP853_STAGES; i++) {
    dop853_point(z, dim, h, i);
    rhs(user, t + dop853_c[i] * h, z->y1, z->k[i]);
  }
  dop853_point(z, dim, h, DOP853_STAGES);
  if (tol == 0.0) return;
  const double high = dop853_squares(z, judged, tol, dop853_error);
  const double low = dop853_squares(z, judged, tol, dop853_error + DOP853_STAGES + 1);
  z->error = high > 0.0 ? fabs(h) * high / sqrt((high + 0.01 * low) * judged) : 0.0;
}

DOP853_INLINE void dop853_take(dop853 *z, dop853_rhs *rhs, void *user, int dim, double t1) {
  rhs(user, t1, z->y1, z->k[0]);
  memcpy(z->y, z->y1, (size_t)dim * sizeof *z->y);
  z->steps++;
}

/* Starts at (t, y) with the first step h. */
DOP853_INLINE void dop853_start(dop853 *z, dop853_rhs *rhs, void *user, int dim, double t, const double *y, double h) {
  memset(z, 0, sizeof *z);
  memcpy(z->y, y, (size_t)dim * sizeof *z->y);
  z->h = h;
  z->most = 6.0;
  rhs(user, t, z->y, z->k[0]);
}

/* From t by one step that keeps to tol, absolute and relative, and ends at t_end at the latest: where it ends. */
DOP853_INLINE double dop853_good_step(dop853 *z, dop853_rhs *rhs, void *user, int dim, int judged, double t, double t_end, double tol) {
  for (;;) {
    const double t1 = t + 1.01 * z->h >= t_end ? t_end : t + z->h, h = t1 - t;
    dop853_step(z, rhs, user, dim, judged, t, h, tol);
    if (z->error <= 1.0) {
      const double log_error = log2(fmax(z->error, 1e-300));
      dop853_take(z, rhs, user, dim, t1);
      z->h = h * fmin(fmax(0.9 * exp2((0.2 * z->log_error - 0.85 * log_error) / 8.0), 0.2), z->most);
      z->log_error = log2(fmax(z->error, 1e-4));
      z->most = 6.0;
      return t1;
    }
    z->rejected++;
    z->h = h * fmax(0.2, 0.9 * pow(z->error, -0.125));
    z->most = 1.0;
  }
}

#endif
