/* Comparisons for equality of values that depend on q: accepted with a warning each. */
double L(const double *q, const double *qd, double t)
{
  double s = q[0] == 0.0 ? 0.0 : q[0] * q[0]; /* warns: active-equality */
  if (qd[0] * t != 1.0) s += qd[0];           /* warns: active-equality */
  s += q[0] ? 1.0 : q[0];                     /* warns: active-equality */
  if (!qd[0] || t) s += 1.0;                  /* warns: active-equality */
  while (s) s = 0.0;                          /* warns: active-equality */
  return q[0] > 0.0 && t == 2 ? s : -s; /* warns: active-equality */
}
