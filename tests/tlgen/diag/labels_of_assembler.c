/* A name of math.h that is another function for the assembler. */
double sin(double x) __asm__("cos");
static double helper(double x) __asm__("tan");
static double helper(double x) { return x * x; }
double L(const double *q) { return helper(q[0]) + sin(q[0]); } /* expect: unknown-function */
