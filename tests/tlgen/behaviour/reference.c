/* The differences of the test programs that tlgen prints, on functions by number. h = 1e-5: truncation is about 1e-20 of the fifth
 * derivative, rounding in a third derivative about 1e-34/h^3. */
#include "reference.h"
#include "plain.h"

#include "tlgen/selftest.h"

#include <assert.h>

enum { MAX_ROWS = 16, MAX_VARIABLES = 33, MAX_ORDER = 3 };

static void call(__float128 *out, __float128 *q, __float128 *qd, __float128 t, void *function) {
  quad_call(*(const int *)function, out, q, qd, t);
}

void reference_derivative(double *out, int rows, int function, int n, const double *x, int order, const int *index) {
  __float128 quad_x[MAX_VARIABLES], step[MAX_VARIABLES], quad_out[MAX_ROWS], scratch[4 * MAX_ROWS + MAX_VARIABLES];
  assert(rows <= MAX_ROWS && 2 * n + 1 <= MAX_VARIABLES && order <= MAX_ORDER);
  for (int i = 0; i < 2 * n + 1; i++) {
    quad_x[i] = (__float128)x[i];
    step[i] = (__float128)1e-5;
  }
  tlgen_difference(quad_out, rows, call, n, quad_x, &function, step, order, index, scratch);
  for (int r = 0; r < rows; r++) out[r] = (double)quad_out[r];
}
