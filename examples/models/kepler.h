/* A planet of unit mass about a fixed sun, planar Cartesian coordinates, gravitational parameter 1. */
#ifndef KEPLER_H
#define KEPLER_H

double kepler_lagrangian(const double q[2], const double qd[2]);

#endif
