/* slider_crank.f -- translated by f2c (version 20100827), option -a. */

#include <math.h>

typedef int integer;
typedef double doublereal;

/* Table of constant values */

static const doublereal c_b2 = 2.;
static const doublereal c_g = 9.81;

/* ***  KINEMATICS OF PISTON: POSITION X AND ITS DERIVATIVE BY CRANK ANGLE */
static int piston_(const doublereal *th, const doublereal *r__, const doublereal *rl, const doublereal *off, doublereal *x, doublereal *dx)
{
    /* System generated locals */
    doublereal d__1;

    /* Local variables */
    doublereal s, root;

    s = *r__ * sin(*th) - *off;
    d__1 = *rl;
    root = sqrt(d__1 * d__1 - s * s);
    *x = *r__ * cos(*th) + root;
    *dx = -(*r__) * sin(*th) - s * *r__ * cos(*th) / root;
    return 0;
} /* piston_ */

doublereal slcrnk_(doublereal *q, doublereal *qd)
{
    /* System generated locals */
    integer i__1;
    doublereal ret_val, d__1, d__2;

    /* Local variables */
    integer i__;
    doublereal r__, t, v, x, dx, ph, rl, off, phd, amass[3], yc, vxc, vyc;

    /* Parameter adjustments */
    --qd;
    --q;

    /* Function Body */
    r__ = .045;
    rl = .14;
    off = .004;
    amass[0] = .9;
    amass[1] = .55;
    amass[2] = .48;
    ret_val = 0.;
    if (r__ >= rl) {
	goto L900;
    }
    piston_(&q[1], &r__, &rl, &off, &x, &dx);
    v = dx * qd[1];
/*     CONNECTING ROD: ANGLE AND RATE */
    d__1 = (r__ * sin(q[1]) - off) / rl;
    ph = asin(d__1);
    phd = r__ * cos(q[1]) * qd[1] / (rl * cos(ph));
    yc = r__ * sin(q[1]) - rl * .3 * sin(ph);
    vxc = -r__ * sin(q[1]) * qd[1] - rl * .3 * sin(ph) * phd;
    vyc = r__ * cos(q[1]) * qd[1] - rl * .3 * cos(ph) * phd;
    t = 0.;
    i__1 = 3;
    for (i__ = 1; i__ <= i__1; ++i__) {
	switch (i__) {
	    case 1:  goto L10;
	    case 2:  goto L20;
	    case 3:  goto L30;
	}
L10:
/*        CRANK */
	d__1 = qd[1];
	t += amass[i__ - 1] * 4e-4 * (d__1 * d__1);
	goto L100;
L20:
/*        ROD */
	t += (amass[i__ - 1] * (pow(vxc, c_b2) + pow(vyc, c_b2)) + phd * .0011 * phd) / 2.;
	goto L100;
L30:
/*        PISTON */
/* Computing 2nd power */
	d__2 = v;
	t += amass[i__ - 1] * (d__2 * d__2) / 2.;
L100:
	;
    }
    ret_val = t - c_g * (amass[1] * yc + amass[2] * off);
L900:
    return ret_val;
} /* slcrnk_ */

int gasfrc_(doublereal *q, doublereal *qd, doublereal *out)
{
    /* Initialized data */
    static const doublereal coef[4] = { 3.2e3,1.1e3,-450.,90. };

    /* Local variables */
    integer k;
    doublereal x, dx, gas, r__ = .045, rl = .14, off = .004;

    /* Parameter adjustments */
    --out;
    --qd;
    --q;

    /* Function Body */
    piston_(&q[1], &r__, &rl, &off, &x, &dx);
    gas = 0.;
    for (k = 4; k >= 1; --k) {
	gas = gas * (x - .14) * 10. + coef[k - 1];
    }
    out[1] = -gas * dx - qd[1] * .02;
    return 0;
} /* gasfrc_ */
