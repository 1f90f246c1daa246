/* Functions that call themselves and each other, to a depth that the options state. */
#include <math.h>

struct tree {
  int depth;
  double ratio;
};

static const struct tree params = {4, 0.6};

static double branch(int level, double angle, const struct tree *p) {
  double left, right;
  if (level == 0) return cos(angle);
  left = branch(level - 1, angle * p->ratio, p);
  right = branch(level - 1, angle + 0.3 * left, p);
  return left * right + sin(angle);
}

static double odd(int n, double x);
static double even(int n, double x) { return n == 0 ? 1 : x * odd(n - 1, x); }
static double odd(int n, double x) { return n == 0 ? 0 : x + even(n - 1, x * x); }

double lagrangian(const double *q, const double *qd, const struct tree *p) {
  return 0.5 * qd[0] * qd[0] * branch(p->depth, q[0], p) + even(5, q[1]) - branch(2, 0.5, p) * qd[1] * qd[1];
}
