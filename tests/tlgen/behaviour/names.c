/* Names that the generated code might want for itself. */
#include <math.h>

struct params { double cx, nc, frame, tmp0; int result; };
static const struct params params = {0.5, 1.5, 2.5, -0.5, 3};

static const double tl_table[] = {1.0, 2.0, 0.5};
static const double nc = 0.75, frame = 1.25, tmp1 = -0.25, k_ = 0.5;

static double tl_sin(double tl_x) { return sin(tl_x) * tl_table[1]; }
static double tmp0(double result) { return result * result; }
static double names_dof(double x) { return x + 0.5; }
static double f(double x) { return 2.0 * x; }
static double f_tl(double x) { return 3.0 * x; }
static double f_tl2(double x) { return 5.0 * x; }
static double cx(double nc, double frame)
{
  double tmp0 = nc * frame, tmp1 = tmp0 + nc;
  nc += tmp1;
  return tmp0 * nc;
}

static double underscores(double x, double x_, double cx_, double frame_)
{
  double s = x * x_;
  {
    double cx = 2.0 * cx_, frame = frame_ + x;
    s += cx * cx_ + frame * frame_;
    for (int k_ = 0; k_ < 2; k_++) {
      double result = cx * k_, result_ = frame;
      s += result * result_ + cx_;
    }
  }
  return s;
}

struct pair { double a, b; };

static double copies(double x, double y)
{
  struct pair p[3] = {{x, y}, {y, 2.0}, {x, x}}, one;
  double s = 0.0, x_in = 2.0;
  x *= 2.0;
  for (int k_ = 0; k_ < 3; k_++) {
    one = p[k_];
    p[2 - k_] = one;
    s += one.a * one.b * (k_ + 1);
  }
  { double x_in = s; s += x_in * x; }
  return s + x_in * x;
}

static double generated(double x, double y)
{
  int test0_ = 1, again0_ = 2, keep0_ = 3;
  double choice0_ = 0.5, place0_ = y, copy0_ = x, s = 0.0;
  if (x > 0.0 && tmp0(y) > 0.25 && test0_) s += again0_ * x;
  for (double z = x; tmp0(z) < 4.0; z += 1.0) s += keep0_ * z * again0_ + test0_;
  s += x > 0.0 || f(y) > 0.0 ? choice0_ * f(x) : copy0_;
  return s + (f(place0_) > 0.5 ? 1.0 : 2.0) * y;
}

double lagrangian(const double *q, const double *qd, double t, const struct params *params)
{
  double params_ = q[0] * params->cx, x = qd[0];
  double y0 = t, gamma = q[1], index = 0.5 * x, j1 = qd[1];
  double NULL_ = 1.0, out = q[1], shape = t, ncoef = 2.0;
  double L = params->nc * params_ + params->frame * y0 + params->tmp0 * gamma + params->result * index * j1;
  L += tl_sin(x) + tmp0(y0) + tmp0(3.0) + cx(q[0], q[1]) + cx(1.0, 2.0) * t + names_dof(x) + names_dof(1.0);
  L += underscores(q[0], q[1], t, x) + copies(q[0], t) + generated(q[0], q[1]) + generated(t, 0.5);
  L += f(x) * f(2.0) + f_tl(3.0) * x + f_tl(t) + f_tl2(2.0) * t + f_tl2(x);
  return L + out * shape * ncoef * NULL_ + nc * q[0] + frame * q[1] + tmp1 * t + k_ * x;
}
