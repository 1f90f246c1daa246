/* A definition without prototype, called with more than it takes. */
double three() { return 3.0; }
double L(const double *q) { return three(q[0]) * q[0]; } /* expect: unknown-function */
