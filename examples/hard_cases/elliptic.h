/* Jacobi's elliptic functions and the complete integral, by the arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6). */
#ifndef HARD_CASES_ELLIPTIC_H
#define HARD_CASES_ELLIPTIC_H

typedef struct elliptic {
  double am, sn, cn, dn;
} elliptic;

/* At u for the parameter m = k^2, 0 <= m < 1. */
elliptic elliptic_at(double u, double m);

/* K(m), a quarter of the period of sn. */
double elliptic_quarter(double m);

#endif
