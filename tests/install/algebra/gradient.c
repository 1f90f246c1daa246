/* The gradient of x*sin(y) at (2, 0.5) from one evaluation in J(2); exits non-zero where it is wrong. */
#include <stdio.h>
#include <taylor/taylor.h>

int main(void) {
  const tl_real x = TL_C(2.0), y = TL_C(0.5), tolerance = 4 * TL_EPSILON;
  tl_shape shape;
  if (tl_shape_init(&shape, tl_jacobian(2), NULL, 0) != 0) return 1;
  tl_real memory[64], jx[3], f[3];
  tl_ctx cx;
  if (tl_ctx_size(&shape, 0) > 64) return 1;
  tl_ctx_init(&cx, &shape, memory, 64);
  tl_seed(&cx, jx, x, 0);
  tl_seed(&cx, f, y, 1);
  tl_sin(&cx, f, f);
  tl_mul(&cx, f, jx, f);
  printf("f = %.15g, df/dx = %.15g, df/dy = %.15g\n", (double)f[0], (double)f[1], (double)f[2]);
  const int right = TL_LIBM(fabs)(f[1] - TL_LIBM(sin)(y)) <= tolerance && TL_LIBM(fabs)(f[2] - x * TL_LIBM(cos)(y)) <= tolerance;
  return cx.status.bits == TL_OK && right ? 0 : 1;
}
