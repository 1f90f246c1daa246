/* A crank that turns at a given rate pushes a sliding block by an elastic connecting rod: the slider crank of the Test Set for IVP
 * Solvers (B. Simeon, Modelling a flexible slider crank mechanism by a mixed system of DAEs and PDEs, Math. Modelling of Systems 2,
 * 1996), with linear stiffness and without damping. q = (phi1, phi2, x3, q1, q2, q3, q4): angles of crank and rod, rad; place of the
 * block, m; deformation of the rod, m: two sines across (q1, q2), middle and end along (q3, q4). No gravity. */
#ifndef ELASTIC_CRANK_H
#define ELASTIC_CRANK_H

enum { ELASTIC_CRANK_COORDINATES = 7, ELASTIC_CRANK_LOOPS = 3 };

typedef struct elastic_crank {
  double m2, m3;           /* rod and block, kg */
  double j1, j2;           /* crank and rod about their ends, kg m^2 */
  double l1, l2;           /* crank and rod, m */
  double width, height;    /* of the rod's section, m */
  double density, modulus; /* of the rod, kg/m^3 and N/m^2 */
  double pi;               /* as the Test Set rounds it */
  double omega;            /* rate of the crank, rad/s */
} elastic_crank;

/* The values of the Test Set, and its start close to the smooth motion. */
elastic_crank elastic_crank_parameters(void);
void elastic_crank_start(double *q, double *qd);

double elastic_crank_lagrangian(const double *q, const double *qd, const elastic_crank *p);

/* The end of the rod on the slide, the block at the end of the rod, the crank at omega t: out[0..2], m, m, rad. */
void elastic_crank_loops(const double *q, double t, const elastic_crank *p, double *out);

#endif
