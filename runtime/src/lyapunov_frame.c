/* Orthonormal directions among the motions that constraints allow, by Householder's QR.
 *
 * C = d(phi, phi_dot, psi)/dy = [A_1 0; G A] has the rows that tangents of the motion are orthogonal to, A_1 the holonomic rows of A, G
 * = d(phi_dot, psi)/dq. With C' P = Q_C [R_C; 0] and Q_C' X = [X_1; X_2] the part X_1 is off the constraints by rounding and by what is
 * left over by steps; X_2 = Q_2 R gives Q = Q_C [0; Q_2]. Without constraints Q_C = 1. */
#include "lyapunov.h"

#include "evaluate.h"
#include "stage.h"

#include <string.h>

/* ---- the rows ---- */

static tl_real length(int count, const tl_real *x) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < count; i++) sum += x[i] * x[i];
  return TL_LIBM(sqrt)(sum);
}

/* C from the assembled A and G, row by row. */
static void fill_rows(eom_lyapunov *ly) {
  const eom_system *sys = ly->sys;
  eom_lyapunov_work *w = ly->work;
  const int n = sys->n, m1 = sys->m1;
  const size_t bytes = (size_t)n * sizeof(tl_real);
  memset(w->C, 0, 2 * (size_t)w->rows * bytes);
  for (int r = 0; r < m1; r++) memcpy(w->C + 2 * n * r, sys->A + n * r, bytes);
  for (int r = 0; r < sys->m; r++) {
    memcpy(w->C + 2 * n * (m1 + r), w->rates + n * r, bytes);
    memcpy(w->C + 2 * n * (m1 + r) + n, sys->A + n * r, bytes);
  }
}

/* Rows of unit length, whose pivots say how much each adds to those before it. Returns the sum of the logarithms of their lengths. */
static tl_real scale_rows(eom_lyapunov_work *w, int d) {
  tl_real sum = TL_C(0.0);
  for (int r = 0; r < w->rows; r++) {
    tl_real *row = w->C + d * r;
    const tl_real size = length(d, row);
    if (size == TL_C(0.0)) continue;
    for (int i = 0; i < d; i++) row[i] /= size;
    sum += TL_LIBM(log)(size);
  }
  return sum;
}

eom_status eom_lyapunov_factor_rows(eom_lyapunov *ly, tl_real t, const tl_real *y) {
  eom_system *sys = ly->sys;
  eom_lyapunov_work *w = ly->work;
  const int n = sys->n, d = 2 * n, most = d < w->rows ? d : w->rows;
  if (w->rows == 0) return EOM_OK;
  eom_lyapunov_forget(ly);
  if (eom_start(sys, y, y + n, t) != EOM_OK || eom_assemble_parts(sys, y, y + n, t) != EOM_OK ||
      eom_constraint_rates(sys, w->rates, y, y + n, t) != EOM_OK)
    return sys->report.status;
  fill_rows(ly);
  w->log_volume = scale_rows(w, d);
  eom_linalg_core.qr(d, w->rows, w->C, w->pivot, w->tau_C, NULL, 0);
  for (w->rank = 0; w->rank < most; w->rank++) {
    const tl_real pivot = TL_LIBM(fabs)(w->C[w->rank * (d + 1)]);
    if (!(pivot > sys->options.rank_tolerance)) break;
    w->log_volume += TL_LIBM(log)(pivot);
  }
  return EOM_OK;
}

/* ---- directions ---- */

/* Column j of Q from Q_2's, which begins at row rank of w->column. */
static void put_column(eom_lyapunov *ly, tl_real *Q, int j) {
  const eom_lyapunov_work *w = ly->work;
  const int d = 2 * ly->sys->n;
  if (w->rank > 0) eom_linalg_core.apply_q(d, w->rank, w->C, w->tau_C, w->column, NULL, 0);
  for (int i = 0; i < d; i++) Q[i * ly->k + j] = w->column[i];
}

/* Column j of the reflection 1 - 2 v v'/(v'v), v_i = 1 + the fractional part of i times the golden ratio: no motion that keeps to some
 * of the coordinates holds one of these columns. */
static void reflect(int free, int j, tl_real *column) {
  tl_real square = TL_C(0.0);
  for (int i = 0; i < free; i++) {
    const tl_real turns = (tl_real)i * TL_C(0.6180339887498949);
    column[i] = TL_C(1.0) + turns - TL_LIBM(floor)(turns);
    square += column[i] * column[i];
  }
  const tl_real scale = TL_C(2.0) * column[j] / square;
  for (int i = 0; i < free; i++) column[i] *= -scale;
  column[j] += TL_C(1.0);
}

void eom_lyapunov_span(eom_lyapunov *ly, tl_real *Q) {
  const eom_lyapunov_work *w = ly->work;
  const int d = 2 * ly->sys->n, free = d - w->rank;
  for (int j = 0; j < ly->k; j++) {
    memset(w->column, 0, (size_t)d * sizeof(tl_real));
    if (ly->k < free)
      reflect(free, j, w->column + w->rank);
    else
      w->column[w->rank + j] = TL_C(1.0);
    put_column(ly, Q, j);
  }
}

/* The rows of Q_C' X behind the first rank, as k vectors. */
static void take_columns(eom_lyapunov *ly, const tl_real *X) {
  const eom_lyapunov_work *w = ly->work;
  const int d = 2 * ly->sys->n, free = d - w->rank;
  for (int j = 0; j < ly->k; j++) {
    for (int i = 0; i < d; i++) w->column[i] = X[i * ly->k + j];
    if (w->rank > 0) eom_linalg_core.apply_qt(d, w->rank, w->C, w->tau_C, w->column, NULL, 0);
    memcpy(w->vectors + j * free, w->column + w->rank, (size_t)free * sizeof(tl_real));
  }
}

eom_status eom_lyapunov_orthonormalise(eom_lyapunov *ly, tl_real *X) {
  eom_lyapunov_work *w = ly->work;
  const int d = 2 * ly->sys->n, free = d - w->rank;
  take_columns(ly, X);
  eom_linalg_core.qr(free, ly->k, w->vectors, NULL, w->tau, NULL, 0);
  w->loss = TL_C(0.0);
  for (int j = 0; j < ly->k; j++) {
    const tl_real R_jj = w->vectors[j * (free + 1)], size = TL_LIBM(fabs)(R_jj);
    if (R_jj == TL_C(0.0) || !TL_ISFINITE(R_jj)) return EOM_NOT_FINITE;
    w->log_R[j] = TL_LIBM(log)(size);
    w->loss = TL_LIBM(fmax)(w->loss, TL_LIBM(log)(length(j + 1, w->vectors + j * free) / size));
    memset(w->column, 0, (size_t)d * sizeof(tl_real));
    w->column[w->rank + j] = R_jj > TL_C(0.0) ? TL_C(1.0) : TL_C(-1.0);
    eom_linalg_core.apply_q(free, j + 1, w->vectors, w->tau, w->column + w->rank, NULL, 0);
    put_column(ly, X, j);
  }
  return EOM_OK;
}
