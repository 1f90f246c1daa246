/* Cantilever of four Euler-Bernoulli elements on a hardening foundation, tip load that varies with time. Finite element style: gather,
 * element matrices and Gauss points from tables, scatter. DOFs: (w, w') of nodes 1..4; node 0 is clamped. */
#include <math.h>

#define NEL   4
#define NDOF  8
#define NEN   4 /* element degrees of freedom */
#define NGP   7

static const int lm[NEL][NEN] = { /* location matrix, -1: clamped */
  { -1, -1, 0, 1 },
  {  0,  1, 2, 3 },
  {  2,  3, 4, 5 },
  {  4,  5, 6, 7 }
};
static const double h = 0.25, EI = 3.0, rhoA = 0.8, k1 = 15.0, k3 = 400.0;

static const double ke[NEN][NEN] = { /* times EI/h^3, rotations times h */
  {  12,  6, -12,  6 },
  {   6,  4,  -6,  2 },
  { -12, -6,  12, -6 },
  {   6,  2,  -6,  4 }
};
static const double me[NEN][NEN] = { /* times rhoA h/420, rotations times h */
  { 156,  22,  54, -13 },
  {  22,   4,  13,  -3 },
  {  54,  13, 156, -22 },
  { -13,  -3, -22,   4 }
};
static const struct { double xi, weight; } gauss[NGP] = {
  { -0.9491079123427585, 0.1294849661688697 },
  { -0.7415311855993945, 0.2797053914892766 },
  { -0.4058451513773972, 0.3818300505051189 },
  {  0.0000000000000000, 0.4179591836734694 },
  {  0.4058451513773972, 0.3818300505051189 },
  {  0.7415311855993945, 0.2797053914892766 },
  {  0.9491079123427585, 0.1294849661688697 }
};

static void shape_functions(double xi, double N[NEN])
{
  double s = 0.5 * (1.0 + xi);

  N[0] = 1.0 - s * s * (3.0 - 2.0 * s);
  N[1] = h * s * (1.0 - s) * (1.0 - s);
  N[2] = s * s * (3.0 - 2.0 * s);
  N[3] = h * s * s * (s - 1.0);
}

static void gather(int e, const double u[NDOF], double ue[NEN])
{
  int a;

  for (a = 0; a < NEN; a++) {
    int eq = lm[e][a];
    ue[a] = eq < 0 ? 0.0 : u[eq];
  }
}

static double quadratic_form(const double A[NEN][NEN], const double ue[NEN])
{
  int a, b;
  double v[NEN], sum = 0.0;

  for (a = 0; a < NEN; a++)
    v[a] = a % 2 ? h * ue[a] : ue[a];
  for (a = 0; a < NEN; a++)
    for (b = 0; b < NEN; b++)
      sum += v[a] * A[a][b] * v[b];
  return sum;
}

static double foundation_energy(const double ue[NEN])
{
  double N[NEN], w, energy = 0.0;
  int g, a;

  for (g = 0; g < NGP; g++) {
    shape_functions(gauss[g].xi, N);
    for (w = 0.0, a = 0; a < NEN; a++)
      w += N[a] * ue[a];
    energy += gauss[g].weight * h / 2.0 * (k1 * w * w / 2.0 + k3 * w * w * w * w / 4.0);
  }
  return energy;
}

double beam_lagrangian(const double q[NDOF], const double qd[NDOF])
{
  double ue[NEN], ve[NEN], T = 0.0, V = 0.0;
  int e;

  for (e = 0; e < NEL; e++) {
    gather(e, q, ue);
    gather(e, qd, ve);
    T += rhoA * h / 420.0 * quadratic_form(me, ve) / 2.0;
    V += EI / (h * h * h) * quadratic_form(ke, ue) / 2.0;
    V += foundation_energy(ue);
  }
  return T - V;
}

/* Pressure p(t) over the last element, and damping; assembled by scatter-add. */
void beam_load(const double *qd, double t, double *out)
{
  const double fe[NEN] = { h / 2.0, h * h / 12.0, h / 2.0, -h * h / 12.0 };
  int i, a;

  for (i = 0; i < NDOF; i++)
    out[i] = -0.01 * qd[i];
  for (a = 0; a < NEN; a++)
    if (lm[NEL - 1][a] >= 0)
      out[lm[NEL - 1][a]] += 2.0 * cos(5.0 * t) * fe[a];
}
