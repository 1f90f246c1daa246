/* EOM_SYSTEM_BYTES is a constant expression, and what eom_system_bytes returns: for models that have nothing but sizes. */
#include "close.h"

#include "eom/bytes.h"
#include "eom/integrate.h"

typedef struct sizes {
  unsigned needs;
  int n, m1, m2;
  size_t work;
  int constant_mass, rows1, frame1, rows2, frame2, rows, frame;
  size_t bytes;
} sizes;

/* needs, n, m1, m2, work, constant_mass, rows1, frame1, rows2, frame2, rows, frame */
#define CASE(...) {__VA_ARGS__, EOM_SYSTEM_BYTES(__VA_ARGS__)}
static const sizes cases[] = {
    CASE(EOM_NEED_SIMULATE, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 3),
    CASE(EOM_NEED_LINEARISE, 2, 0, 0, 0, 0, 0, 0, 0, 0, 2, 10),
    CASE(EOM_NEED_LINEARISE, 6, 0, 0, 0, 1, 0, 0, 0, 0, 6, 31),
    CASE(EOM_NEED_SIMULATE, 3, 2, 0, 17, 0, 2, 11, 0, 0, 2, 23),
    CASE(EOM_NEED_LINEARISE, 3, 2, 0, 200, 1, 1, 4, 0, 0, 1, 40),
    CASE(EOM_NEED_SIMULATE, 3, 0, 2, 0, 0, 0, 0, 2, 50, 3, 50),
    CASE(EOM_NEED_LINEARISE, 4, 0, 2, 0, 0, 0, 0, 2, 50, 4, 50),
    CASE(EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL, 5, 7, 4, 8, 0, 4, 30, 3, 2, 5, 64),
    CASE(EOM_NEED_RESIDUAL, 20, 9, 0, 1000, 0, 9, 200, 0, 0, 9, 300),
    CASE(EOM_NEED_TANGENT, 2, 1, 1, 0, 0, 1, 5, 1, 6, 2, 9),
    CASE(EOM_NEED_ALL, 4, 2, 1, 96, 1, 2, 12, 1, 8, 4, 20),
};

static const sizes *now; /* whose sizes the model has */

static int dof(const void *params) { return (void)params, now->n; }
static int one(const void *params) { return (void)params, 1; }
static int most(const void *params) { return (void)params, now->rows; }
static int rows1(const void *params) { return (void)params, now->rows1; }
static int rest1(const void *params) { return (void)params, now->m1 - now->rows1; }
static int rows2(const void *params) { return (void)params, now->rows2; }
static int rest2(const void *params) { return (void)params, now->m2 - now->rows2; }
static size_t none(const void *params) { return (void)params, 0; }
static size_t frame(const void *params) { return (void)params, (size_t)now->frame; }
static size_t frame1(const void *params) { return (void)params, (size_t)now->frame1; }
static size_t frame2(const void *params) { return (void)params, (size_t)now->frame2; }
static int fits(const void *params) { return (void)params, 1; }

static void jet(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)cx, (void)out, (void)q, (void)qd, (void)t, (void)params;
}
#define NEVER_CALLED(type) ((type *)(void (*)(void))fits)

static void test_constants_are_what_a_system_takes(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    now = &cases[k];
    const eom_motion motion = {.n = now->n,
                               .m1 = now->m1,
                               .m2 = now->m2,
                               .fits = fits,
                               .work = now->work,
                               .constant_mass = now->constant_mass,
                               .energy = NEVER_CALLED(eom_energy_fn),
                               .simulate = NEVER_CALLED(eom_simulate_fn),
                               .residual = NEVER_CALLED(eom_residual_fn),
                               .linearise = NEVER_CALLED(eom_linearise_fn),
                               .tangent = NEVER_CALLED(eom_tangent_fn),
                               .parameters = NEVER_CALLED(eom_parameters_fn)};
    const eom_motion *const motions[] = {&motion};
    const eom_function holonomic[] = {{"phi", "", jet, rows1, frame1}, {"more", "", jet, rest1, none}};
    const eom_function nonholonomic[] = {{"psi", "", jet, rows2, frame2}, {"more", "", jet, rest2, none}};
    const eom_model model = {.name = "sizes",
                             .dof = dof,
                             .lagrangian = {"L", "", jet, one, frame},
                             .force = {"F", "", now->rows == now->n ? jet : NULL, most, none},
                             .holonomic = holonomic,
                             .nholonomic = now->m1 == 0            ? 0
                                           : now->m1 == now->rows1 ? 1
                                                                   : 2,
                             .nonholonomic = nonholonomic,
                             .nnonholonomic = now->m2 == 0            ? 0
                                              : now->m2 == now->rows2 ? 1
                                                                      : 2,
                             .motion = motions,
                             .nmotion = 1};
    eom_options options = eom_options_default();
    options.needs = now->needs;
    options.emitter = EOM_EMITTER_MOTION;
    const size_t bytes = eom_system_bytes(&model, NULL, &options);
    if (bytes != now->bytes) print_error("case %zu\n", k);
    assert_int_equal(bytes, now->bytes);

    tl_real weights[16];
    for (int i = 0; i < now->m1 + now->m2; i++) weights[i] = TL_C(1.0);
    if (now->m1 + now->m2 == 0 || options.needs & EOM_NEED_PARAMETERS) continue;
    options.weights = weights;
    options.baumgarte.alpha = TL_C(1.0);
    const size_t more = options.needs == EOM_NEED_LINEARISE ? EOM_SYSTEM_BYTES_MORE(now->n, now->m1, now->m2) : 0;
    if (more) assert_int_equal(eom_system_bytes(&model, NULL, &options), now->bytes + more);
  }
}

enum { SIX_BY_RK4 = EOM_INTEGRATOR_SIZE(4, 0, 6) };

static void test_a_constant_is_what_an_integrator_takes(void **state) {
  (void)state;
  assert_int_equal(eom_integrator_size(&eom_rk4, 6), SIX_BY_RK4);
  for (int dim = 1; dim < 10; dim++)
    assert_int_equal(eom_integrator_size(&eom_dp5, dim),
                     EOM_INTEGRATOR_SIZE((size_t)eom_dp5.stages, (size_t)eom_dp5.dense_stages, (size_t)dim));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_constants_are_what_a_system_takes),
                                     cmocka_unit_test(test_a_constant_is_what_an_integrator_takes)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
