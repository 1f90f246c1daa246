/* The source in double beside the source in quad precision. */
#include "rounding.h"
#include "path.h"

#include <math.h>
#include <string.h>

typedef void rounded_fn(double *out, double *q, double *qd, double t, void *params);

enum { MAX_ROWS = 8, MAX_X = 2 * MAX_ROWS + 1 };

static tlgen_selftest rounded; /* its functions are of the type rounded_fn */

int fuzz_keep_rounded(int argc, char **argv, const tlgen_selftest *test) {
  (void)argc, (void)argv;
  rounded = *test;
  return 0;
}

/* Function number f of the model: whether it is further from itself than that. */
static bool is_far(const fuzz_model *m, int f, int rows, const double *state, double limit) {
  const int n = m->sizes.n;
  double x[MAX_X], value[MAX_ROWS] = {0};
  __float128 quad_x[MAX_X], quad_value[MAX_ROWS] = {0};
  memcpy(x, state, (size_t)(2 * n + 1) * sizeof *x);
  for (int i = 0; i < 2 * n + 1; i++) quad_x[i] = (__float128)x[i];
  m->test->functions[f](quad_value, quad_x, quad_x + n, quad_x[2 * n], m->quad_params);
  ((rounded_fn *)(void (*)(void))rounded.functions[f])(value, x, x + n, x[2 * n], (void *)(size_t)m->params);
  for (int i = 0; i < rows; i++)
    if (!(fabs(value[i] - (double)quad_value[i]) <= limit)) return true;
  return false;
}

static bool any_is_far(const fuzz_model *m, const fuzz_point *p, double tolerance, const double *scale) {
  const eom_model *model = m->test->model;
  int f = 0;
  bool far = is_far(m, f++, 1, p->x, tolerance * scale[FUZZ_LAGRANGIAN]);
  if (model->force.jet) far = is_far(m, f++, m->sizes.n, p->x, tolerance * scale[FUZZ_FORCE]) || far;
  for (int k = 0; k < model->nholonomic; k++)
    far = is_far(m, f++, model->holonomic[k].rows(m->params), p->x, tolerance * scale[FUZZ_PHI]) || far;
  for (int k = 0; k < model->nnonholonomic; k++)
    far = is_far(m, f++, model->nonholonomic[k].rows(m->params), p->x, tolerance * scale[FUZZ_PSI]) || far;
  return far;
}

bool rounding_prevails(const fuzz_model *m, const fuzz_point *p, double tolerance, const double scale[FUZZ_GROUP_COUNT]) {
  jmp_buf give_up;
  volatile bool prevails = true; /* where a loop does not end */
  if (setjmp(give_up) == 0) {
    path_start(&give_up);
    prevails = any_is_far(m, p, tolerance, scale);
  }
  path_stop();
  return prevails;
}
