/* Arrays: two and three dimensions, rows passed on, transposed in place, flat and nested initialisers, pointers to rows. */
#include <math.h>

enum { N = 3, HALF = N / 2 };

static void multiply(double c[N][N], double a[][N], const double b[N][N])
{
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      double s = 0.0;
      for (int k = 0; k < N; k++) s += a[i][k] * b[k][j];
      c[i][j] = s;
    }
}

static void transpose(double (*a)[N])
{
  for (int i = 0; i < N; i++)
    for (int j = 0; j < i; j++) {
      double x = a[i][j];
      a[i][j] = a[j][i];
      a[j][i] = x;
    }
}

static double norm1(const double *row, int n)
{
  double s = 0.0;
  for (int i = 0; i < n; i++) s += row[i] * row[i];
  return s;
}

static double trace(double a[N][N])
{
  double s = 0.0;
  for (double(*row)[N] = a; row < a + N; row++) s += (*row)[row - a];
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  const double unit[N][N] = {{1.0, 0.5}, {0.0, 1.0, -0.5}, {[2] = 2.0}};
  double a[N][N] = {{q[0], q[1], q[2]}, {qd[0], qd[1], qd[2]}, {t, 1.0}};
  double b[N][N], cube[2][2][2] = {1.0, q[0], [1] = {{q[1]}, {2.0, qd[2]}}}, flat[] = {t, q[2], 3.0, qd[0]}, L;
  double(*row)[N] = &a[1];

  multiply(b, a, unit);
  multiply(a, b, unit);
  transpose(b);
  L = trace(a) + trace(b) + norm1(a[1], N) + norm1(&b[2][1], 2) + norm1(row[1], HALF + 1) + norm1(unit[2], N);
  row[-1][2] = 0.5 * row[0][0];
  row++;
  (*row)[0] -= L * 0.125;
  for (int i = 0; i < N; i++) L += a[i][(i + 1) % N] * b[N - 1 - i][i];
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      for (int k = 0; k < 2; k++) L += cube[i][j][k] * (4 * i + 2 * j + k + 1) * flat[2 * j + k];
  return L + flat[sizeof flat / sizeof flat[0] - 1];
}
