/* What a run of Lyapunov exponents integrates: the motion, its tangents by three schemes (eqs 72-80), and the divergence. */
#include "lyapunov.h"
#include "step.h"

#include "eom/linearise.h"
#include "eom/tangent.h"

#include <string.h>

/* ---- F X ---- */

enum { MOST_ROWS = 4, MOST_VECTORS = 3 }; /* whose sums are formed together */

/* C = A B for a tile of rows x (vectors of columns); a: rows of length depth, b and c: rows of length k. rows, vectors: constant. */
TL_INLINE void tile(int rows, int vectors, int depth, int k, tl_real *c, const tl_real *a, const tl_real *b) {
  eom_lane sum[MOST_ROWS][MOST_VECTORS];
  TL_UNROLL
  for (int i = 0; i < rows; i++) TL_UNROLL
  for (int v = 0; v < vectors; v++) sum[i][v] = a[i * depth] * EOM_AT_CONST(b + v * EOM_LANE);
  for (int l = 1; l < depth; l++) {
    b += k;
    TL_UNROLL
    for (int i = 0; i < rows; i++) TL_UNROLL
    for (int v = 0; v < vectors; v++) sum[i][v] += a[i * depth + l] * EOM_AT_CONST(b + v * EOM_LANE);
  }
  TL_UNROLL
  for (int i = 0; i < rows; i++) TL_UNROLL
  for (int v = 0; v < vectors; v++) EOM_AT(c + i * k + v * EOM_LANE) = sum[i][v];
}

/* That many rows of the product; the columns that fill no vector one by one. */
TL_INLINE void rows_of_product(int rows, int depth, int k, tl_real *c, const tl_real *a, const tl_real *b) {
  int j = 0;
  for (int left = k / EOM_LANE; left > 0;) {
    const int vectors = left == 1 ? 1 : left == 2 || left == 4 ? 2 : 3;
    if (vectors == 3) tile(rows, 3, depth, k, c + j, a, b + j);
    if (vectors == 2) tile(rows, 2, depth, k, c + j, a, b + j);
    if (vectors == 1) tile(rows, 1, depth, k, c + j, a, b + j);
    j += vectors * EOM_LANE;
    left -= vectors;
  }
  for (; j < k; j++)
    for (int i = 0; i < rows; i++) {
      tl_real sum = TL_C(0.0);
      for (int l = 0; l < depth; l++) sum += a[i * depth + l] * b[l * k + j];
      c[i * k + j] = sum;
    }
}

/* C = A B for a (rows x depth), b (depth x k). Rows go in groups of equal size, so that none is left alone. */
static void multiply(int rows, int depth, int k, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < rows;) {
    const int left = rows - i, groups = (left + MOST_ROWS - 1) / MOST_ROWS, group = (left + groups - 1) / groups;
    if (group == 4) rows_of_product(4, depth, k, c + i * k, a + i * depth, b);
    if (group == 3) rows_of_product(3, depth, k, c + i * k, a + i * depth, b);
    if (group == 2) rows_of_product(2, depth, k, c + i * k, a + i * depth, b);
    if (group == 1) rows_of_product(1, depth, k, c + i * k, a + i * depth, b);
    i += group;
  }
}

void eom_lyapunov_forget(eom_lyapunov *ly) { ly->work->seen_valid = false; }

/* Linearises at (t, y) unless that was the last point: after a change of X alone the motion's part need not be computed again. */
static eom_status linearise_once(eom_lyapunov *ly, tl_real t, const tl_real *y) {
  eom_lyapunov_work *w = ly->work;
  const int n = ly->sys->n;
  const size_t bytes = 2 * (size_t)n * sizeof(tl_real);
  if (w->seen_valid && t == w->seen_t && memcmp(w->seen, y, bytes) == 0) return EOM_OK;
  w->seen_valid = false;
  const eom_status status = eom_linearise(ly->sys, y, y + n, t);
  if (status != EOM_OK) return status;
  memcpy(w->seen, y, bytes);
  w->seen_t = t;
  w->seen_valid = true;
  return EOM_OK;
}

/* trace F = sum_i d qdd_i/d qd_i. */
static tl_real trace_F(const eom_system *sys) {
  const int n = sys->n;
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < n; i++) sum += sys->qdd_y[i * 2 * n + n + i];
  return sum;
}

/* y' = f (where it is asked for) and FX = F X with F = [0 I; qdd_y], whose upper half is the lower half of X; *divergence: trace F, 0
 * where it is not known. */
static eom_status flow(eom_lyapunov *ly, tl_real t, const tl_real *y, const tl_real *X, tl_real *ydot, tl_real *FX,
                       tl_real *divergence) {
  eom_system *sys = ly->sys;
  const int n = sys->n, k = ly->k;
  const bool forms_F = ly->options.product == EOM_LYAPUNOV_BY_JACOBIAN;
  const eom_status status = forms_F ? linearise_once(ly, t, y) : eom_tangent(sys, FX + n * k, ly->work->dlambda, k, X, y, y + n, t);
  if (status != EOM_OK) return status;
  if (forms_F) multiply(n, 2 * n, k, FX + n * k, sys->qdd_y, X);
  *divergence = forms_F ? trace_F(sys) : TL_C(0.0);
  memcpy(FX, X + n * k, (size_t)n * (size_t)k * sizeof(tl_real));
  if (!ydot) return EOM_OK;
  memcpy(ydot, y + n, (size_t)n * sizeof(tl_real));
  memcpy(ydot + n, sys->qdd, (size_t)n * sizeof(tl_real));
  return EOM_OK;
}

/* ---- schemes ---- */

/* K = Q'G. */
static void project(int rows, int k, tl_real *restrict K, const tl_real *restrict Q, const tl_real *restrict G) {
  memset(K, 0, (size_t)k * (size_t)k * sizeof(tl_real));
  for (int l = 0; l < rows; l++)
    for (int i = 0; i < k; i++) {
      const tl_real q = Q[l * k + i];
      for (int j = 0; j < k; j++) K[i * k + j] += q * G[l * k + j];
    }
}

/* K becomes T: T_ii = K_ii, T_ij = K_ij + K_ji above the diagonal, 0 below it. */
static void make_triangular(int k, tl_real *K) {
  for (int i = 0; i < k; i++)
    for (int j = 0; j < i; j++) {
      K[j * k + i] += K[i * k + j];
      K[i * k + j] = TL_C(0.0);
    }
}

/* K becomes S: S_ij = K_ij below the diagonal, -K_ji above it, 0 on it. */
static void make_skew(int k, tl_real *K) {
  for (int i = 0; i < k; i++) {
    K[i * k + i] = TL_C(0.0);
    for (int j = i + 1; j < k; j++) K[i * k + j] = -K[j * k + i];
  }
}

/* rho_i' = K_ii with K = Q'FQ, and Q times what becomes of K in the place of Q'. FX is left in the workspace. */
static eom_status follow(eom_lyapunov *ly, tl_real t, const tl_real *y, const tl_real *Q, tl_real *ydot, tl_real *Qdot,
                         void (*become)(int k, tl_real *K)) {
  eom_lyapunov_work *w = ly->work;
  const int d = 2 * ly->sys->n, k = ly->k, rho = eom_lyapunov_rho_at(ly);
  const eom_status status = flow(ly, t, y, Q, ydot, w->FX, Qdot + rho + k);
  if (status != EOM_OK) return status;
  project(d, k, w->K, Q, w->FX);
  for (int i = 0; i < k; i++) Qdot[rho + i] = w->K[i * k + i];
  become(k, w->K);
  multiply(d, k, k, Qdot, Q, w->K);
  return EOM_OK;
}

/* Q' = FQ - Q T. For square Q, which is orthogonal, FQ = Q K and this is Q S of the scheme as printed. */
static eom_status continuous(eom_lyapunov *ly, tl_real t, const tl_real *y, const tl_real *Q, tl_real *ydot, tl_real *Qdot) {
  const eom_status status = follow(ly, t, y, Q, ydot, Qdot, make_triangular);
  for (int i = 0; status == EOM_OK && i < eom_lyapunov_rho_at(ly); i++) Qdot[i] = ly->work->FX[i] - Qdot[i];
  return status;
}

eom_status eom_lyapunov_rates(eom_lyapunov *ly, tl_real t, const tl_real *y, const tl_real *X, tl_real *ydot, tl_real *Xdot) {
  switch (ly->options.scheme) {
  case EOM_LYAPUNOV_DISCRETE:
    return flow(ly, t, y, X, ydot, Xdot, Xdot + eom_lyapunov_rho_at(ly));
  case EOM_LYAPUNOV_CONTINUOUS:
    return continuous(ly, t, y, X, ydot, Xdot);
  case EOM_LYAPUNOV_PAPER: /* Q' = Q S (eqs 75-80) */
    break;
  }
  return follow(ly, t, y, X, ydot, Xdot, make_skew);
}
