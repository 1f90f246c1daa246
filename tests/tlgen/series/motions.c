/* Motions with a closed form: see motions.h. */
#include "motions.h"

#include <math.h>

static double half_square(double x) { return 0.5 * x * x; }

double exp_motion(const double *q, const double *qd) { return half_square(exp(q[0]) * qd[0]); }
double log_motion(const double *q, const double *qd) { return half_square(qd[0] / (q[0] * log(q[0]))); }
double power_motion(const double *q, const double *qd) { return half_square(2.5 * pow(q[0], 1.5) * qd[0]); }
double root_motion(const double *q, const double *qd) { return half_square(1.5 * sqrt(q[0]) * qd[0]); }
double cube_motion(const double *q, const double *qd) { return half_square(3.0 * pow(q[0], 2.0) * qd[0]); }
double tangent_motion(const double *q, const double *qd) { return half_square((1.0 + tan(q[0]) * tan(q[0])) * qd[0]); }
double arc_motion(const double *q, const double *qd) { return half_square(exp(atan(q[0])) / (1.0 + q[0] * q[0]) * qd[0]); }
double sinh_motion(const double *q, const double *qd) { return half_square(cosh(q[0]) * qd[0]); }
double cbrt_motion(const double *q, const double *qd) { return half_square(4.0 / 3.0 * cbrt(q[0]) * qd[0]); }

double forced_motion(const double *q, const double *qd, double t) { return half_square(qd[0]) + q[0] * cos(t); }
double polar_motion(const double *q, const double *qd) { return half_square(qd[0]) + half_square(q[0] * qd[1]); }
double polar_in_plane(const double *q, const double *qd) {
  const double vx = qd[0] * cos(q[1]) - q[0] * qd[1] * sin(q[1]), vy = qd[0] * sin(q[1]) + q[0] * qd[1] * cos(q[1]);
  return half_square(vx) + half_square(vy);
}
double attracted(const double *q, const double *qd) { return half_square(qd[0]) + half_square(qd[1]) + 1.0 / hypot(q[0], q[1]); }
double swing(const double *q, const double *qd) { return half_square(qd[0]) + cos(q[0]); }
double bob(const double *q, const double *qd) { return half_square(qd[0]) + half_square(qd[1]) - q[1]; }
double rod(const double *q) { return hypot(q[0], q[1]) - 1.0; }
