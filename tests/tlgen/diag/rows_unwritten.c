/* tlgen: --lagrangian L --dof 2 --holonomic loop:3 --holonomic some:2 --holonomic any:2 --force push --nonholonomic none */
/* Rows that are never written. A force's are zero then. */
void L(const double *q, const double *qd, double *out) { out[0] = q[0] * qd[1]; }
void loop(const double *q, double *out) /* expect: row-unwritten */
{
  out[0] = q[0];
  out[2] = q[1];
}
static void set(double *row, double x) { *row = x; }
void some(const double *q, double *out)
{
  for (int i = 0; i < 2; i++) set(&out[i], q[i]);
}
void any(const double *q, double *out)
{
  if (q[0] > 0.0) out[0] = q[0];
  else out[0] = 0.0;
  if (q[1] > 0.0) out[1] = q[0];
}
void push(const double *q, double *out) { out[1] = q[0]; }
void none(const double *q, const double *qd, double *out) {} /* expect: row-unwritten */
