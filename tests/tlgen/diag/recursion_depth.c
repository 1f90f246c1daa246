/* A recursion whose depth is no count. */
/* tlgen: --lagrangian L --dof 1 --recursion down:deep */ /* expect without a line: bad-depth */
static double down(int n, double x) { return n ? x * down(n - 1, x) : 1; }
double L(const double *q) { return down(3, q[0]); }
