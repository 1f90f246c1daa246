/* Prints the reference of one benchmark case: accelerations and their derivatives in quadruple precision from d'Alembert's principle,
 * sum_k m_k (x_k'' - g) . dx_k/dq_i = 0, with no mass matrix and no derivative worked out by hand.
 *   bench_reference MODEL N PARAMETERS >REFERENCE     PARAMETERS: gravity, then N lines of mass and length */
#include "reference.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef __float128 quad;
extern quad sinq(quad), cosq(quad), sqrtq(quad); /* of libquadmath, whose header is not on every compiler's path */

enum { LINKS = 64, COORDINATES = 2 * LINKS };

typedef struct chain {
  int n;
  int relative; /* angles are relative to the link before */
  quad gravity, mass[LINKS], length[LINKS];
} chain;

/* A state of motion y = (q, qd). */
typedef struct motion {
  quad q[LINKS], qd[LINKS];
} motion;

static void add_up(int n, quad *x) {
  for (int i = 1; i < n; i++) x[i] += x[i - 1];
}

/* r_i = sum_k m_k (x_k'' - g) . dx_k/dq_i. */
static void residual(const chain *c, const motion *y, const quad *qdd, quad *r) {
  int n = c->n;
  motion z = *y;
  quad a[LINKS], ax = 0, ay = 0, fx[LINKS], fy[LINKS], sx = 0, sy = 0;
  memcpy(a, qdd, sizeof a);
  if (c->relative) add_up(n, z.q), add_up(n, z.qd), add_up(n, a);
  for (int k = 0; k < n; k++) {
    quad s = sinq(z.q[k]), co = cosq(z.q[k]), w2 = z.qd[k] * z.qd[k];
    ax += c->length[k] * (co * a[k] - s * w2);
    ay += c->length[k] * (s * a[k] + co * w2);
    fx[k] = c->mass[k] * ax;
    fy[k] = c->mass[k] * (ay + c->gravity);
  }
  for (int i = n - 1; i >= 0; i--) {
    sx += fx[i], sy += fy[i];
    r[i] = c->length[i] * (cosq(z.q[i]) * sx + sinq(z.q[i]) * sy);
    if (c->relative && i + 1 < n) r[i] += r[i + 1];
  }
}

/* M = L L', lower triangle in place. */
static void factor(int n, quad M[LINKS][LINKS]) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      quad sum = M[i][j];
      for (int k = 0; k < j; k++) sum -= M[i][k] * M[j][k];
      M[i][j] = i == j ? sqrtq(sum) : sum / M[j][j];
    }
}

static void solve(int n, quad L[LINKS][LINKS], quad *x) {
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) x[i] -= L[i][k] * x[k];
    x[i] /= L[i][i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) x[i] -= L[k][i] * x[k];
    x[i] /= L[i][i];
  }
}

/* r is linear in qdd: its value at 0 is -Q, the columns of M are what a unit acceleration adds. L: the factor of M. */
static void accelerate(const chain *c, const motion *y, quad L[LINKS][LINKS], quad *qdd) {
  quad rest[LINKS], column[LINKS], unit[LINKS] = {0};
  residual(c, y, unit, rest);
  for (int j = 0; j < c->n; j++) {
    unit[j] = 1, residual(c, y, unit, column), unit[j] = 0;
    for (int i = 0; i < c->n; i++) L[i][j] = column[i] - rest[i];
  }
  factor(c->n, L);
  for (int i = 0; i < c->n; i++) qdd[i] = -rest[i];
  solve(c->n, L, qdd);
}

/* column = d qdd/dy_j = -M^-1 dr/dy_j at fixed qdd, by differences of fourth order: their error is h^4/30, and 1e-34/h of rounding. */
static void differentiate(const chain *c, const motion *y, int j, quad L[LINKS][LINKS], const quad *qdd, quad *column) {
  static const int place[] = {-2, -1, 1, 2}, weight[] = {1, -8, 8, -1};
  const quad h = (quad)0x1p-20;
  memset(column, 0, LINKS * sizeof *column);
  for (int k = 0; k < 4; k++) {
    motion z = *y;
    quad r[LINKS], *moved = j < c->n ? &z.q[j] : &z.qd[j - c->n];
    *moved += place[k] * h;
    residual(c, &z, qdd, r);
    for (int i = 0; i < c->n; i++) column[i] -= weight[k] * r[i] / (12 * h);
  }
  solve(c->n, L, column);
}

/* Uniform in [-1, 1): the same numbers on every machine (splitmix64). */
static double uniform(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9E3779B97F4A7C15);
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return (double)(int64_t)(z ^ (z >> 31)) * 0x1p-63;
}

/* Angles within 3 rad (a relative chain is bent less, or its links would coil), rates within 1 rad/s. */
static void choose(const chain *c, bench_state s, uint64_t *random) {
  for (int i = 0; i < c->n; i++) s.q[i] = (c->relative ? 1.0 : 3.0) * uniform(random);
  for (int i = 0; i < c->n; i++) s.qd[i] = uniform(random);
  for (int i = 0; i < 2 * c->n; i++) s.w[i] = uniform(random);
}

static void fill(const chain *c, bench_state s) {
  static quad L[LINKS][LINKS];
  int n = c->n;
  motion y = {0};
  quad qdd[LINKS], column[LINKS], tangent[LINKS] = {0};
  for (int i = 0; i < n; i++) y.q[i] = (quad)s.q[i], y.qd[i] = (quad)s.qd[i];
  accelerate(c, &y, L, qdd);
  for (int j = 0; j < 2 * n; j++) {
    differentiate(c, &y, j, L, qdd, column);
    for (int i = 0; i < n; i++) s.qdd_y[i * 2 * n + j] = (double)column[i], tangent[i] += column[i] * (quad)s.w[j];
  }
  for (int i = 0; i < n; i++) s.qdd[i] = (double)qdd[i], s.dqdd[i] = (double)tangent[i];
}

/* Gravity, masses and lengths into the head of the block. */
static int read_parameters(const char *path, int n, double *block) {
  FILE *file = fopen(path, "r");
  int ok = file != NULL && fscanf(file, "%lf", block) == 1;
  for (int k = 0; ok && k < n; k++) ok = fscanf(file, "%lf %lf", block + 1 + k, block + 1 + n + k) == 2;
  if (file != NULL) fclose(file);
  if (!ok) fprintf(stderr, "bench_reference: cannot read gravity and %d lines of mass and length from '%s'\n", n, path);
  return ok;
}

int main(int argc, char **argv) {
  int n = argc == 4 ? atoi(argv[2]) : 0;
  if (n < 1 || n > LINKS) return fprintf(stderr, "usage: bench_reference MODEL N PARAMETERS >REFERENCE (N: 1..%d)\n", LINKS), 2;
  double *block = calloc(bench_block_size(n), sizeof *block);
  if (block == NULL || !read_parameters(argv[3], n, block)) return free(block), 1;
  chain c = {.n = n, .relative = strcmp(argv[1], "relative_chain") == 0, .gravity = (quad)block[0]};
  for (int k = 0; k < n; k++) c.mass[k] = (quad)block[1 + k], c.length[k] = (quad)block[1 + n + k];
  uint64_t random = 7;
  for (int k = 0; k < BENCH_STATES; k++) {
    choose(&c, bench_block_state(block, n, k), &random);
    fill(&c, bench_block_state(block, n, k));
  }
  size_t written = fwrite(block, sizeof *block, bench_block_size(n), stdout);
  int failed = written != bench_block_size(n) || fflush(stdout) != 0;
  free(block);
  return failed;
}
