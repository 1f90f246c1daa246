/* The structure-preserving doubling algorithm (Chu, Fan, Lin, Wang 2004): with W = I + G H
 *     A <- A W^-1 A,     G <- G + A W^-1 G A',     H <- H + A' H W^-1 A
 * from G = B B'/weight and H = diag(weights); after k doublings H is the cost-to-go over 2^k steps, which tends to X. */
#include "riccati.h"

#include "matrix.h"

#include <taylor/finite.h>

static void begin(riccati *s, const tl_real *A, const tl_real *B, const tl_real *weights, tl_real weight) {
  const tl_real inverse = TL_C(1.0) / weight;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      s->A[D * i + j] = A[D * i + j];
      s->G[D * i + j] = B[i] * B[j] * inverse;
      s->H[D * i + j] = i == j ? weights[i] : TL_C(0.0);
    }
}

/* V1 = W^-1 A, V2 = W^-1 G. */
static int solve(riccati *s) {
  matrix_multiply(D, s->W, s->G, s->H);
  for (int i = 0; i < D; i++) s->W[D * i + i] += TL_C(1.0);
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      s->V[2 * D * i + j] = s->A[D * i + j];
      s->V[2 * D * i + D + j] = s->G[D * i + j];
    }
  if (!matrix_solve(D, 2 * D, s->W, s->V)) return 0;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      s->V1[D * i + j] = s->V[2 * D * i + j];
      s->V2[D * i + j] = s->V[2 * D * i + D + j];
    }
  return 1;
}

static int doubling(riccati *s) {
  if (!solve(s)) return 0;
  matrix_multiply(D, s->P, s->A, s->V2);
  matrix_add_symmetric(D, s->G, s->P, s->A);
  matrix_multiply(D, s->P, s->H, s->V1);
  matrix_transpose(D, s->At, s->A);
  matrix_transpose(D, s->W, s->P);
  matrix_add_symmetric(D, s->H, s->At, s->W);
  matrix_multiply(D, s->P, s->A, s->V1);
  for (int i = 0; i < D * D; i++) s->A[i] = s->P[i];
  return 1;
}

int riccati_gain_of(tl_real *K, const tl_real *X, const tl_real *A, const tl_real *B, tl_real weight) {
  tl_real XB[D], gain[D], below = weight;
  for (int i = 0; i < D; i++) {
    XB[i] = matrix_dot(D, X + D * i, B, 1);
    below += B[i] * XB[i];
  }
  for (int j = 0; j < D; j++) gain[j] = matrix_dot(D, XB, A + j, D) / below;
  if (!tl_finite_array(D, gain)) return 0;
  for (int j = 0; j < D; j++) K[j] = gain[j];
  return 1;
}

int riccati_gain(tl_real *K, const tl_real *A, const tl_real *B, const tl_real *weights, tl_real weight, riccati *s) {
  begin(s, A, B, weights, weight);
  for (int k = 0; k < RICCATI_DOUBLINGS; k++)
    if (!doubling(s)) return 0;
  return riccati_gain_of(K, s->H, A, B, weight);
}
