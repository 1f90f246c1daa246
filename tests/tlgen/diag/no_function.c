/* expect without a line: no-function */
double K(const double *q) { return q[0]; }
