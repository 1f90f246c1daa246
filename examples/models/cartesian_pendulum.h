/* The planar N-pendulum in Cartesian coordinates: q = (x1, y1, .., xn, yn) of the masses, m; rods are constraints. */
#ifndef CARTESIAN_PENDULUM_H
#define CARTESIAN_PENDULUM_H

#define CARTESIAN_PENDULUM_MAX_LINKS 64

typedef struct cartesian_pendulum {
  int links;                                   /* 1..CARTESIAN_PENDULUM_MAX_LINKS */
  int coordinates;                             /* 2 links */
  double g;                                    /* m/s^2, along -y */
  double mass[CARTESIAN_PENDULUM_MAX_LINKS];   /* kg */
  double length[CARTESIAN_PENDULUM_MAX_LINKS]; /* m */
} cartesian_pendulum;

double cartesian_pendulum_lagrangian(const double *q, const double *qd, const cartesian_pendulum *p);

/* out[k] = squared length of rod k minus what it should be, m^2; one row per link. */
void cartesian_pendulum_rods(const double *q, const cartesian_pendulum *p, double *out);

#endif
