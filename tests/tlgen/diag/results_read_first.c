/* A result that is added to before it has a value. */
void L(const double *q, double *out)
{
  out[0] += q[0]; /* expect: uninitialized */
}
