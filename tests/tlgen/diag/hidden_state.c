/* State that a function keeps from call to call, behind pointers, in helpers and in threads. */
#include <stddef.h>
struct store { double *room; double factor; };
static double cache[4];
static const double table[2] = {1.0, 2.0};
static _Thread_local double mine;
static double *const fixed = cache;
static const double *changing = table;
static const struct store kept = {cache, 2.0}; /* expect: global-state */
static void remember(double x) { cache[1] = x; } /* expect: global-state */
static double recall(void) { return cache[1]; } /* expect: global-state */
static double counted(double x)
{
  static int calls; /* expect: global-state */
  return x * ++calls;
}
static double smoothed(double x)
{
  static double last[2] = {0.0, 0.0}; /* expect: global-state */
  last[0] = 0.5 * (last[0] + x);
  return last[0];
}
static double cached(double x)
{
  static const double *p = table; /* expect: global-state */
  return p[0] * x;
}
double L(const double *q)
{
  remember(q[0]);
  mine = q[0];                                  /* expect: global-state */
  fixed[0] = q[0];                              /* expect: global-state */
  kept.room[2] = q[0];
  double s = changing[0];                       /* expect: global-state */
  changing = q;                                 /* expect: global-state */
  return recall() + mine + s + kept.factor * counted(q[0]) + smoothed(q[0]) + cached(q[0]); /* expect: global-state */
}
