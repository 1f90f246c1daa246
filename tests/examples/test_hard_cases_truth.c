/* The closed forms that hard cases are held against, beside digits of the same forms in 50-digit arithmetic. */
#include "close.h"
#include "scene.h"

/* Of closed forms in double over up to a thousand periods, relative to the larger of 1 and the number: measured 6e-13 (A01), 5e-14
 * (A02_2), 3e-12 (kepler, whose energy is a difference of numbers two hundred times as large). */
#define TRUTH 1e-11

static void check(const char *name, const scene_digits *digits, int count) {
  const scene *s = scene_find(name);
  scene_start start = {0};
  assert_non_null(s);
  s->begin(&start);
  for (int i = 0; i < count; i++) {
    double value[SCENE_MOST_VALUES];
    s->truth(digits[i].t, value);
    assert_all_close(value, digits[i].value, s->values, TRUTH, TRUTH);
  }
}

#define CHECK(name, digits) check(name, digits, sizeof(digits) / sizeof(digits)[0])

static void simple_pendulum(void **state) {
  (void)state;
  static const scene_digits digits[] = {
      {0.0, {1.0, 3.178112578860037e-51}},
      {1.0, {-0.9862917511318753, -0.16501085312554112}},
      {2.0, {0.7935661953433218, -0.6084839304437913}},
      {3.0, {-0.17665178992283853, -0.9842734097378926}},
      {10.0, {0.2750874625761158, -0.9614192050991254}},
      {100.0, {0.18151335142702044, -0.9833884803340596}},
      {1000.0, {-0.6832301885523849, -0.7302030604226968}},
      {2000.0, {-0.8146030685889329, -0.5800188278370748}},
  };
  CHECK("A01", digits);
}

static void two_four_bars(void **state) {
  (void)state;
  static const scene_digits digits[] = {
      {0.0, {-7.900401020665085e-58, 1.0, 1.0, 7.900401020665085e-58}},
      {0.25, {0.2771022560590262, 0.9608404340404278, 1.3231587284831037, -0.3815932966570322}},
      {1.0, {-0.1950203019494352, -0.9807992056621738, -6.6766780368811585, 1.327578325160488}},
      {5.0, {-0.8113104610051077, -0.5846155453489751, -3.569117397193206, 4.953105171313329}},
      {10.0, {0.3284581115408156, 0.9445185381786009, 1.4230514702069446, -0.4948688454870435}},
      {20.0, {0.8397465743068442, 0.5429785363528836, 1.8382226441967413, -2.8429137892741023}},
  };
  CHECK("A02_2", digits);
}

static void kepler(void **state) {
  (void)state;
  static const scene_digits digits[] = {
      {0.0, {0.01, 1.0, 0.0, 0.0}},
      {0.01, {0.06742483585586756, -0.7119762932091581, 0.5617628014217514, 0.4213221010663135}},
      {0.1, {0.33308694400402467, -0.9497533727563074, 0.2503994005590505, 0.18779955041928786}},
      {1.0, {1.3458211750099154, -0.9951651401100641, 0.0785726421995505, 0.05892948164966288}},
      {3.0, {1.9874929557594236, -0.9999872584810302, 0.004038445292392668, 0.0030288339692945004}},
      {6.25, {0.15813500494495586, -0.8829880403445229, -0.3755163873780545, -0.28163729053354086}},
      {10.0, {1.9483515054370473, -0.9997840780459283, -0.016623786059320335, -0.012467839544490251}},
      {100.0, {0.9494083540609001, -0.9889288664022189, -0.11871228329751861, -0.08903421247313895}},
      {1000.0, {1.327388208732679, -0.9949577310144784, 0.08023610556659205, 0.06017707917494404}},
  };
  CHECK("kepler", digits);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(simple_pendulum), cmocka_unit_test(two_four_bars), cmocka_unit_test(kepler)};
  return cmocka_run_group_tests_name("hard_cases_truth", tests, NULL, NULL);
}
