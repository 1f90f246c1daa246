/* The other file of several_files.c. */
int helper(int x) { return x + 1; }
static double own(double x) { return 4.0 * x; }
double stretch(double x) { return own(x); } /* expect: defined-twice */
double shape(double x) { return x * x; }
