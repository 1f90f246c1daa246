/* Elliptic integrals by the arithmetic-geometric mean, and their Taylor coefficients from the differential equations
 * m(1-m)K'' + (1-2m)K' = K/4 and 2mE' = E - K. */
#include "elliptic.h"

#include "taylor/rule.h"

#include <math.h>

static void both(double m, double *K, double *E)
{
    double a = 1.0, b = sqrt(1.0 - m), c = sqrt(m), power = 0.5, sum = 0.5 * m;
    while (fabs(c) > 1e-15) {
        double mean = (a + b) / 2;
        c = (a - b) / 2;
        b = sqrt(a * b);
        a = mean;
        power *= 2;
        sum += power * c * c;
    }
    *K = 1.5707963267948966 / a;
    *E = *K * (1.0 - sum);
}

double ellint_K(double m)
{
    double K, E;
    both(m, &K, &E);
    return K;
}

double ellint_E(double m)
{
    double K, E;
    both(m, &K, &E);
    return E;
}

/* K's coefficients k and E's coefficients e, from 0 to degree each */
static void series(double *k, double *e, double m, int degree)
{
    double slope = 1.0 - 2.0 * m, K, E;
    both(m, &K, &E);
    k[0] = K;
    e[0] = E;
    if (degree > 0) k[1] = (E - (1.0 - m) * K) / (2.0 * m * (1.0 - m));
    for (int j = 0; j + 2 <= degree; j++)
        k[j + 2] = ((j + 0.5) * (j + 0.5) * k[j] - slope * (j + 1) * (j + 1) * k[j + 1]) / (m * (1.0 - m) * (j + 2) * (j + 1));
    for (int j = 0; j < degree; j++) e[j + 1] = ((1 - 2 * j) * e[j] - k[j]) / (2.0 * m * (j + 1));
}

enum { MAX_DEGREE = 16 };

static unsigned rule(tl_real *f, tl_real m, int degree, int second)
{
    double c[2][MAX_DEGREE + 1];
    if (!(m > 0.0 && m < 1.0)) return TL_DOMAIN;
    if (degree > MAX_DEGREE) return TL_NO_SPACE;
    series(c[0], c[1], m, degree);
    for (int j = 0; j <= degree; j++) f[j] = c[second][j];
    return TL_OK;
}

tl_rule ellint_K_taylor, ellint_E_taylor;

unsigned ellint_K_taylor(tl_real *f, tl_real m, int degree, const void *user)
{
    (void)user;
    return rule(f, m, degree, 0);
}

unsigned ellint_E_taylor(tl_real *f, tl_real m, int degree, const void *user)
{
    (void)user;
    return rule(f, m, degree, 1);
}
