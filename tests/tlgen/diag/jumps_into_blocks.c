/* Jumps that enter a block, go backwards or go to an address. */
static double into_branch(double x)
{
  if (x > 0) goto inside; /* expect: goto */
  if (x < -5) {
  inside:
    x = 2 * x;
  }
  return x;
}
static double into_loop(double x)
{
  int i = 0;
  goto inside; /* expect: goto */
  while (i < 3) {
  inside:
    x *= 2;
    i++;
  }
  return x;
}
static double between_cases(int kind, double x)
{
  switch (kind) {
  case 1:
    if (x > 9) goto two; /* expect: goto */
    break;
  case 2: {
  two:
    x *= 3;
  }
  }
  return x;
}
static double backwards(double x)
{
again:
  x *= 0.5;
  if (x > 1) goto again; /* expect: goto */
  return x;
}
static double out_of_loop_backwards(double x)
{
  int i;
restart:
  for (i = 0; i < 4; i++) {
    x *= 0.5;
    if (x > 9) goto restart; /* expect: goto */
  }
  return x;
}
static double device(int n, double x)
{
  switch (n % 2) {
  case 0:
    do {
      x *= 2;
    case 1: /* expect: switch */
      x *= 3;
    } while (--n > 0);
  }
  return x;
}
static double without_block(int n, double x)
{
  switch (n) case 2: x *= 2; /* expect: switch */
  return x;
}
static double range(int n, double x)
{
  switch (n) {
  case 1 ... 3: /* expect: switch */
    x *= 2;
  }
  return x;
}
double L(const double *q)
{
  return into_branch(q[0]) + into_loop(q[0]) + between_cases(1, q[0]) + backwards(q[0]) +
         out_of_loop_backwards(q[0]) + device(3, q[0]) + without_block(2, q[0]) + range(2, q[0]);
}
