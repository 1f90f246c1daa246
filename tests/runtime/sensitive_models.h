/* Models for sensitivities; tests/data/sensitivity.py has their equations of motion by hand. */
#ifndef SENSITIVE_MODELS_H
#define SENSITIVE_MODELS_H

typedef struct chain { /* two masses on rods; q: angles from the downward vertical, rad */
  double mass[2];      /* kg */
  double length[2];    /* m */
  double gravity;      /* m/s^2 */
} chain;

typedef struct planet { /* of unit mass about a fixed sun; q = (x, y), m */
  double attraction;    /* m^3/s^2 */
} planet;

typedef struct rod { /* a mass on a rod; q = (x, y), m, y points up */
  double mass;       /* kg */
  double length;     /* m */
  double gravity;    /* m/s^2 */
} rod;

double chain_lagrangian(const double *q, const double *qd, const chain *p);
double planet_lagrangian(const double *q, const double *qd, const planet *p);
double rod_lagrangian(const double *q, const double *qd, const rod *p);
double rod_circle(const double *q, const rod *p);

#endif
