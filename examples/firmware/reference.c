/* Between the knots of the planned motion. */
#include "reference.h"

#include "controller.h"

/* The knot before a step, the last but one at the end, and the part of the way to the next: 0 to 1. */
static const reference_knot *knot_before(int step, tl_real *part) {
  int k = step / REFERENCE_KNOT_STEPS;
  if (k > REFERENCE_KNOTS - 2) k = REFERENCE_KNOTS - 2;
  *part = (tl_real)(step - REFERENCE_KNOT_STEPS * k) / (tl_real)REFERENCE_KNOT_STEPS;
  return reference_table + k;
}

/* With a, b coordinates, a', b' velocities and H the time between knots, at s of it: a + s (H a' + s (c + s d)),
 * c = 3 (b - a) - H (2 a' + b'), d = H (a' + b') - 2 (b - a). */
void reference_motion(int step, tl_real *y, tl_real *push) {
  const tl_real H = (tl_real)REFERENCE_KNOT_STEPS * CONTROL_PERIOD;
  tl_real s;
  const reference_knot *a = knot_before(step, &s), *b = a + 1;
  for (int i = 0; i < N; i++) {
    const tl_real way = (tl_real)b->y[i] - (tl_real)a->y[i], from = H * (tl_real)a->y[N + i], to = H * (tl_real)b->y[N + i];
    const tl_real c = 3 * way - 2 * from - to, d = from + to - 2 * way;
    y[i] = (tl_real)a->y[i] + s * (from + s * (c + s * d));
    y[N + i] = (from + s * (2 * c + s * (3 * d))) / H;
  }
  *push = (tl_real)a->push;
}

void reference_cost(int step, tl_real *X) {
  tl_real s;
  const reference_knot *a = knot_before(step, &s);
  for (int i = 0, k = 0; i < D; i++)
    for (int j = i; j < D; j++, k++) X[D * i + j] = X[D * j + i] = (tl_real)a->X[k] + s * ((tl_real)a[1].X[k] - (tl_real)a->X[k]);
}
