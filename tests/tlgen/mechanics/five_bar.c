/* Parallel robot with five bars, as complex numbers: a small complex type of its own, no sine or cosine outside of it. */
#include <math.h>

struct cplx { double re, im; };

#define CPLX(a, b) ((struct cplx){ (a), (b) })
#define I_TIMES(z) CPLX(-(z).im, (z).re)

static struct cplx cadd(struct cplx a, struct cplx b) { return CPLX(a.re + b.re, a.im + b.im); }
static struct cplx csub(struct cplx a, struct cplx b) { return CPLX(a.re - b.re, a.im - b.im); }
static struct cplx cmul(struct cplx a, struct cplx b) { return CPLX(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re); }
static struct cplx conjugate(struct cplx a) { return CPLX(a.re, -a.im); }
static struct cplx times(double k, struct cplx a) { return cmul(CPLX(k, 0), a); }
static struct cplx unit(double angle) { return CPLX(cos(angle), sin(angle)); }
static double norm2(struct cplx a) { return cmul(a, conjugate(a)).re; }

enum { BARS = 4, TOOL_BAR = 1 }; /* left upper, left lower, right upper, right lower */
static const double length[BARS] = { 0.3, 0.5, 0.28, 0.52 }, mass[BARS] = { 0.8, 0.5, 0.8, 0.45 };
static const double tool_mass = 0.35;
static const struct cplx motor[2] = { { -0.15, 0 }, { 0.15, 0.02 } };

/* Bar ends z[] and their velocities v[]; even bars start at a motor, odd ones at the bar before. */
static void ends(struct cplx z[BARS], struct cplx v[BARS], const double q[BARS], const double qd[BARS])
{
  for (int i = 0; i < BARS; i++) {
    struct cplx bar = times(length[i], unit(q[i])), turning = times(qd[i], I_TIMES(bar));
    z[i] = cadd(i % 2 ? z[i - 1] : motor[i / 2], bar);
    v[i] = i % 2 ? cadd(v[i - 1], turning) : turning;
  }
}

double five_bar_lagrangian(const double q[BARS], const double qd[BARS])
{
  struct cplx z[BARS], v[BARS], zero = CPLX(0, 0);
  double T = 0, V = 0;

  ends(z, v, q, qd);
  for (int i = 0; i < BARS; i++) { /* slender bars: (|v0|^2 + Re v0 v1* + |v1|^2)/6 of the mass */
    struct cplx v0 = i % 2 ? v[i - 1] : zero, middle = times(0.5, cadd(z[i], i % 2 ? z[i - 1] : motor[i / 2]));
    T += mass[i] * (norm2(v0) + cmul(v0, conjugate(v[i])).re + norm2(v[i])) / 6;
    V += mass[i] * 9.81 * middle.im;
  }
  T += tool_mass * norm2(v[TOOL_BAR]) / 2;
  V += tool_mass * 9.81 * z[TOOL_BAR].im;
  return T - V;
}

void five_bar_loop(const double q[BARS], double out[2])
{
  struct cplx z[BARS], v[BARS], gap;
  const double rest[BARS] = { 0 };

  ends(z, v, q, rest);
  gap = csub(z[1], z[3]);
  out[0] = gap.re, out[1] = gap.im;
}
