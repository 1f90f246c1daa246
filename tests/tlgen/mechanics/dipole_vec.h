#ifndef DIPOLE_VEC_H
#define DIPOLE_VEC_H

typedef struct vec {
  double x, y, z;
} vec;

extern vec vec_plus(vec a, vec b);
extern vec vec_minus(vec a, vec b);
extern vec vec_times(double s, vec a);
extern vec vec_cross(vec a, vec b);
extern double vec_dot(vec a, vec b);
extern double vec_length(vec a);

#endif
