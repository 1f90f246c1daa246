/* Published multibody benchmarks against solutions in quad precision. */
#include "andrews.h"
#include "andrews_tl.h"
#include "bricard.h"
#include "bricard_tl.h"
#include "close.h"
#include "flyball.h"
#include "flyball_tl.h"
#include "four_bars.h"
#include "four_bars_tl.h"

#include "eom/eom.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct outcome {
  double drift; /* largest change of the energy, J */
  int rank;     /* held at the end, */
  long changes; /* and how often it changed */
} outcome;

typedef struct watch {
  eom_system *sys;
  double energy;
  outcome *outcome;
} watch;

static int observe(void *user, const eom_integrator *it) {
  const watch *w = user;
  if (eom_energy(w->sys, it->y, it->y + w->sys->n, it->t) != EOM_OK) return 1;
  w->outcome->drift = fmax(w->outcome->drift, fabs(w->sys->energy - w->energy));
  return 0;
}

/* The state at t_end, in y. */
static outcome run(const eom_model *model, const void *params, const eom_method *method, double step, double t_end, double *y) {
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  options.hold.on = 1;
  options.linalg = EOM_LINALG_CORE; /* the same digits everywhere */
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  double *work = malloc(eom_integrator_size(method, 2 * sys->n) * sizeof *work);
  assert_non_null(work);
  assert_int_equal(eom_project(sys, y, y + sys->n, 0.0, NULL), EOM_OK);
  assert_int_equal(eom_energy(sys, y, y + sys->n, 0.0), EOM_OK);
  outcome done = {0};
  watch w = {sys, sys->energy, &done};
  eom_integrator it;
  eom_integrator_init(&it, method, eom_rhs, sys, 2 * sys->n, 0.0, y, step, work);
  if (sys->m > 0) it.correct = eom_project_state;
  assert_int_equal(eom_integrate(&it, t_end, observe, &w), EOM_OK);
  for (int i = 0; i < 2 * sys->n; i++) y[i] = it.y[i];
  done.rank = sys->held_rank;
  done.changes = sys->rank_changes;
  free(work);
  eom_system_destroy(sys);
  return done;
}

/* At 0.03 s, from a solution in quad precision whose digits agree at two tolerances; the published ones differ by up to 1e-9. */
static void andrews_squeezing_mechanism(void **state) {
  (void)state;
  static const double truth[7] = {15.810771195153710223,  -15.756371058411843368, 0.040822240119645865136, -0.53473011634207954027,
                                  0.52440996587995406456, 0.53473011634207954027, 1.0480807410419378676};
  const andrews p = andrews_parameters();
  double y[14];
  andrews_start(y, y + 7);
  (void)run(&andrews_model, &p, &eom_dp5, 2.5e-6, 0.03, y);
  for (int i = 0; i < 7; i++) assert_close(y[i], truth[i], 1e-10, 0.0);
}

/* At 1 s; the fastest motion has an eigenvalue of -4e4 1/s. */
static void flyball_governor(void **state) {
  (void)state;
  static const double truth[8] = {5.5863469658690051897, 0.5218333016255462757,  0.5218333016255462757,  0.50142092237956761202,
                                  6.2711257418765544868, 0.14088557947952688734, 0.14088557947952688734, -0.12215149289772888287};
  const flyball p = flyball_parameters();
  double y[8];
  flyball_start(y, y + 4);
  (void)run(&flyball_model, &p, &eom_dp5, 4e-5, 1.0, y);
  for (int i = 0; i < 8; i++) assert_close(y[i], truth[i], 1e-10, 0.0);
}

/* Place and velocity of the first joint at t_end, from the closed form in elliptic functions (I phi'^2/2 + G cos phi = E, phi from the
 * vertical, I = (N+1)/3 + N, G = g ((N+1)/2 + N)), on the way through horizontal positions where N rows become dependent. The benchmark
 * asks for 1e-3 and 0.1 J; here the bounds are the step's error. */
static void four_bars_side_by_side(void **state) {
  (void)state;
  static const double one[4] = {0.478385057760970855811, 0.8781501787912091394748, 1.727264075547154199978, -0.940952179371516708612};
  static const double two[4] = {0.3284581115408156227259, 0.9445185381786008772842, 1.42305147020694462457, -0.494868845487043545517};
  static const double forty[4] = {0.03446630730040719634815, 0.9994058603295629552805, 1.005951172814109396225,
                                  -0.03469203416516179979766};
  static const struct {
    int loops;
    const eom_method *method;
    double t, step, place, energy;
    const double *truth;
  } cases[] = {{1, &eom_dp5, 10, 0.005, 1e-6, 1e-6, one},
               {2, &eom_dp5, 10, 0.005, 1e-6, 1e-6, two},
               {2, &eom_dop853, 10, 3.9e-4, 1e-6, 1e-6, two}, /* stages near the positions, with large coefficients */
               {40, &eom_dp5, 2, 0.01, 1e-5, 1e-4, forty}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const four_bars p = four_bars_parameters(cases[k].loops);
    double y[4 * (FOUR_BARS_MAX_LOOPS + 1)];
    four_bars_start(&p, y, y + p.coordinates);
    const outcome done = run(&four_bars_model, &p, cases[k].method, cases[k].step, cases[k].t, y);
    const double *B = y, *v = y + p.coordinates;
    print_message("N = %d, %s, %g s: errors %.1e %.1e %.1e %.1e, energy %.1e J, rank changed %ld times\n", p.loops,
                  cases[k].method->name, cases[k].t, B[0] - cases[k].truth[0], B[1] - cases[k].truth[1], v[0] - cases[k].truth[2],
                  v[1] - cases[k].truth[3], done.drift, done.changes);
    for (int i = 0; i < 2; i++) {
      assert_close(B[i], cases[k].truth[i], 0.0, cases[k].place);
      assert_close(v[i], cases[k].truth[2 + i], 0.0, 10 * cases[k].place);
      assert_close(B[2 * p.loops + i] - (i == 0 ? p.loops : 0), B[i], 0.0, cases[k].place); /* one parallelogram */
    }
    assert_true(done.drift <= cases[k].energy);
    assert_int_equal(done.rank, p.rods);
  }
}

/* P3 at 10 s from a solution in quad precision, uncertain in the 22nd digit. The benchmark asks for an energy within 1e-3 J. */
static void bricard_mechanism(void **state) {
  (void)state;
  static const double truth[3] = {0.9999997294019177747846863587056, -1.0007353899105120342126951079548,
                                  0.99926433969032772433846117090509};
  const bricard p = bricard_parameters();
  double y[2 * BRICARD_COORDINATES];
  bricard_start(y, y + BRICARD_COORDINATES);
  const outcome done = run(&bricard_model, &p, &eom_dp5, 0.01, 10.0, y);
  print_message("P3 %.1e %.1e %.1e, energy %.1e J\n", y[6] - truth[0], y[7] - truth[1], y[8] - truth[2], done.drift);
  for (int i = 0; i < 3; i++) assert_close(y[6 + i], truth[i], 0.0, 1e-9);
  assert_true(done.drift <= 1e-8);
  assert_true(done.rank == 23 && done.changes == 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(four_bars_side_by_side), cmocka_unit_test(andrews_squeezing_mechanism),
                                     cmocka_unit_test(bricard_mechanism), cmocka_unit_test(flyball_governor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
