/* Gauss-Jordan elimination in quadruple precision. */
#include "kkt_truth.h"

#include <stdlib.h>

static quad size_of(quad x) { return x < 0 ? -x : x; }

static void exchange_rows(int n, quad *a, int i, int j) {
  for (int k = 0; k < n; k++) {
    const quad keep = a[i * n + k];
    a[i * n + k] = a[j * n + k];
    a[j * n + k] = keep;
  }
}

void gauss(int n, quad *K, int k, quad *x) {
  for (int c = 0; c < n; c++) {
    int best = c;
    for (int i = c + 1; i < n; i++)
      if (size_of(K[i * n + c]) > size_of(K[best * n + c])) best = i;
    exchange_rows(n, K, c, best);
    exchange_rows(k, x, c, best);
    for (int i = 0; i < n; i++) {
      if (i == c) continue;
      const quad f = K[i * n + c] / K[c * n + c];
      for (int j = c; j < n; j++) K[i * n + j] -= f * K[c * n + j];
      for (int j = 0; j < k; j++) x[i * k + j] -= f * x[c * k + j];
    }
  }
  for (int c = 0; c < n; c++)
    for (int j = 0; j < k; j++) x[c * k + j] /= K[c * n + c];
}

void kkt_truth(int n, int m, const double *M, const double *A, const double *Q, const double *b, double *x) {
  const int d = n + m;
  quad *K = calloc((size_t)d * (size_t)d, sizeof(quad)), *y = calloc((size_t)d, sizeof(quad));
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) K[i * d + j] = (quad)M[i * n + j];
    for (int r = 0; r < m; r++) {
      K[i * d + n + r] = -(quad)A[r * n + i];
      K[(n + r) * d + i] = (quad)A[r * n + i];
    }
    y[i] = (quad)Q[i];
  }
  for (int r = 0; r < m; r++) y[n + r] = (quad)b[r];
  gauss(d, K, 1, y);
  for (int i = 0; i < d; i++) x[i] = (double)y[i];
  free(K);
  free(y);
}
