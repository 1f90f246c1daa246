/* Whether intervals of Lyapunov exponents hold the truth: runs of T_END s from STARTS starts a little beside each other, whose motions
 * part at once, on what tlgen generates for the pendulum. The truth is the mean of all runs. Called as
 *
 *     PROGRAM T_END STARTS
 *
 * and prints a row for each of the first N exponents: i,lambda,spread,half_width,held. spread: 1.96 standard deviations of the runs'
 * means; half_width: the mean of those of the intervals; held: the share of intervals that hold lambda. Built with -DLINKS=n. */
#include "pendulum.h"
#include "pendulum_tl.h"

#include <eom/eom.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { D = 2 * LINKS };

typedef struct interval {
  double mean, half_width;
} interval;

/* LINKS intervals of the run from start s. Returns 0, or 1 where it failed. */
static int run(eom_system *sys, int s, double t_end, interval *result) {
  double y[D] = {75.0 * acos(-1.0) / 180.0 + 1e-5 * s};
  eom_lyapunov *ly;
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.interval = 1.0;
  options.control = (eom_step_control){.rtol = 1e-8, .atol = 1e-8};
  options.tangent_tolerance = 1e-4;
  eom_status status = eom_lyapunov_create(&ly, sys, &options, 0.0, y);
  if (status != EOM_OK) return 1;
  status = eom_lyapunov_to(ly, t_end, NULL, NULL);
  for (int i = 0; i < LINKS; i++)
    if (eom_lyapunov_interval(ly, i, &result[i].mean, &result[i].half_width) == 0) status = EOM_BAD_OPTION;
  eom_lyapunov_destroy(ly);
  return status != EOM_OK;
}

/* all: LINKS intervals of each of the runs. */
static void print_row(int i, int starts, const interval *all) {
  double truth = 0.0, square = 0.0, width = 0.0;
  int held = 0;
  for (int s = 0; s < starts; s++) truth += all[s * LINKS + i].mean / starts;
  for (int s = 0; s < starts; s++) {
    const interval *x = &all[s * LINKS + i];
    square += (x->mean - truth) * (x->mean - truth) / starts;
    width += x->half_width / starts;
    held += fabs(x->mean - truth) <= x->half_width;
  }
  printf("%d,%.5f,%.5f,%.5f,%.4f\n", i + 1, truth, 1.96 * sqrt(square), width, (double)held / starts);
}

int main(int argc, char **argv) {
  const int starts = argc == 3 ? atoi(argv[2]) : 0;
  if (starts <= 0) {
    fprintf(stderr, "usage: %s T_END STARTS\n", argv[0]);
    return 2;
  }
  struct pendulum p = {.n = LINKS, .g = 9.81};
  for (int i = 0; i < LINKS; i++) p.mass[i] = p.length[i] = 1.0;
  eom_system *sys;
  interval *all = calloc((size_t)starts * LINKS, sizeof *all);
  int failed = !all || eom_system_create(&sys, &pendulum_model, &p, NULL) != EOM_OK;
  for (int s = 0; s < starts && !failed; s++) failed = run(sys, s, atof(argv[1]), all + s * LINKS);
  for (int i = 0; i < LINKS && !failed; i++) print_row(i, starts, all);
  free(all);
  if (failed) fprintf(stderr, "%s: failed\n", argv[0]);
  return failed;
}
