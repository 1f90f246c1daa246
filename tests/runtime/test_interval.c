/* Intervals of exponents from blocks: coverage on processes whose mean is known, merging of blocks, too few blocks. */
#include "close.h"
#include "random.h"

#include "eom/lyapunov.h"

#include <math.h>
#include <string.h>

/* A run reduced to what intervals read: rho grows by x per mark. */
typedef struct run {
  eom_lyapunov ly;
  double block[EOM_LYAPUNOV_BLOCKS], start, rho;
} run;

static void begin(run *r, int blocks, long block_marks) {
  *r = (run){0};
  r->ly.k = 1;
  r->ly.block = r->block;
  r->ly.block_start = &r->start;
  r->ly.rho = &r->rho;
  r->ly.nblock = blocks;
  r->ly.block_marks = block_marks;
  r->ly.options.interval = 0.5;
  r->ly.t = (double)blocks * (double)block_marks * 0.5;
}

static double normal(rng *r) { return sqrt(-2 * log(rng_uniform(r, 1e-300, 1))) * cos(2 * acos(-1.0) * rng_uniform(r, 0, 1)); }

/* Share of 2000 runs of `blocks` blocks whose interval holds the true mean 0.3; the blocks follow x' = a x + noise. */
static double coverage(int blocks, double a) {
  rng random = {5};
  int held = 0;
  for (int k = 0; k < 2000; k++) {
    run r;
    begin(&r, blocks, 4);
    double x = normal(&random) / sqrt(1 - a * a), mean, half;
    for (int b = 0; b < blocks; b++) {
      r.block[b] = (0.3 + x) * 4 * 0.5;
      x = a * x + normal(&random);
    }
    assert_true(eom_lyapunov_interval(&r.ly, 0, &mean, &half) >= 8);
    held += fabs(mean - 0.3) <= half;
  }
  return held / 2000.0;
}

/* The share has a standard deviation of 0.5 % over 2000 runs. */
static void independent_blocks(void **state) {
  (void)state;
  for (int blocks = 8; blocks <= 64; blocks *= 2) {
    const double share = coverage(blocks, 0);
    print_message("%d independent blocks: the interval holds the mean in %.1f %%\n", blocks, 100 * share);
    assert_true(share > 0.945 && share < 0.995);
  }
}

/* Blocks shorter than the correlation time, (1+a)/(1-a) of them: as long as there are ten times as many. By themselves these would be
 * 71 %, 50 % and 36 %. */
static void correlated_blocks(void **state) {
  (void)state;
  const double a[] = {0.6, 0.8, 0.9}, least[] = {0.945, 0.935, 0.92};
  for (int k = 0; k < 3; k++) {
    const double share = coverage(64, a[k]), half = coverage(32, a[k]);
    print_message("correlation %.1f: 64 blocks %.1f %%, 32 blocks %.1f %%\n", a[k], 100 * share, 100 * half);
    assert_true(share > least[k] && half > least[k] - (k == 2 ? 0.07 : 0.02));
  }
}

/* Neighbours that make up for each other: never narrower than for independent blocks. */
static void opposed_blocks(void **state) {
  (void)state;
  assert_true(coverage(64, -0.5) > 0.99);
}

static void two_kinds_of_blocks(void **state) {
  (void)state;
  run r;
  double mean, half;
  begin(&r, 8, 10);
  const double x[8] = {1, 2, 1, 2, 1, 2, 1, 2};
  for (int b = 0; b < 8; b++) r.block[b] = x[b] * 5;
  assert_int_equal(eom_lyapunov_interval(&r.ly, 0, &mean, &half), 8);
  assert_close(mean, 1.5, 1e-15, 0);
  assert_close(half, 2.364624 * sqrt(2.0 / 7 / 8), 3e-4, 0); /* Student's t for 7 degrees from a table */
}

static void too_few_blocks(void **state) {
  (void)state;
  run r;
  double mean, half;
  begin(&r, 7, 10);
  r.rho = 14;
  assert_int_equal(eom_lyapunov_interval(&r.ly, 0, &mean, &half), 0);
  assert_close(mean, 0.4, 1e-15, 0);
  assert_true(half > 1e300);
}

static void equal_blocks_have_no_width(void **state) {
  (void)state;
  run r;
  double mean, half;
  begin(&r, 16, 10);
  for (int b = 0; b < 16; b++) r.block[b] = 5;
  assert_int_equal(eom_lyapunov_interval(&r.ly, 0, &mean, &half), 16);
  assert_close(mean, 1, 0, 0);
  assert_close(half, 0, 0, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(independent_blocks), cmocka_unit_test(correlated_blocks),
                                     cmocka_unit_test(opposed_blocks),     cmocka_unit_test(two_kinds_of_blocks),
                                     cmocka_unit_test(too_few_blocks),     cmocka_unit_test(equal_blocks_have_no_width)};
  return cmocka_run_group_tests_name("interval", tests, NULL, NULL);
}
