static double odd(double x, int n);
static double even(double x, int n) { return n ? x * odd(x, n - 1) : 1.0; } /* expect: recursion */
static double odd(double x, int n) { return n ? even(x, n - 1) : x; }
static double power(double x, int n) { return n ? x * power(x, n - 1) : 1.0; } /* expect: recursion */
double L(const double *q) { return even(q[0], 4) + power(q[0], 3); }
