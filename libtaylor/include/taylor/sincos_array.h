/* Sines and cosines of several numbers at once. */
#ifndef TAYLOR_SINCOS_ARRAY_H
#define TAYLOR_SINCOS_ARRAY_H

#include "taylor/kernel.h"

/* s[i] = sin x[i], c[i] = cos x[i] for i < n, each within 1.5 ulp; where x[i] is infinite or no number, neither is the result. s and c
 * may be x, not each other. A number's result does not depend on its place in the array, nor on the others. */
TL_INLINE void tl_sincos_array(int n, const tl_real *x, tl_real *s, tl_real *c) {
  for (int i = 0; i < n; i++) {
    const tl_real xi = x[i];
    s[i] = TL_LIBM(sin)(xi);
    c[i] = TL_LIBM(cos)(xi);
  }
}

#endif
