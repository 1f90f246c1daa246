#include "dipole_vec.h"
#include <math.h>

vec vec_plus(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
vec vec_times(double s, vec a) { return (vec){s * a.x, s * a.y, s * a.z}; }
vec vec_minus(vec a, vec b) { return vec_plus(a, vec_times(-1, b)); }
vec vec_cross(vec a, vec b) { return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double vec_dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double vec_length(vec a) { return sqrt(vec_dot(a, a)); }
