/* The report's yardstick: equations worked out by hand, and DOP853 written out for their size; a row of end states for each tolerance.
 *
 *     hand [--quick] SCENE T_END Y0..
 *
 * Built with -DLINKS=n beside bench/hand/chain.c; with LINKS = 2 it has Kepler's orbits and the pendulum on a spring too. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { MOST = 2 * LINKS };
#include "hand/dop853.h"

enum { REPEATS = 25, LOOSEST = 3, TIGHTEST = 15 };
static const double seconds_each = 0.2;

static int orbit(void *user, double t, const double *y, double *ydot) {
  const double r2 = y[0] * y[0] + y[1] * y[1], pull = -1.0 / (r2 * sqrt(r2));
  (void)user, (void)t;
  ydot[0] = y[2], ydot[1] = y[3];
  ydot[2] = pull * y[0], ydot[3] = pull * y[1];
  return 0;
}

static int spring(void *user, double t, const double *y, double *ydot) {
  const double g = 9.81, k = 9.81e6;
  (void)user, (void)t;
  ydot[0] = y[2], ydot[1] = y[3];
  ydot[2] = y[0] * y[3] * y[3] + g * cos(y[1]) - k * (y[0] - 1.0);
  ydot[3] = -(g * sin(y[1]) + 2.0 * y[2] * y[3]) / y[0];
  return 0;
}

static bench_contender links;

static int chain(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  memcpy(ydot, y + LINKS, LINKS * sizeof *y);
  return links.acceleration(links.self, y, y + LINKS, ydot + LINKS);
}

static dop853 z;
static long evaluations;

DOP853_INLINE void follow(dop853_rhs *rhs, int dim, const double *y0, double t_end, double tol) {
  dop853_start(&z, rhs, NULL, dim, 0.0, y0, 1e-4 * t_end);
  for (double t = 0.0; t < t_end;) t = dop853_good_step(&z, rhs, NULL, dim, dim, t, t_end, tol);
  evaluations = (z.steps + z.rejected) * (DOP853_STAGES - 1) + z.steps + 1;
}

/* The compiler knows right-hand side and size of each. */
static void follow_scene(const char *scene, const double *y0, double t_end, double tol) {
  if (strncmp(scene, "kepler", 6) == 0)
    follow(orbit, 4, y0, t_end, tol);
  else if (strcmp(scene, "spring") == 0)
    follow(spring, 4, y0, t_end, tol);
  else
    follow(chain, MOST, y0, t_end, tol);
}

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void measure(const char *scene, const double *y0, int dim, double t_end, int k, int repeats) {
  double taken[REPEATS], sum = 0.0;
  int count = 0;
  while (count < repeats && (count == 0 || sum < seconds_each)) {
    const double begin = seconds();
    follow_scene(scene, y0, t_end, pow(10.0, -k));
    sum += taken[count++] = seconds() - begin;
  }
  qsort(taken, (size_t)count, sizeof *taken, ascending);
  printf("%s,hand,dop853,tolerance 1e-%d,%.6g,%.6g,%ld,%ld", scene, k, taken[0], taken[count / 2], z.steps, evaluations);
  for (int i = 0; i < dim; i++) printf(",%.17g", z.y[i]);
  putchar('\n');
}

int main(int argc, char **argv) {
  const int quick = argc > 1 && strcmp(argv[1], "--quick") == 0, dim = argc - quick - 3;
  double y0[MOST], mass[LINKS], length[LINKS];
  if (dim < 1 || dim > MOST) return 2;
  for (int i = 0; i < dim; i++) y0[i] = strtod(argv[quick + 3 + i], NULL);
  for (int i = 0; i < LINKS; i++) mass[i] = length[i] = 1.0;
  const bench_case problem = {"pendulum", LINKS, 9.81, mass, length};
  if (bench_open(&problem, &links) != 0) return 1;
  for (int k = LOOSEST; k <= TIGHTEST; k += quick ? 4 : 1)
    measure(argv[quick + 1], y0, dim, strtod(argv[quick + 2], NULL), k, quick ? 1 : REPEATS);
  return 0;
}
