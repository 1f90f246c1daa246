#include "no_such_header.h" /* expect: syntax */
double L(const double *q) { return q[0]; }
