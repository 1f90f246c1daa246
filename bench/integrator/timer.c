/* What the integrator costs beside its right-hand side: eom_integrate and a loop of the same method written out by hand, side by side.
 *
 *     timer [--quick]
 *
 * Built with -DLINKS=n: for an oscillator, for the pendulum of n links worked out by hand (bench/hand), and with -DGENERATED for the
 * same pendulum through the runtime and what tlgen generates for it. */
#include "contender.h"
#include "parameters.h"

#include <eom/eom.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef GENERATED
#include "pendulum_tl.h"
#endif

enum { MOST = 2 * LINKS };
#include "hand/dop853.h"

/* One problem, whose right-hand side is known to the compiler for the oscillator alone. */
typedef struct problem {
  const char *name;
  eom_rhs_fn *rhs;
  void *user;
  double (*energy)(const double *y);
  int dim;
  double start[MOST], t_end;
} problem;

/* ---- the loop by hand ---- */

DOP853_INLINE void hand_run(dop853 *z, const problem *p, eom_rhs_fn *rhs, int dim, double h, double tol) {
  dop853_start(z, rhs, p->user, dim, 0.0, p->start, h);
  if (tol > 0.0) {
    for (double t = 0.0; t < p->t_end;) t = dop853_good_step(z, rhs, p->user, dim, dim, t, p->t_end, tol);
    return;
  }
  for (long n = lround(p->t_end / h); z->steps < n;) {
    dop853_step(z, rhs, p->user, dim, dim, (double)z->steps * h, h, 0.0);
    dop853_take(z, rhs, p->user, dim, (double)(z->steps + 1) * h);
  }
}

/* ---- problems ---- */

static int oscillator(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  ydot[0] = y[1];
  ydot[1] = -y[0];
  return 0;
}

static double oscillator_energy(const double *y) { return 0.5 * (y[0] * y[0] + y[1] * y[1]); }

static int chain(void *user, double t, const double *y, double *ydot) {
  const bench_contender *by_hand = user;
  (void)t;
  memcpy(ydot, y + LINKS, LINKS * sizeof *y);
  return by_hand->acceleration(by_hand->self, y, y + LINKS, ydot + LINKS);
}

static double chain_energy(const double *y) {
  double vx = 0.0, vy = 0.0, height = 0.0, sum = 0.0;
  for (int i = 0; i < LINKS; i++) {
    vx += cos(y[i]) * y[LINKS + i];
    vy += sin(y[i]) * y[LINKS + i];
    height -= cos(y[i]);
    sum += 0.5 * (vx * vx + vy * vy) + 9.81 * height;
  }
  return sum;
}

/* ---- timing ---- */

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static dop853 by_hand;
static double work[32 * (MOST + 8)];

static void run_by_hand(const problem *p, double h, double tol) {
  if (p->rhs == oscillator)
    hand_run(&by_hand, p, oscillator, 2, h, tol);
  else
    hand_run(&by_hand, p, p->rhs, MOST, h, tol);
}

static void run_eom(eom_integrator *it, const problem *p, double h, double tol) {
  const eom_step_control control = {.rtol = tol, .atol = tol};
  if (eom_integrator_size(&eom_dop853, p->dim) > sizeof work / sizeof work[0]) exit(1);
  eom_integrator_init(it, &eom_dop853, p->rhs, p->user, p->dim, 0.0, p->start, h, work);
  if (tol > 0.0 && eom_integrator_control(it, &control) != EOM_OK) exit(1);
  if (eom_integrate(it, p->t_end, NULL, NULL) != EOM_OK) exit(1);
}

static void compare(const problem *p, double h, double tol, int repeats) {
  double least[2] = {HUGE_VAL, HUGE_VAL};
  eom_integrator it;
  for (int r = 0; r < repeats; r++) {
    const double t0 = seconds();
    run_by_hand(p, h, tol);
    const double t1 = seconds();
    run_eom(&it, p, h, tol);
    const double t2 = seconds();
    least[0] = fmin(least[0], t1 - t0);
    least[1] = fmin(least[1], t2 - t1);
  }
  const double E = p->energy(p->start);
  printf("%-22s %-8s %9.3f %9.3f %7.2f %8ld %8.1e %8.1e\n", p->name, tol > 0.0 ? "chosen" : "fixed", 1e3 * least[0], 1e3 * least[1],
         least[1] / least[0], it.steps, fabs(p->energy(by_hand.y) - E), fabs(p->energy(it.y) - E));
}

int main(int argc, char **argv) {
  const int quick = argc > 1 && strcmp(argv[1], "--quick") == 0, repeats = quick ? 1 : 15;
  double mass[LINKS], length[LINKS];
  for (int i = 0; i < LINKS; i++) mass[i] = length[i] = 1.0;
  const bench_case links = {"pendulum", LINKS, 9.81, mass, length};
  bench_contender contender;
  if (bench_open(&links, &contender) != 0) return 1;
  problem swing = {"pendulum, by hand", chain, &contender, chain_energy, MOST, {0}, quick ? 1.0 : 100.0};
  const problem turn = {"oscillator", oscillator, NULL, oscillator_energy, 2, {1.0}, quick ? 10.0 : 1000.0};
  swing.start[0] = 75.0 * acos(-1.0) / 180.0;

  printf("%-22s %-8s %9s %9s %7s %8s %8s %8s\n", "right-hand side", "steps", "hand, ms", "eom, ms", "ratio", "number", "dE hand",
         "dE eom");
  compare(&turn, 0.1, 0.0, repeats);
  compare(&turn, 0.1, 1e-10, repeats);
  compare(&swing, 0.0025, 0.0, repeats);
  compare(&swing, 0.0025, 1e-11, repeats);
  compare(&swing, 0.0025, 3e-15, repeats);
#ifdef GENERATED
  const struct pendulum parameters = pendulum_parameters(&links);
  eom_options options = eom_options_default();
  eom_system *sys;
  options.needs = EOM_NEED_SIMULATE;
  if (eom_system_create(&sys, &pendulum_model, &parameters, &options) != EOM_OK) return 1;
  swing.name = "pendulum, generated";
  swing.rhs = eom_rhs;
  swing.user = sys;
  compare(&swing, 0.0025, 0.0, repeats);
  compare(&swing, 0.0025, 1e-11, repeats);
  compare(&swing, 0.0025, 3e-15, repeats);
  eom_system_destroy(sys);
#endif
  return 0;
}
