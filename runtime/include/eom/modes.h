/* Modes of a linear model: eigenvalues, frequencies, damping ratios and shapes in the user's coordinates. A build without LAPACK
 * (TAYLOR_HOST off) leaves these functions out. */
#ifndef EOM_MODES_H
#define EOM_MODES_H

#include "eom/minimal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Motions along a mode are Re(c e^(st) shape), s = re + i im. */
typedef struct eom_mode {
  tl_real re, im;    /* eigenvalue s, 1/s */
  tl_real frequency; /* |im|/(2 pi), Hz */
  tl_real damping;   /* damping ratio -re/|s|; 0 where s = 0 */
  tl_real condition; /* of s: a change of the balanced matrix moves s by at most this times its norm, at first order; 1 is best, and a
                        double eigenvalue without two shapes has an infinite one */
} eom_mode;

/* Numbers of workspace for modes of a d x d matrix. */
size_t eom_modes_work(int d);

/* The modes of z' = F z, in ascending order of |im|, then of re; of a conjugate pair the one with im > 0 first. Where those differ by
 * rounding only, any order.
 *   F        d x d, not modified
 *   modes    d
 *   shapes   null, or d x 2 x d: for each mode the d real parts of its eigenvector, then the d imaginary parts, scaled so that the
 *            number of largest modulus, the first among equals, is 1
 *   work     eom_modes_work(d)
 * NOT_FINITE for an F that is not; NO_EIGENVALUES where LAPACK's iteration fails. */
eom_status eom_modes(eom_mode *modes, tl_real *shapes, int d, const tl_real *F, tl_real *work);

/* The modes of a linear model in minimal coordinates with shapes in the user's: Z v, v the eigenvectors of minimal->F.
 *   modes    minimal->d
 *   shapes   minimal->d x 2 x 2n: for each mode the real parts of the changes of (q,qd), then the imaginary parts, scaled so that the
 *            change of a coordinate (not a velocity) of largest modulus, the first among equals, is 1
 *   work     eom_modes_work(2n)
 * Errors as eom_modes. */
eom_status eom_minimal_modes(eom_mode *modes, tl_real *shapes, const eom_minimal *minimal, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
