// Six-axis arm by Denavit and Hartenberg.
#pragma once
#include <stddef.h>

typedef struct { double m[4][4]; } mat4;
typedef struct { double x, y, z; } vec3;

typedef struct {
  double theta, d, a, alpha;  // offset of the angle, rad; m; m; rad
  double mass;                // kg
  vec3 com;                   // in the link's frame, m
  vec3 gyration;              // squared radii of gyration about the axes through the centre of mass, m^2
} dh_row;

double arm6_lagrangian(const double q[6], const double qd[6]);
