/* A literal beyond the largest double. */
double L(const double *q) { return q[0] < 1e999 ? q[0] : 0; } /* expect: not-finite */
