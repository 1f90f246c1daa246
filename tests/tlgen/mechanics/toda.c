/* Periodic Toda lattice, every thought a function. */
#include <math.h>

enum { sites = 4 };

static inline double square(double x) { return x * x; }
static inline double half(double x) { return x / 2; }
static inline int successor(int i) { return (i + 1) % sites; }
static inline double stretch(const double *q, int i) { return q[successor(i)] - q[i]; }
static inline double toda(double r) { return exp(-r) + r - 1; }
static inline double site_energy(const double *qd, int i) { return half(square(qd[i])); }
static inline double bond_energy(const double *q, int i) { return toda(stretch(q, i)); }
static double kinetic_from(const double *qd, int i) { return i < sites ? site_energy(qd, i) + kinetic_from(qd, i + 1) : 0; }
static double potential_from(const double *q, int i) { return i < sites ? bond_energy(q, i) + potential_from(q, i + 1) : 0; }
double toda_lagrangian(const double *q, const double *qd) { return kinetic_from(qd, 0) - potential_from(q, 0); }
