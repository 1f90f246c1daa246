double L(const double *q) { return q[0] +; } /* expect: syntax */
double K(const double *q) { return x; }      /* expect: syntax */
