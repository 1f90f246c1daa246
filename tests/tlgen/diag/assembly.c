/* Assembly in the function, with and without operands, and a function that is only a name of the assembler. */
extern double other(double x) __asm__("sin");
static double scaled(double x)
{
  __asm__ volatile("" : "+x"(x)); /* expect: asm */
  return x;
}
static double fenced(double x)
{
  __asm__ volatile("" ::: "memory"); /* expect: asm */
  return x;
}
static double jumped(double x)
{
  __asm__ goto("" :::: out); /* expect: asm */
  x *= 2;
out:
  return x;
}
double L(const double *q) { return scaled(q[0]) + fenced(q[0]) + jumped(q[0]) + other(q[0]); } /* expect: unknown-function */
