/* Derivatives by differences in quad precision: shares no code with the jets. */
#include "tlgen/selftest.h"

#include <string.h>

void tlgen_difference(__float128 *out, int rows, tlgen_quad_fn *f, int n, __float128 *x, void *params, const __float128 *step,
                      int order, const int *index, __float128 *scratch) {
  static const struct {
    int shift, weight;
  } points[] = {{-2, 1}, {-1, -8}, {1, 8}, {2, -1}};

  if (order == 0) { /* of a copy: a function that writes to its arguments does no harm; what it leaves unwritten is zero */
    memcpy(scratch, x, (size_t)(2 * n + 1) * sizeof *x);
    for (int r = 0; r < rows; r++) out[r] = 0;
    f(out, scratch, scratch + n, scratch[2 * n], params);
    return;
  }
  const int i = index[order - 1];
  const __float128 centre = x[i];
  __float128 *part = scratch;
  for (int r = 0; r < rows; r++) out[r] = 0;
  for (size_t k = 0; k < sizeof points / sizeof *points; k++) {
    x[i] = centre + points[k].shift * step[i];
    tlgen_difference(part, rows, f, n, x, params, step, order - 1, index, scratch + rows);
    for (int r = 0; r < rows; r++) out[r] += points[k].weight * part[r] / (12 * step[i]);
  }
  x[i] = centre;
}
