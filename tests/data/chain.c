/* Prints where the masses of a hanging chain are, in quadruple precision: the digits that examples/hard_cases holds its chains against.
 *
 *   cc -O2 tests/data/chain.c -lquadmath -lm -o chain
 *   ./chain TOLERANCE T_END ROWS FIRST OTHERS MASS..    from rest; angles from the downward vertical, degrees: of the first link, of
 * the others
 *
 * The chain is written in angles from the vertical, links of 1 m, g = 9.81 m/s^2:
 *   sum_j mu_max(i,j) (cos(q_i - q_j) qdd_j + sin(q_i - q_j) qd_j^2) = -mu_i g sin q_i,  mu_k = m_k + .. + m_n,
 * and integrated by Gragg's method with extrapolation to step zero (Hairer, Norsett, Wanner I, II.9). Two tolerances show how many
 * digits hold: each row is t, the masses' x and y (y up), and the energy, which must not change. */
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>

typedef __float128 quad;

enum { MOST = 64, COLUMNS = 13 };

static int n;
static quad mu[MOST + 1], mass[MOST], M[MOST][MOST];
static const quad g = (quad)9.81; /* the double, as in the models */

/* Cholesky factors of M in place, then x = M^-1 x. */
static void solve(quad *x) {
  for (int j = 0; j < n; j++) {
    for (int k = 0; k < j; k++) M[j][j] -= M[j][k] * M[j][k];
    M[j][j] = sqrtq(M[j][j]);
    for (int i = j + 1; i < n; i++) {
      for (int k = 0; k < j; k++) M[i][j] -= M[i][k] * M[j][k];
      M[i][j] /= M[j][j];
    }
  }
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) x[i] -= M[i][k] * x[k];
    x[i] /= M[i][i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) x[i] -= M[k][i] * x[k];
    x[i] /= M[i][i];
  }
}

static void rhs(const quad *y, quad *f) {
  quad s[MOST], c[MOST];
  for (int i = 0; i < n; i++) sincosq(y[i], &s[i], &c[i]);
  for (int i = 0; i < n; i++) {
    quad sum = -mu[i] * g * s[i];
    for (int j = 0; j < n; j++) {
      const quad m = mu[i > j ? i : j];
      M[i][j] = m * (c[i] * c[j] + s[i] * s[j]);
      sum -= m * (s[i] * c[j] - c[i] * s[j]) * y[n + j] * y[n + j];
    }
    f[i] = y[n + i];
    f[n + i] = sum;
  }
  solve(f + n);
}

/* Gragg's method with k double steps over h, from (y, f0 = f(y)). */
static void gragg(int k, quad h, const quad *y, const quad *f0, quad *out) {
  quad a[2 * MOST], b[2 * MOST], f[2 * MOST];
  const quad small = h / (2 * k);
  for (int i = 0; i < 2 * n; i++) a[i] = y[i], b[i] = y[i] + small * f0[i];
  for (int step = 1; step < 2 * k; step++) {
    rhs(b, f);
    for (int i = 0; i < 2 * n; i++) {
      const quad next = a[i] + 2 * small * f[i];
      a[i] = b[i], b[i] = next;
    }
  }
  rhs(b, f);
  for (int i = 0; i < 2 * n; i++) out[i] = (a[i] + b[i] + small * f[i]) / 2;
}

/* One step of h in place; returns the last correction of the extrapolation, relative to 1 and the state. */
static quad step(quad h, quad *y) {
  static quad table[COLUMNS][2 * MOST];
  quad f0[2 * MOST], change = 0;
  rhs(y, f0);
  for (int k = 0; k < COLUMNS; k++) {
    gragg(k + 1, h, y, f0, table[k]);
    for (int l = k - 1; l >= 0; l--) {
      const quad ratio = (quad)(k + 1) / (l + 1), factor = 1 / (ratio * ratio - 1);
      change = 0;
      for (int i = 0; i < 2 * n; i++) {
        const quad d = (table[l + 1][i] - table[l][i]) * factor;
        table[l][i] = table[l + 1][i] + d;
        change = fmaxq(change, fabsq(d) / (1 + fabsq(y[i])));
      }
    }
  }
  for (int i = 0; i < 2 * n; i++) y[i] = table[0][i];
  return change;
}

static void print(const char *label, quad x) {
  char text[64];
  quadmath_snprintf(text, sizeof text, "%.25Qg", x);
  printf("%s%s", label, text);
}

static void print_row(quad t, const quad *y) {
  quad px = 0, py = 0, vx = 0, vy = 0, energy = 0;
  print("t ", t);
  for (int i = 0; i < n; i++) {
    quad s, c;
    sincosq(y[i], &s, &c);
    px += s, py -= c, vx += c * y[n + i], vy += s * y[n + i];
    energy += mass[i] * ((vx * vx + vy * vy) / 2 + g * py);
    print("\n  ", px);
    print(" ", py);
  }
  print("\n  energy ", energy);
  putchar('\n');
  fflush(stdout);
}

int main(int argc, char **argv) {
  quad y[2 * MOST] = {0}, was[2 * MOST];
  n = argc - 6;
  if (n < 1 || n > MOST) return fputs("usage: chain TOLERANCE T_END ROWS FIRST OTHERS MASS..\n", stderr), 2;
  const quad tolerance = strtoflt128(argv[1], NULL), t_end = strtoflt128(argv[2], NULL);
  const int rows = atoi(argv[3]);
  for (int i = 0; i < n; i++) mass[i] = (quad)strtod(argv[6 + i], NULL);
  for (int i = n - 1; i >= 0; i--) mu[i] = mu[i + 1] + mass[i];
  for (int i = 0; i < n; i++) y[i] = (quad)(strtod(argv[i == 0 ? 4 : 5], NULL) * 3.14159265358979323846 / 180.0);
  quad h = 1e-3Q;
  print_row(0, y);
  for (int row = 1; row <= rows; row++) {
    const quad end = t_end * row / rows;
    for (quad t = t_end * (row - 1) / rows; t < end;) {
      const quad left = end - t, take = h < left ? h : left;
      for (int i = 0; i < 2 * n; i++) was[i] = y[i];
      const quad error = step(take, y), fit = 0.8Q * powq(tolerance / (error + 1e-40Q), 1 / (quad)(2 * COLUMNS - 1));
      if (error > tolerance)
        for (int i = 0; i < 2 * n; i++) y[i] = was[i];
      else
        t = take < left ? t + take : end;
      h = take * fminq(fmaxq(fit, 0.2Q), 3);
    }
    print_row(end, y);
  }
  return 0;
}
