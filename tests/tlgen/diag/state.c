/* Variables that outlive the call. */
static double last;
static int calls = 0;
extern const double gravity;
const double *table;
double L(const double *q)
{
  static double sum = 0.0;      /* expect: global-state */
  static const double g = 9.81;
  calls++;                      /* expect: global-state */
  sum += q[0] - last;           /* expect: global-state */
  last = q[0];                  /* expect: global-state */
  sum += table[0];              /* expect: global-state */
  return sum + gravity + g;     /* expect: global-state */
}
