/* Reads lines of a push and a state in hexadecimal floating point, and prints, likewise, the accelerations there, their derivatives by
 * the state and by the push, and the condition of the mass matrix: what builds are held against each other with. */
#include "matrix.h"
#include "plant.h"

#include <stdio.h>

/* Largest sum of sizes in a row. */
static double norm(const tl_real *A) {
  double largest = 0;
  for (int i = 0; i < N; i++) {
    double sum = 0;
    for (int j = 0; j < N; j++) sum += A[N * i + j] < 0 ? -(double)A[N * i + j] : (double)A[N * i + j];
    if (sum > largest) largest = sum;
  }
  return largest;
}

static int condition(double *cond, const plant_params *params, const tl_real *y) {
  tl_real M[N * N], Q[N], inverse[N * N] = {0};
  const eom_parts parts = {.M = M, .Q = Q};
  const int status = PLANT(simulate)(params, y, y + N, TL_C(0.0), &parts, NULL);
  if (status != 0) return status;
  const double size = norm(M);
  for (int i = 0; i < N; i++) inverse[N * i + i] = TL_C(1.0);
  if (!matrix_solve(N, N, M, inverse)) return EOM_MOTION_PIVOT;
  *cond = size * norm(inverse);
  return 0;
}

static void print(int n, const tl_real *x) {
  for (int i = 0; i < n; i++) printf("%a ", (double)x[i]);
}

static int read_numbers(int n, tl_real *x) {
  for (int i = 0; i < n; i++) {
    double number;
    if (scanf("%lf", &number) != 1) return 0;
    x[i] = (tl_real)number;
  }
  return 1;
}

int main(void) {
  plant_params params = plant_default();
  plant_model model;
  tl_real y[D];
  double cond;
  while (read_numbers(1, &params.push) && read_numbers(D, y)) {
    int status = plant_linearise(&model, &params, y);
    if (status == 0) status = condition(&cond, &params, y);
    if (status != 0) return fprintf(stderr, "status %d\n", status), 1;
    print(N, model.qdd);
    print(N * D, model.qdd_y);
    print(N, model.qdd_push);
    printf("%a\n", cond);
  }
  return 0;
}
