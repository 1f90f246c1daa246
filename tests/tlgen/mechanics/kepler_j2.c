/* kepler_j2.f -- translated by f2c (version 20100827). */

#include <math.h>

typedef int integer;
typedef double doublereal;

/* Orbit about an oblate planet, cartesian. Returns the Lagrangian per unit mass in ret_val. */

/* Subroutine */ int geopot_(const doublereal *x, const doublereal *gm, const doublereal *re, const doublereal *cj2, doublereal *u)
{
    /* System generated locals */
    doublereal d__1, d__2, d__3;

    /* Local variables */
    integer i__;
    doublereal r2, r__, rho, slat2;

    /* Parameter adjustments */
    --x;

    /* Function Body */
    r2 = 0.;
    for (i__ = 1; i__ <= 3; ++i__) {
/* Computing 2nd power */
	d__1 = x[i__];
	r2 += d__1 * d__1;
/* L10: */
    }
    r__ = sqrt(r2);
    *u = *gm / r__;
    if (*cj2 == 0.) {
	goto L20;
    }
/* Computing 2nd power */
    d__2 = x[3] / r__;
    slat2 = d__2 * d__2;
    rho = *re / r__;
/* Computing 2nd power */
    d__3 = rho;
    *u -= *gm / r__ * *cj2 * (d__3 * d__3) * (slat2 * 3. - 1.) * .5;
L20:
    return 0;
} /* geopot_ */

doublereal xlagr_(const doublereal *x, const doublereal *xd)
{
    /* Initialized data */

    static const doublereal gm = 4.;
    static const doublereal re = .7;
    static const doublereal cj2 = .03;

    /* System generated locals */
    doublereal ret_val, d__1, d__2, d__3;

    /* Local variables */
    doublereal u;

    /* Parameter adjustments */
    --xd;
    --x;

    /* Function Body */
    geopot_(&x[1], &gm, &re, &cj2, &u);
/* Computing 2nd power */
    d__1 = xd[1];
/* Computing 2nd power */
    d__2 = xd[2];
/* Computing 2nd power */
    d__3 = xd[3];
    ret_val = (d__1 * d__1 + d__2 * d__2 + d__3 * d__3) * .5 + u;
    return ret_val;
} /* xlagr_ */
