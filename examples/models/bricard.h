/* Bricard's mechanism (IFToMM problem A04): a closed chain of five uniform rods whose six revolute axes are at right angles. It moves although
 * counting joints says that it should not: one of its 24 constraint rows depends on the others, in every position.
 * q = (P1, P2, P3, P4, a1, a2, a3, a4): joints, m, and unit vectors along their axes; P0 and P5 and their axes are fixed to the ground. */
#ifndef BRICARD_H
#define BRICARD_H

enum { BRICARD_RODS = 5, BRICARD_COORDINATES = 24, BRICARD_CONSTRAINTS = 24 };

typedef struct bricard {
  double length, section; /* of each rod, m: side of its square section, 0 for a slender rod, whose axes then have no inertia */
  double mass, g;         /* kg; m/s^2, along -y */
} bricard;

/* Slender rods of 1 m and 1 kg; a start at rest along the edges of a cube. */
bricard bricard_parameters(void);
void bricard_start(double *q, double *qd);

double bricard_lagrangian(const double *q, const double *qd, const bricard *p);

/* For each rod in turn: its length, and that it and its two axes are at right angles; then the length of each moving axis. */
void bricard_joints(const double *q, const bricard *p, double *out);

#endif
