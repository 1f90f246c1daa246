/* Motions with a closed form, to test their coefficients in time: a coordinate x that moves freely, x = a + b t, in other coordinates. */
#ifndef MOTIONS_H
#define MOTIONS_H

/* Of one coordinate q each, with x = g(q): L = (g'(q) qd)^2 / 2. */
double exp_motion(const double *q, const double *qd);     /* x = exp q */
double log_motion(const double *q, const double *qd);     /* x = log(log q) */
double power_motion(const double *q, const double *qd);   /* x = q^2.5 */
double root_motion(const double *q, const double *qd);    /* x = q^1.5 */
double cube_motion(const double *q, const double *qd);    /* x = q^3 */
double tangent_motion(const double *q, const double *qd); /* x = tan q */
double arc_motion(const double *q, const double *qd);     /* x = exp(atan q) */
double sinh_motion(const double *q, const double *qd);    /* x = sinh q */
double cbrt_motion(const double *q, const double *qd);    /* x = q^(4/3) */

double forced_motion(const double *q, const double *qd, double t); /* qdd = cos t */
double polar_motion(const double *q, const double *qd);            /* a free point in radius and angle */
double polar_in_plane(const double *q, const double *qd);          /* the same from velocities along fixed axes */
double attracted(const double *q, const double *qd);               /* Kepler's problem */
double swing(const double *q, const double *qd);                   /* a pendulum, m = l = g = 1: through the lowest point with 2 rad/s it
                                                                      comes to rest upright: qd = 2/cosh t */
/* The same with x, y as coordinates, and its rod. */
double bob(const double *q, const double *qd);
double rod(const double *q);

#endif
