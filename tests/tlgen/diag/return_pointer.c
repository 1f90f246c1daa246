static const double *pick(const double *a, int i) { return a + i; } /* expect: return-pointer */
double L(const double *q) { return pick(q, 0)[0]; }
