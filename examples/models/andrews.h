/* Andrews' squeezing mechanism: seven bodies in a plane, driven by a constant torque. Names and values are those of the Test Set for
 * IVP Solvers (W. Schiehlen, Multibody Systems Handbook, 1990; E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, VII.7).
 * q = (beta, theta, gamma, phi, delta, omega, epsilon), rad; no gravity. */
#ifndef ANDREWS_H
#define ANDREWS_H

enum { ANDREWS_COORDINATES = 7, ANDREWS_LOOPS = 6 };

typedef struct andrews {
  double m1, m2, m3, m4, m5, m6, m7;                                             /* kg */
  double i1, i2, i3, i4, i5, i6, i7;                                             /* about centres of mass, kg m^2 */
  double xa, ya, xb, yb, xc, yc;                                                 /* fixed points, m */
  double d, da, e, ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, u, ua, ub, zf, zt, fa; /* lengths, m */
  double c0, l0;                                                                 /* spring, N/m and m */
  double mom;                                                                    /* torque on beta, N m */
} andrews;

/* The values of the Test Set, and a start at rest. */
andrews andrews_parameters(void);
void andrews_start(double *q, double *qd);

double andrews_lagrangian(const double *q, const double *qd, const andrews *p);

/* out[i]: generalized force on coordinate i, N m. */
void andrews_torque(const andrews *p, double *out);

/* Three ways to the point that all loops share, by x and y: out[0..5], m. */
void andrews_loops(const double *q, const andrews *p, double *out);

#endif
