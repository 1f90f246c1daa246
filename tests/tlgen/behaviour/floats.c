/* Single precision: every operation rounds as C says, beside doubles, in arrays, structs, helpers and tables; derivatives by the unrounded rules. */
#include <math.h>

typedef struct { float x, y; double z; int n; } mixed;
static const float gains[3] = {0.1f, 0.7f, 1.3f};

static float horner(const float *c, int n, float x)
{
  float y = 0.0f;
  while (n-- > 0) y = y * x + c[n];
  return y;
}

static float accumulate(float *a, int n)
{
  float s = 0;
  for (int i = 0; i < n; i++) s += a[i] * a[i], a[i] *= 0.1f;
  return s;
}

static double widen(float a, double b) { return a * b + a / 3.0f; }

static mixed half(mixed m)
{
  m.x /= 3.0f;
  m.y = (float)m.z;
  m.z -= m.x;
  m.n++;
  return m;
}

double lagrangian(const double *q, const double *qd, double t)
{
  float x = (float)q[0], y = q[1], v[2] = {(float)qd[0], (float)(qd[1] * 0.3)}, s = -x;
  mixed m = half((mixed){x, y, q[0] * 0.7, 2});
  double third = 1.0f / 3.0f;
  s += v[0] * y - x / (y + 3.0f) + (float)t;
  s *= 1.1;
  s = s - 0.1f * third;
  s++;
  float e = accumulate(v, 2), r = sqrtf(x * x + y * y + 1.0f), a = fabsf(v[0]) + fminf(x, y) + fmaxf(x, 0.25f);
  float c = cos(x) * exp(y), u = x > y ? x : y;
  if (x * 0.1f > 0.2 * y) u += 0.5f * x;
  return s * horner(gains, 3, x) + widen(y, q[0]) + widen(0.3f, q[1]) + e * v[1] + r * a + c * u + m.x * m.y + m.z * m.n + floorf(5.0f * x) * y + ldexpf(x, 2);
}
