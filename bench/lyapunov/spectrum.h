/* What the programs of this benchmark share: the pendulum of LINKS links at its start, and the rows that they print.
 *
 * Each program computes all 2N Lyapunov exponents of the paper's pendulum (m = l = 1, g = 9.81, first link at 75 degrees, all else 0):
 * y and the tangents P' = F P together, P = QR at intervals, rho_i += log R_ii. A program is called as
 *
 *     PROGRAM T_END REPEATS TOLERANCE..
 *
 * and prints one row for each tolerance: tolerance,seconds,energy_error,steps,lambda_1,..,lambda_2N. Seconds are CPU time, the least of
 * the repeats; the energy error is the largest |E - E(0)| seen where P = QR. */
#ifndef BENCH_LYAPUNOV_SPECTRUM_H
#define BENCH_LYAPUNOV_SPECTRUM_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { D = 2 * LINKS };

static const double GRAVITY = 9.81;

typedef struct spectrum {
  double rho[D], t; /* sums of log R_ii, over t, s */
  double energy0, energy_error;
  long steps;
} spectrum;

/* Integrates to t_end, s. Returns 0, or another number where that failed. */
static int spectrum_run(double t_end, double tolerance, spectrum *result);

/* q, qd at t = 0. */
static void spectrum_start(double *y) {
  for (int i = 0; i < D; i++) y[i] = 0.0;
  y[0] = 75.0 * acos(-1.0) / 180.0;
}

static double spectrum_energy(const double *y) {
  double vx = 0.0, vy = 0.0, height = 0.0, sum = 0.0;
  for (int i = 0; i < LINKS; i++) {
    vx += cos(y[i]) * y[LINKS + i];
    vy += sin(y[i]) * y[LINKS + i];
    height -= cos(y[i]);
    sum += 0.5 * (vx * vx + vy * vy) + GRAVITY * height;
  }
  return sum;
}

/* The slopes of P, F P with F = [0 I; qdd_y]. qdd_y: LINKS x D. */
static inline void spectrum_tangents(const double *restrict qdd_y, const double *restrict P, double *restrict Pdot) {
  memcpy(Pdot, P + LINKS * D, LINKS * D * sizeof *P);
  for (int i = 0; i < LINKS; i++) {
    double row[D] = {0.0};
    for (int k = 0; k < D; k++)
      for (int j = 0; j < D; j++) row[j] += qdd_y[i * D + k] * P[k * D + j];
    memcpy(Pdot + (LINKS + i) * D, row, sizeof row);
  }
}

/* P = QR in place (P becomes Q; D x D, row-major) by Gram and Schmidt, each column against the others twice; rho_i += log R_ii. */
static inline void spectrum_orthonormalise(double *P, double *rho) {
  double column[D][D];
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) column[j][i] = P[i * D + j];
  for (int j = 0; j < D; j++) {
    for (int twice = 0; twice < 2; twice++)
      for (int k = 0; k < j; k++) {
        double dot = 0.0;
        for (int i = 0; i < D; i++) dot += column[k][i] * column[j][i];
        for (int i = 0; i < D; i++) column[j][i] -= dot * column[k][i];
      }
    double square = 0.0;
    for (int i = 0; i < D; i++) square += column[j][i] * column[j][i];
    const double length = sqrt(square);
    rho[j] += log(length);
    for (int i = 0; i < D; i++) P[i * D + j] = column[j][i] /= length;
  }
}

/* Looks at the energy of a state. */
static void spectrum_check(spectrum *result, const double *y) {
  result->energy_error = fmax(result->energy_error, fabs(spectrum_energy(y) - result->energy0));
}

static double spectrum_seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv) {
  if (argc < 4) {
    fprintf(stderr, "usage: %s T_END REPEATS TOLERANCE..\n", argv[0]);
    return 2;
  }
  double start[D];
  spectrum_start(start);
  const double energy0 = spectrum_energy(start);
  for (int a = 3; a < argc; a++) {
    spectrum result = {0};
    double least = HUGE_VAL;
    for (int r = 0; r < atoi(argv[2]); r++) {
      result = (spectrum){.energy0 = energy0};
      const double from = spectrum_seconds();
      if (spectrum_run(atof(argv[1]), atof(argv[a]), &result) != 0) {
        fprintf(stderr, "%s: failed at tolerance %s\n", argv[0], argv[a]);
        return 1;
      }
      least = fmin(least, spectrum_seconds() - from);
    }
    printf("%s,%.6f,%.3e,%ld", argv[a], least, result.energy_error, result.steps);
    for (int i = 0; i < D; i++) printf(",%.6f", result.rho[i] / result.t);
    printf("\n");
    fflush(stdout);
  }
  return 0;
}

#endif
