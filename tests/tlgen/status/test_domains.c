/* What is not defined is refused by motion functions as by jets, where only derivatives are needed that exist beyond (1/x of log(x)) too. */
#include "close.h"
#include "domains_tl.h"
#include "eom/eom.h"

#include <string.h>

enum { N = 19 };
static const double inside[N] = {1, 1, 1, 1, 0.5, 2, 0.5, 0.5, 1, 1, 1, 1, -1, 1, 1, 1, 1, 1, 1};
static const struct {
  int i;
  double q;
} outside[] = {{0, -1},   {0, 0},  {1, -1},  {2, -1},  {3, -2}, {3, -1},   {4, 2},  {4, -2}, {4, 1},   {5, -2},  {5, 0.5},
               {6, 1.5}, {7, -2}, {8, -1},  {9, -1}, {10, -1}, {11, -1}, {12, 1},  {12, 0}, {13, -1}, {13, 0}, {14, 3}, {15, 3}, {16, 1.5}, {17, 0}, {18, 0}};

static eom_system *make(eom_emitter emitter) {
  eom_system *sys;
  eom_options options = eom_options_default();
  options.emitter = emitter;
  assert_int_equal(eom_system_create(&sys, &domains_model, NULL, &options), EOM_OK);
  return sys;
}

static void expect(eom_emitter emitter, const double *q, eom_status status) {
  const double qd[N] = {0};
  eom_system *sys = make(emitter);
  assert_int_equal(eom_acceleration(sys, q, qd, 0), status);
  assert_int_equal(eom_assemble(sys, q, qd, 0), status);
  assert_int_equal(eom_linearise(sys, q, qd, 0), status);
  eom_system_destroy(sys);
}

static void refused_alike(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof outside / sizeof *outside; k++) {
    double q[N];
    memcpy(q, inside, sizeof q);
    q[outside[k].i] = outside[k].q;
    print_message("q[%d] = %g\n", outside[k].i, outside[k].q);
    expect(EOM_EMITTER_CALLS, q, EOM_DOMAIN);
    expect(EOM_EMITTER_MOTION, q, EOM_DOMAIN);
  }
}

/* The function of the source, not a division that its derivative is. */
static void named_as_in_the_source(void **state) {
  (void)state;
  double q[N];
  const double qd[N] = {0};
  eom_system *sys = make(EOM_EMITTER_MOTION);
  memcpy(q, inside, sizeof q);
  q[3] = -2;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_DOMAIN);
  assert_int_equal(sys->report.jet.function, TL_FN_log1p);
  eom_system_destroy(sys);
}

static void all_is_well_inside(void **state) {
  (void)state;
  expect(EOM_EMITTER_CALLS, inside, EOM_OK);
  expect(EOM_EMITTER_MOTION, inside, EOM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(refused_alike), cmocka_unit_test(named_as_in_the_source),
                                     cmocka_unit_test(all_is_well_inside)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
