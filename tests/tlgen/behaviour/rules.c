/* External functions whose derivatives come from rules of the user's: with one argument and with two, by option and by mark. */
#include "rules.h"

#include <math.h>

static double drag(double v) { return v * rules_bump(v); }

double lagrangian(const double *q, const double *qd, double t)
{
  double s = 0.0;
  for (int i = 0; i < 2; i++) s += rules_bump(q[i]) * qd[i] + rules_bump(0.25) * q[i];
  return s + drag(qd[0]) + rules_saddle(q[0], sin(qd[1])) + rules_saddle(q[1], 0.5) * t + rules_saddle(0.5, 0.25);
}
