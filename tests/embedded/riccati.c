/* The gain by doublings against the Riccati recursion itself, step by step in long double, for the upright machine at 1 kHz. */
#include "riccati.h"

#include <math.h>
#include <stdio.h>

typedef long double wide;

/* K = B'X A/(weight + B'X B), X <- diag(weights) + weight K'K + C'X C with C = A - B K: Joseph's form, in which errors fade. */
static void step(wide *K, wide *X, const tl_real *A, const tl_real *B, const tl_real *weights, tl_real weight) {
  wide XB[D], XC[D * D], C[D * D], below = weight;
  for (int i = 0; i < D; i++) {
    XB[i] = 0;
    for (int k = 0; k < D; k++) XB[i] += X[D * i + k] * B[k];
    below += B[i] * XB[i];
  }
  for (int j = 0; j < D; j++) {
    K[j] = 0;
    for (int i = 0; i < D; i++) K[j] += XB[i] * A[D * i + j] / below;
    for (int i = 0; i < D; i++) C[D * i + j] = A[D * i + j] - B[i] * K[j];
  }
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      XC[D * i + j] = 0;
      for (int k = 0; k < D; k++) XC[D * i + j] += X[D * i + k] * C[D * k + j];
    }
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) {
      X[D * i + j] = (i == j ? weights[i] : 0) + weight * K[i] * K[j];
      for (int k = 0; k < D; k++) X[D * i + j] += C[D * k + i] * XC[D * k + j];
    }
}

int main(void) {
  const tl_real h = TL_C(1e-3), weight = TL_C(1e-4), up[D] = {0};
  const plant_params params = plant_default();
  static plant_model model;
  static riccati work;
  tl_real A[D * D], B[D] = {0}, weights[D], K[D];
  wide X[D * D], reference[D], largest = 0, away = 0;
  if (plant_linearise(&model, &params, up) != 0) return 1;
  for (int i = 0; i < D; i++) {
    for (int j = 0; j < D; j++) A[D * i + j] = (i == j) + h * (i >= N ? model.qdd_y[D * (i - N) + j] : j == N + i);
    if (i >= N) B[i] = h * model.qdd_push[i - N];
    weights[i] = h * (tl_real)(i + 1);
    for (int j = 0; j < D; j++) X[D * i + j] = i == j ? (wide)weights[i] : 0;
  }
  if (!riccati_gain(K, A, B, weights, weight, &work)) return 1;
  for (int k = 0; k < 1 << RICCATI_DOUBLINGS; k++) step(reference, X, A, B, weights, weight);
  for (int j = 0; j < D; j++) {
    largest = fmaxl(largest, fabsl(reference[j]));
    away = fmaxl(away, fabsl(K[j] - reference[j]));
  }
  printf("gain by doublings: wrong by %.2Lg of %.4Lg\n", away, largest);
  const tl_real nothing[D * D] = {NAN};
  if (riccati_gain(K, nothing, B, weights, weight, &work)) return puts("a gain of no matrix"), 1;
  return away <= (sizeof(tl_real) == 4 ? 1e-4L : 1e-12L) * largest ? 0 : 1;
}
