/* An orbit in the central field, integrated in the redundant coordinates (r, u), and what it should conserve. */
#ifndef CENTRAL_FIELD_ORBIT_H
#define CENTRAL_FIELD_ORBIT_H

#include "closed_form.h"

typedef struct orbit_request {
  kinetic kind;
  double eccentricity; /* 0 <= e < 1; semi-major axis 1 m, m = 1 kg, mu = 1 m^3/s^2 */
  double periods;      /* of 2 pi s */
  double step;         /* s; 0: a 400th of the time scale at the pericentre */
  const char *csv;     /* t,r,u1,u2,u3,phi,energy_error,momentum_error for every step; null for none */
} orbit_request;

/* Integrates from the pericentre, prints the largest |phi|, energy error and angular momentum error, and the distance from the start
 * where a whole number of periods has passed. Returns an exit status. */
int orbit(const orbit_request *ask);

#endif
