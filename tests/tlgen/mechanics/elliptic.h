/* Complete elliptic integrals of the parameter m = k^2, 0 < m < 1, as a numerical library has them. */
#ifndef ELLIPTIC_H
#define ELLIPTIC_H

double ellint_K(double m);
double ellint_E(double m);

#endif
