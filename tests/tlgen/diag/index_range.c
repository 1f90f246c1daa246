/* Constant indices that do not fit the coordinates or the results. */
/* tlgen: --lagrangian L --dof 2 --holonomic phi:2 */
double L(const double *q, const double qd[2])
{
  return qd[1] * qd[-1] + q[2]; /* expect: index-range */
}
enum { LAST = 2 };
void phi(const double *q, double *out) /* expect: row-unwritten */
{
  out[0] = q[0];
  out[LAST] = q[1]; /* expect: index-range */
}
