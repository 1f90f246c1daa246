/* Checkpoints of Lyapunov runs: resumed runs have the bits of an uninterrupted one; what is damaged or of another run is refused. */
#include "close.h"
#include "constrained_models.h"
#include "pendulum_model.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define START {1.3089969389957472}

static eom_lyapunov_options options_of(eom_lyapunov_scheme scheme, double h) {
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.scheme = scheme;
  options.interval = 0.25;
  options.h = h;
  return options;
}

static eom_lyapunov *start(eom_system *sys, const eom_lyapunov_options *options, const double *y) {
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, options, 0, y), EOM_OK);
  return ly;
}

static void *image_of(const eom_lyapunov *ly) {
  void *image = malloc(eom_lyapunov_image_bytes(ly));
  assert_non_null(image);
  eom_lyapunov_save(ly, image);
  return image;
}

/* A run of the double pendulum, at t = 1 s. */
typedef struct example {
  eom_system *sys;
  eom_lyapunov *ly;
  void *image;
  size_t bytes;
} example;

static example one_second(const pendulum *p, const eom_lyapunov_options *options) {
  const double y[4] = START;
  example e;
  assert_int_equal(eom_system_create(&e.sys, &pendulum_model, p, NULL), EOM_OK);
  e.ly = start(e.sys, options, y);
  assert_int_equal(eom_lyapunov_to(e.ly, 1, NULL, NULL), EOM_OK);
  e.bytes = eom_lyapunov_image_bytes(e.ly);
  e.image = image_of(e.ly);
  return e;
}

static void forget(example *e) {
  free(e->image);
  eom_lyapunov_destroy(e->ly);
  eom_system_destroy(e->sys);
}

/* Saves at some marks on the way to the last one. */
typedef struct recorder {
  rng random;
  long marks;
  void *image[100]; /* by mark; null where none was saved */
} recorder;

static int record(void *observer, const eom_lyapunov *ly) {
  recorder *r = observer;
  if (ly->marks == r->marks || rng_uniform(&r->random, 0, 1) < 0.2) r->image[ly->marks] = image_of(ly);
  return 0;
}

/* A run of that many marks, and the same from each of its images, by another system that has been elsewhere. */
static void resumes(const eom_model *model, const void *params, const eom_lyapunov_options *options, const double *y,
                    const double *other, long marks) {
  recorder r = {.random = {7}, .marks = marks};
  eom_system *sys, *second;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  assert_int_equal(eom_system_create(&second, model, params, NULL), EOM_OK);
  eom_lyapunov *whole = start(sys, options, y), *parts = start(second, options, other);
  const double t_end = (double)marks * options->interval;
  const size_t bytes = eom_lyapunov_image_bytes(whole);
  assert_int_equal(eom_lyapunov_to(whole, t_end, record, &r), EOM_OK);
  assert_int_equal(eom_lyapunov_to(parts, 3 * options->interval, NULL, NULL), EOM_OK);
  if (options->control.rtol < 1e-11) assert_true(whole->tangents.steps > 0);
  int resumed = 0;
  for (long j = 1; j <= marks; j++) {
    if (!r.image[j]) continue;
    assert_int_equal(eom_lyapunov_restore(parts, r.image[j], bytes), EOM_OK);
    void *again = image_of(parts);
    assert_memory_equal(again, r.image[j], bytes);
    free(again);
    assert_int_equal(eom_lyapunov_to(parts, t_end, NULL, NULL), EOM_OK);
    again = image_of(parts);
    assert_memory_equal(again, r.image[marks], bytes);
    for (int i = 0; i < whole->k; i++) {
      double mean[2], half[2];
      eom_lyapunov_interval(whole, i, &mean[0], &half[0]);
      eom_lyapunov_interval(parts, i, &mean[1], &half[1]);
      assert_all_same(mean, mean + 1, 1);
      assert_all_same(half, half + 1, 1);
    }
    free(again);
    resumed++;
  }
  assert_true(resumed > 0);
  for (long j = 1; j <= marks; j++) free(r.image[j]);
  eom_lyapunov_destroy(whole);
  eom_lyapunov_destroy(parts);
  eom_system_destroy(sys);
  eom_system_destroy(second);
}

static void resumed_runs_have_the_same_bits(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  const double y[4] = START, other[4] = {0.3, 0.1};
  const eom_lyapunov_options all[] = {options_of(EOM_LYAPUNOV_DISCRETE, 0), options_of(EOM_LYAPUNOV_DISCRETE, 0.01),
                                      options_of(EOM_LYAPUNOV_CONTINUOUS, 0), options_of(EOM_LYAPUNOV_PAPER, 2.5e-3)};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) resumes(&pendulum_model, &p, &all[i], y, other, test_tries(24));
  const pendulum long_chain = {6, 9.81};
  const double y6[12] = START, other6[12] = {0.3, 0.1};
  eom_lyapunov_options parted = options_of(EOM_LYAPUNOV_DISCRETE, 0); /* tangents in steps of their own */
  parted.control.rtol = parted.control.atol = 1e-12;
  resumes(&pendulum_model, &long_chain, &parted, y6, other6, test_tries(4));
  const double hanging[8] = {0.6, 0.8, 1.6, 0.8}, elsewhere[8] = {0.8, 0.6, 1.4, 1.4};
  resumes(&cartesian_double_pendulum, NULL, &all[0], hanging, elsewhere, test_tries(24));
}

/* The run is as before a refusal. */
static void refuse(eom_lyapunov *ly, const void *image, size_t bytes, eom_status expected) {
  void *before = image_of(ly);
  assert_int_equal(eom_lyapunov_restore(ly, image, bytes), expected);
  void *after = image_of(ly);
  assert_memory_equal(after, before, eom_lyapunov_image_bytes(ly));
  free(before);
  free(after);
}

static void damaged_images_are_refused(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  const eom_lyapunov_options options = options_of(EOM_LYAPUNOV_DISCRETE, 0);
  example e = one_second(&p, &options);
  unsigned char *image = e.image;
  assert_memory_equal(image, "eomLyap2", 8);
  for (size_t i = 0; i < e.bytes; i += 1 + i / 64) {
    image[i] ^= (unsigned char)(1 << i % 8);
    refuse(e.ly, image, e.bytes, EOM_BAD_CHECKPOINT);
    image[i] ^= (unsigned char)(1 << i % 8);
  }
  for (size_t shorter = 0; shorter < e.bytes; shorter += 1 + shorter / 8) refuse(e.ly, image, shorter, EOM_BAD_CHECKPOINT);
  refuse(e.ly, NULL, e.bytes, EOM_BAD_CHECKPOINT);
  assert_int_equal(eom_lyapunov_restore(e.ly, image, e.bytes), EOM_OK);
  forget(&e);
}

static void refuse_by(const eom_model *model, const void *params, const eom_lyapunov_options *options, const example *e) {
  const double y[6] = START;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  eom_lyapunov *ly = start(sys, options, y);
  refuse(ly, e->image, e->bytes, EOM_OTHER_CHECKPOINT);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

static void images_of_other_runs_are_refused(void **state) {
  (void)state;
  const pendulum p = {2, 9.81}, heavier = {2, 9.82}, longer = {3, 9.81};
  const eom_lyapunov_options options = options_of(EOM_LYAPUNOV_DISCRETE, 0);
  example e = one_second(&p, &options);
  refuse_by(&pendulum_model, &heavier, &options, &e);
  refuse_by(&pendulum_model, &longer, &options, &e);
  eom_model renamed = pendulum_model;
  renamed.name = "other";
  refuse_by(&renamed, &p, &options, &e);
  eom_lyapunov_options o;
#define OTHER(field, value)                                                                                                            \
  o = options;                                                                                                                         \
  o.field = value;                                                                                                                     \
  refuse_by(&pendulum_model, &p, &o, &e);
  OTHER(scheme, EOM_LYAPUNOV_CONTINUOUS)
  OTHER(k, 2)
  OTHER(method, &eom_dp5)
  OTHER(interval, 0.5)
  OTHER(h, 0.01)
  OTHER(control.rtol, 1e-9)
  OTHER(control.atol, 1e-9)
  OTHER(control.h_max, 0.1)
  OTHER(tangent_tolerance, 1e-5)
  o = options;
  o.stop_half_width = 1e-3; /* changes no bit: another stop rule may go on with it */
  const double y[4] = START;
  eom_lyapunov *more = start(e.sys, &o, y);
  assert_int_equal(eom_lyapunov_restore(more, e.image, e.bytes), EOM_OK);
  assert_close(more->t, 1, 0, 0);
  eom_lyapunov_destroy(more);
  forget(&e);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(resumed_runs_have_the_same_bits), cmocka_unit_test(damaged_images_are_refused),
                                     cmocka_unit_test(images_of_other_runs_are_refused)};
  return cmocka_run_group_tests_name("lyapunov_image", tests, NULL, NULL);
}
