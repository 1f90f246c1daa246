/* An iron bob that swings on a long string above three magnets; q = (x, y), m. */
#ifndef MAGNETS_H
#define MAGNETS_H

double magnets_lagrangian(const double q[2], const double qd[2]);

/* Air drag, out in N. */
void magnets_drag(const double q[2], const double qd[2], double out[2]);

#endif
