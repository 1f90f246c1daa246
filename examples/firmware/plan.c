/* Plans how two poles swing up, on a host, and prints reference_table.c: from the one that there is, or from nothing with the argument
 * `new`.
 *
 * The motion is one of least cost from hanging to standing, by differential dynamic programming with the model's exact linearisation
 * (iLQR: Li and Todorov 2004): pushes that hold for 40 ms each, a cost of the push that rises steeply beyond the limit below, of the
 * cart's way, and of what is left at the end. The matrices X that follow are the cost of being beside that motion, backwards from the
 * regulator's at its end by Riccati's recursion in control steps. All is sums, products and libtaylor's sine: the same bits on every
 * host. */
#include "controller.h"
#include "matrix.h"
#include "reference.h"
#include "taylor/sincos_number.h"

#include <stdio.h>
#include <string.h>

enum { K = REFERENCE_KNOTS - 1, SUBSTEPS = 4, ITERATIONS = 2000, W = D + 1 /* columns: state and push */ };

static const double H = (tl_real)REFERENCE_KNOT_STEPS * CONTROL_PERIOD; /* s */
static const double PUSH_WEIGHT = 0.01, CART_WEIGHT = 1.0, LIMIT = 9.0 /* N */, LIMIT_WEIGHT = 1.0;
static const double END_WEIGHT[D] = {500, 5000, 5000, 100, 100, 100};

/* pushes[k] and states[k] at knot k, the map to the next as A dy + B dpush, and the improved policy push + step * open + closed dy. */
typedef struct motion {
  double push[K], y[K + 1][D];
} motion;

static motion now, tried;
static double A[K][D * D], B[K][D], open[K], closed[K][D];

static void fill(int n, double *x, double value) {
  for (int i = 0; i < n; i++) x[i] = value;
}

/* f = y' and, D x W, its derivatives by state and push. */
static int slope(double *f, double *F, const double *y, double push) {
  plant_model model;
  plant_params params = plant_default();
  params.push = push;
  const int status = plant_linearise(&model, &params, y);
  fill(D * W, F, 0.0);
  for (int i = 0; i < N; i++) {
    f[i] = y[N + i];
    f[N + i] = model.qdd[i];
    F[W * i + N + i] = 1.0;
    for (int j = 0; j < D; j++) F[W * (N + i) + j] = model.qdd_y[D * i + j];
    F[W * (N + i) + D] = model.qdd_push[i];
  }
  return status;
}

/* y and its derivatives T (D x W) by the state and push at the knot, a time h further by Kutta's method of the fourth order. */
static int advance(double *y, double *T, double push, double h) {
  static const double part[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  double f[D] = {0}, Tf[D * W] = {0}, y_sum[D] = {0}, T_sum[D * W] = {0};
  int status = 0;
  for (int stage = 0; stage < 4; stage++) {
    double z[D], Z[D * W], F[D * W];
    for (int i = 0; i < D; i++) z[i] = y[i] + h * part[stage] * f[i];
    for (int i = 0; i < D * W; i++) Z[i] = T[i] + h * part[stage] * Tf[i];
    status |= slope(f, F, z, push);
    for (int i = 0; i < D; i++) {
      y_sum[i] += weight[stage] * f[i];
      for (int j = 0; j < W; j++) {
        Tf[W * i + j] = (j == D ? F[W * i + D] : 0.0) + matrix_dot(D, F + W * i, Z + j, W);
        T_sum[W * i + j] += weight[stage] * Tf[W * i + j];
      }
    }
  }
  for (int i = 0; i < D; i++) y[i] += h * y_sum[i];
  for (int i = 0; i < D * W; i++) T[i] += h * T_sum[i];
  return status;
}

/* y over a time h in n steps, and the map A dy + B dpush. */
static int map(double *y, double *a, double *b, double push, double h, int n) {
  double T[D * W];
  int status = 0;
  for (int i = 0; i < D * W; i++) T[i] = i / W == i % W;
  for (int i = 0; i < n; i++) status |= advance(y, T, push, h / n);
  for (int i = 0; i < D; i++) {
    b[i] = T[W * i + D];
    for (int j = 0; j < D; j++) a[D * i + j] = T[W * i + j];
  }
  return status;
}

static double beyond(double push) { return push > LIMIT ? push - LIMIT : push < -LIMIT ? push + LIMIT : 0.0; }

/* The motion `tried` by the policy; its cost, which is no number where the model has none. */
static double follow(double step) {
  double cost = 0.0;
  for (int i = 0; i < D; i++) tried.y[0][i] = now.y[0][i];
  for (int k = 0; k < K; k++) {
    double *y = tried.y[k], miss[D], a[D * D], b[D];
    for (int i = 0; i < D; i++) miss[i] = y[i] - now.y[k][i];
    const double push = tried.push[k] = now.push[k] + step * open[k] + matrix_dot(D, closed[k], miss, 1), more = beyond(push);
    cost += H / 2 * (PUSH_WEIGHT * push * push + LIMIT_WEIGHT * more * more + CART_WEIGHT * y[0] * y[0]);
    for (int i = 0; i < D; i++) tried.y[k + 1][i] = y[i];
    if (map(tried.y[k + 1], a, b, push, H, SUBSTEPS) != 0) return (double)NAN;
  }
  for (int i = 0; i < D; i++) cost += END_WEIGHT[i] / 2 * tried.y[K][i] * tried.y[K][i];
  return cost;
}

static void take(void) {
  now = tried;
  for (int k = 0; k < K; k++) {
    double y[D];
    for (int i = 0; i < D; i++) y[i] = now.y[k][i];
    (void)map(y, A[k], B[k], now.push[k], H, SUBSTEPS);
  }
}

/* The policy from the end to the start: with the cost v'dy + dy'V dy/2 of what follows a step,
 *     Q_uu = H weight + B'V B,     Q_u = H weight push + B'v,     Q_uy = B'V A,
 *     open = -Q_u/(Q_uu + damping),     closed = -Q_uy/(Q_uu + damping). */
static void improve(double damping) {
  double V[D * D] = {0}, v[D];
  for (int i = 0; i < D; i++) {
    V[D * i + i] = END_WEIGHT[i];
    v[i] = END_WEIGHT[i] * now.y[K][i];
  }
  for (int k = K - 1; k >= 0; k--) {
    double At[D * D], VA[D * D], BV[D], Quy[D], Qy[D], Q[D * D];
    const double push = now.push[k], more = beyond(push);
    matrix_transpose(D, At, A[k]);
    matrix_multiply(D, VA, V, A[k]);
    matrix_multiply(D, Q, At, VA);
    for (int i = 0; i < D; i++) BV[i] = matrix_dot(D, V + D * i, B[k], 1);
    const double Quu = H * (PUSH_WEIGHT + (more != 0.0 ? LIMIT_WEIGHT : 0.0)) + matrix_dot(D, B[k], BV, 1);
    const double Qu = H * (PUSH_WEIGHT * push + LIMIT_WEIGHT * more) + matrix_dot(D, B[k], v, 1);
    for (int j = 0; j < D; j++) {
      Quy[j] = matrix_dot(D, BV, A[k] + j, D);
      Qy[j] = matrix_dot(D, v, A[k] + j, D);
    }
    Q[0] += H * CART_WEIGHT;
    Qy[0] += H * CART_WEIGHT * now.y[k][0];
    open[k] = -Qu / (Quu + damping);
    for (int i = 0; i < D; i++) closed[k][i] = -Quy[i] / (Quu + damping);
    for (int i = 0; i < D; i++) {
      v[i] = Qy[i] + closed[k][i] * (Quu * open[k] + Qu) + Quy[i] * open[k];
      for (int j = 0; j < D; j++) V[D * i + j] = Q[D * i + j] + closed[k][i] * (Quu * closed[k][j] + Quy[j]) + Quy[i] * closed[k][j];
    }
  }
}

static double improved(double cost, double damping) {
  for (int i = 0; i < ITERATIONS && damping < 1e8; i++) {
    double step = 1.0, next = cost;
    improve(damping);
    while (step > 1e-4 && !((next = follow(step)) < cost)) step /= 2; /* until it helps */
    if (!(next < cost)) {
      damping *= 10;
      continue;
    }
    take();
    if (cost - next < 1e-9 * cost) return next;
    cost = next;
    if (damping > 1e-9) damping /= 3;
  }
  return cost;
}

/* From a push to and fro, which has led to the cheapest of the motions found from several. There are many optima: a model that differs
 * in its last bits may lead to another. */
static double plan_new(void) {
  for (int k = 0; k < K; k++) now.push[k] = 3.0 * tl_sincos_number(2 * 3.14159265358979323846 * 0.8 * (double)k * H).sine;
  now.y[0][1] = now.y[0][2] = 3.14159265358979323846;
  const double cost = follow(0.0);
  take();
  return improved(cost, 1e-3);
}

/* From the table that there is, for a machine that is nearly the same: at once by the policy beside it, as no push alone leads there.
 */
static double plan_again(void) {
  for (int k = 0; k <= K; k++) {
    if (k < K) tried.push[k] = (double)reference_table[k].push;
    for (int i = 0; i < D; i++) tried.y[k][i] = (double)reference_table[k].y[i];
  }
  take();
  now.y[0][1] = now.y[0][2] = 3.14159265358979323846;
  improve(0.0);
  const double cost = follow(1.0);
  take();
  return improved(cost, 1e-9);
}

/* X <- weights + A'X (A - B K): one control step back. */
static int back(double *X, const double *a, const double *b) {
  double gain[D], closed_loop[D * D], Xc[D * D], at[D * D];
  if (!riccati_gain_of(gain, X, a, b, CONTROL_WEIGHT_PUSH)) return 0;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) closed_loop[D * i + j] = a[D * i + j] - b[i] * gain[j];
  matrix_transpose(D, at, a);
  matrix_multiply(D, Xc, X, closed_loop);
  matrix_multiply(D, closed_loop, at, Xc);
  for (int i = 0; i < D; i++)
    for (int j = i; j < D; j++)
      X[D * i + j] = X[D * j + i] = (closed_loop[D * i + j] + closed_loop[D * j + i]) / 2 + (i == j ? CONTROL_WEIGHT(i) : 0.0);
  return 1;
}

/* The regulator's own X, where the poles stand. */
static int regulator(double *X) {
  double y[D] = {0}, a[D * D], b[D], gain[D], weights[D];
  static riccati work;
  for (int i = 0; i < D; i++) weights[i] = CONTROL_WEIGHT(i);
  if (map(y, a, b, 0.0, CONTROL_PERIOD, 1) != 0 || !riccati_gain(gain, a, b, weights, CONTROL_WEIGHT_PUSH, &work)) return 0;
  for (int i = 0; i < D * D; i++) X[i] = work.H[i];
  return 1;
}

/* The matrices X at the knots. */
static int costs(double (*X)[D * D]) {
  if (!regulator(X[K])) return 0;
  for (int k = K - 1; k >= 0; k--) {
    static double a[REFERENCE_KNOT_STEPS][D * D], b[REFERENCE_KNOT_STEPS][D];
    double y[D];
    for (int i = 0; i < D; i++) y[i] = now.y[k][i];
    for (int step = 0; step < REFERENCE_KNOT_STEPS; step++)
      if (map(y, a[step], b[step], now.push[k], CONTROL_PERIOD, 1) != 0) return 0;
    for (int i = 0; i < D * D; i++) X[k][i] = X[k + 1][i];
    for (int step = REFERENCE_KNOT_STEPS - 1; step >= 0; step--)
      if (!back(X[k], a[step], b[step])) return 0;
  }
  return 1;
}

int main(int argc, char **argv) {
  static double X[K + 1][D * D];
  const double cost = argc > 1 && strcmp(argv[1], "new") == 0 ? plan_new() : plan_again();
  if (!costs(X)) return fputs("plan: no cost beside the motion\n", stderr), 1;
  printf("/* Printed by plan.c: a motion of cost %.4g. Do not edit. */\n#include \"reference.h\"\n\n", cost);
  puts("/* clang-format off */\nconst reference_knot reference_table[REFERENCE_KNOTS] = {");
  for (int k = 0; k <= K; k++) {
    printf("  {%.8ef, {", k < K ? now.push[k] : 0.0);
    for (int i = 0; i < D; i++) printf("%s%.8ef", i > 0 ? ", " : "", now.y[k][i]);
    printf("},\n   {");
    for (int i = 0, part = 0; i < D; i++)
      for (int j = i; j < D; j++, part++) printf("%s%.8ef", part == 0 ? "" : part % 7 == 0 ? ",\n    " : ", ", X[k][D * i + j]);
    puts("}},");
  }
  puts("};");
  return 0;
}
