/* The functions of math.h for single precision, to the accuracy of the C library's. */
#include <math.h>

static float all(float x, float y)
{
  float s = cbrtf(3.0f + x) + expf(x) + expm1f(x) + exp2f(x) + logf(2.5f + x) + log1pf(0.5f * x) + log2f(3.0f + x) + log10f(4.0f - x);
  s += sinf(x) * cosf(2.0f * x) + tanf(x) + asinf(0.75f * x) + acosf(0.5f * x) + atanf(x) + sinhf(x) + coshf(x) * tanhf(x);
  s += asinhf(x) + acoshf(2.5f + x) + atanhf(0.75f * x) + erff(x) + erfcf(y) + atan2f(x, y) + hypotf(x, y) + powf(2.0f + x, y);
  s += copysignf(x, y) * x + fmaf(x, y, 0.5f) + powf(x, 3) + powf(2.0f + y, 1.5f) + fmodf(5.0f * x, 0.75f) + fdimf(x, y) * x;
  return s;
}

double lagrangian(const double *q, const double *qd, double t) { return all((float)q[0], (float)qd[1]) + all((float)(q[1] * t), qd[0]); }
