/* Integers beside jets: unsigned and small types, wrap-around, shifts, bits, division, casts, character and boolean arithmetic. */
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

static double at(const double *a, size_t i) { return a[i]; }
static double minus(const double *a, unsigned char i) { return a[-(int)i]; }
static bool odd(unsigned n) { return n & 1u; }

double lagrangian(const double *q, const double *qd, double t)
{
  double L = 0.0, a[6] = {q[0], q[1], qd[0], qd[1], t, 1.0};
  unsigned n = 6, mask = 0x2au;
  unsigned char small = 250;
  short s = -3;
  long long big = 1LL << 40;
  size_t size = sizeof a / sizeof a[0];
  uint32_t wrap = 5u - 6u;
  bool flag = q[0] > 0.0, both = flag && q[1] < 0.5;
  int d = -7 / 2, r = -7 % 3, m = INT_MAX;

  for (unsigned i = n; i-- > 0;) L += a[i] * (i + 1) * ((mask >> i) & 1u ? 2.0 : 1.0);
  for (size_t i = 0; i < size; ++i) L += at(a, i) * at(a, size - 1 - i);
  for (signed char c = 5; c >= 0; c--) L += a[c] * c;
  small += 10;
  small = (unsigned char)(small * 3);
  s = (short)(s * 2 - small);
  L += small * q[0] + s * t + minus(a + 3, 2) + (double)(big >> 38) * q[1];
  L += (wrap > 10u ? 1.0 : -1.0) * t + (double)(unsigned char)300 * q[0] + (double)((unsigned)-1 > 0 ? 3 : 4) * q[1];
  L += (double)((long)1 << 33) * 1e-9 * t + (double)((long long)100000 * 100000) * 1e-9 * q[0];
  L += (double)((5 ^ 3) | (8 & ~0)) * t + d * q[0] + r * q[1] + (double)(m / 1000000) * 1e-3 * t + (1 ? 2 : 3) * q[1];
  L += flag * q[0] + both * t + !flag * q[1] + (flag != both) * qd[1] + (q[0] > q[1]) * t + a[flag] * a[both + 2] + odd(n + 1) * qd[0];
  L += (n - 7 > 0) * t + ((int)n - 7 > 0) * q[0] + (sizeof(int) - 5 > 0) * q[1] + (double)(3 - (long)sizeof(char)) * t;
  L += (int)2.75 * q[0] + (double)(int)-1.5 * t + (float)0.1 * q[1] + 'A' * 1e-2 * t + 010 * 0.1 * q[0];
  n *= 2;
  n -= 20;
  L += (double)(n >> 31) * t;
  m = 3, m <<= 2, m |= 1, m ^= 5, m %= 6, m &= 7, m >>= 1;
  return L + m * t;
}
