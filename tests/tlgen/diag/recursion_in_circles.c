/* Functions that call each other in circles, one of them through a third. */
static double odd(double x, int n);
static double even(double x, int n) { return n ? odd(x, n - 1) : x; } /* expect: recursion */
static double odd(double x, int n) { return n ? even(x, n - 1) : -x; }
static double c(double x);
static double b(double x) { return c(x); }
static double a(double x) { return x > 1 ? b(x - 1) : x; } /* expect: recursion */
static double c(double x) { return a(x) + 1; }
static double endless(double x) { return endless(x + 1); } /* expect: recursion */
double L(const double *q) { return even(q[0], 4) + a(q[0]) + endless(q[0]); }
