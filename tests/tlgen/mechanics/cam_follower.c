/* Camshaft with an eccentric disc that swings a rocker through a roller. The rocker's angle is found by Newton's method, its rate by
   implicit differentiation. */
#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>

#define MAX_ITERATIONS 25
#define TOLERANCE      1e-12

static const double PIVOT_X = 0.080, ARM = 0.055, ECCENTRICITY = 0.012, REACH = 0.045; /* disc and roller radius together */
static const double J_SHAFT = 6.5e-4, J_ROCKER = 2.2e-4, K_VALVE = 9.0, REST = 1.9, MOTOR = 0.8;

/* Contact condition g(theta, psi) = 0, and its two derivatives. */
static double contact(double theta, double psi, double *g_theta, double *g_psi)
{
    const double x = PIVOT_X + ARM * cos(psi) - ECCENTRICITY * cos(theta);
    const double y = ARM * sin(psi) - ECCENTRICITY * sin(theta);

    *g_theta = 2 * ECCENTRICITY * (x * sin(theta) - y * cos(theta));
    *g_psi = 2 * ARM * (y * cos(psi) - x * sin(psi));
    return x * x + y * y - REACH * REACH;
}

static bool rocker_angle(double theta, double *psi, double *slope)
{
    double g, g_theta, g_psi, step;
    int iteration = 0;

    *psi = 2.5; /* the branch above */
    do {
        if (iteration++ == MAX_ITERATIONS) return false;
        g = contact(theta, *psi, &g_theta, &g_psi);
        step = -g / g_psi;
        *psi += step;
    } while (fabs(step) > TOLERANCE);
    contact(theta, *psi, &g_theta, &g_psi);
    *slope = -g_theta / g_psi;
    return true;
}

double cam_lagrangian(const double *q, const double *qd)
{
    double psi, slope, rate, twist;
    bool found = rocker_angle(q[0], &psi, &slope);

    assert(found);
    (void)found;
    rate = slope * qd[0];
    twist = psi - REST;
    return (J_SHAFT * qd[0] * qd[0] + J_ROCKER * rate * rate - K_VALVE * twist * twist) / 2;
}

void cam_drive(const double *qd, double *out) { out[0] = MOTOR * (1 - qd[0] / 60); }
