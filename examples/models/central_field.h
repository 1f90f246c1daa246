/* A particle in the central field V = -mu m / r, in the coordinates q = (r, u1, u2, u3): distance and direction, |u| = 1. */
#ifndef CENTRAL_FIELD_H
#define CENTRAL_FIELD_H

struct central_field {
  double m;  /* mass, kg */
  double mu; /* field strength, m^3/s^2 */
};

/* L = T - V in J with T = m/2 |d(r u)/dt|^2 as it stands. Its mass matrix is singular: r u moves the same way for a change of r and a
 * change of u along itself, and only the constraint tells the two apart. q = (r, u), m and 1; qd: rates. */
double central_field_lagrangian(const double *q, const double *qd, const struct central_field *p);

/* The same with T = m/2 (rd^2 + r^2 |ud|^2), to which it reduces where |u| = 1 and u.ud = 0. Its mass matrix is diagonal. */
double central_field_reduced_lagrangian(const double *q, const double *qd, const struct central_field *p);

/* |u|^2 - 1 = 0. */
double central_field_unit(const double *q);

#endif
