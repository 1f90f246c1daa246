/* Nested five-point central differences,
 *
 *     f'(x) = (f(x-2h) - 8 f(x-h) + 8 f(x+h) - f(x+2h))/(12h) + h^4 f'''''/30 + ..
 *
 * With h = 1e-5 and 113 bits, truncation is about 1e-20 of the fifth derivative and rounding in a third derivative about 1e-34/h^3. */
#include "reference.h"
#include "plain.h"

#include <assert.h>
#include <string.h>

enum { MAX_ROWS = 16, MAX_VARIABLES = 33, MAX_ORDER = 3 };

static const __float128 step = (__float128)1e-5;

static void difference(__float128 *out, int rows, int function, int n, __float128 *x, int order, const int *index) {
  static const struct {
    int shift, weight;
  } points[] = {{-2, 1}, {-1, -8}, {1, 8}, {2, -1}};

  if (order == 0) {
    __float128 copy[MAX_VARIABLES]; /* a model that writes to its arguments does no harm */
    memcpy(copy, x, (size_t)(2 * n + 1) * sizeof *x);
    quad_call(function, out, copy, copy + n, copy[2 * n]);
    return;
  }
  __float128 *xi = x + index[order - 1], centre = *xi, part[MAX_ROWS];
  for (int r = 0; r < rows; r++) out[r] = 0;
  for (size_t k = 0; k < sizeof points / sizeof *points; k++) {
    *xi = centre + points[k].shift * step;
    difference(part, rows, function, n, x, order - 1, index);
    for (int r = 0; r < rows; r++) out[r] += points[k].weight * part[r] / (12 * step);
  }
  *xi = centre;
}

void reference_derivative(double *out, int rows, int function, int n, const double *x, int order, const int *index) {
  __float128 quad_x[MAX_VARIABLES], quad_out[MAX_ROWS];
  assert(rows <= MAX_ROWS && 2 * n + 1 <= MAX_VARIABLES && order <= MAX_ORDER);
  for (int i = 0; i < 2 * n + 1; i++) quad_x[i] = (__float128)x[i];
  difference(quad_out, rows, function, n, quad_x, order, index);
  for (int r = 0; r < rows; r++) out[r] = (double)quad_out[r];
}
