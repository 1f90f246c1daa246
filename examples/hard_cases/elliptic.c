/* Jacobi's elliptic functions and the complete integral, by the arithmetic-geometric mean (Abramowitz and Stegun 16.4, 17.6). */
#include "elliptic.h"

#include <float.h>
#include <math.h>

enum { MOST = 32 }; /* the mean converges quadratically: fewer than ten steps are taken */

/* a_i and c_i of the mean from a_0 = 1, b_0 = sqrt(1 - m), c_0 = sqrt(m). Returns the number of the last. */
static int descend(double m, double *a, double *c) {
  double b = sqrt(1.0 - m);
  int n = 0;
  a[0] = 1.0, c[0] = sqrt(m);
  while (n + 1 < MOST && c[n] > DBL_EPSILON * a[n]) {
    a[n + 1] = 0.5 * (a[n] + b), c[n + 1] = 0.5 * (a[n] - b);
    b = sqrt(a[n] * b);
    n++;
  }
  return n;
}

double elliptic_quarter(double m) {
  double a[MOST], c[MOST];
  const int n = descend(m, a, c);
  return acos(0.0) / a[n];
}

/* phi_n = 2^n a_n u, then sin(2 phi_(i-1) - phi_i) = c_i/a_i sin phi_i down to am = phi_0. */
elliptic elliptic_at(double u, double m) {
  double a[MOST], c[MOST];
  const int n = descend(m, a, c);
  double phi = ldexp(a[n] * u, n);
  for (int i = n; i > 0; i--) phi = 0.5 * (phi + asin(c[i] / a[i] * sin(phi)));
  const double sn = sin(phi);
  return (elliptic){.am = phi, .sn = sn, .cn = cos(phi), .dn = sqrt(1.0 - m * sn * sn)};
}
