/* Chain of rods in a plane, joint angles relative to the rod before; a rod hands its tip's motion to the rod that hangs on it. */
#include <math.h>

struct rod { double len, mass; };
struct chain {
    int count;
    double g, tip_mass;
    struct rod rods[8];
};

static const struct chain whip = { 4, 9.81, 0.05, { { 0.8, 1.1 }, { 0.6, 0.7 }, { 0.45, 0.4 }, { 0.3, 0.2 } } };

/* T - V of rod i and all beyond. (vx, vy, y): where it hangs; phi, w: angle and rate of the rod before */
static double rest_of(const struct chain *c, int i, const double *q, const double *qd, double vx, double vy, double y, double phi, double w)
{
    if (i == c->count)
        return 0.5 * c->tip_mass * (vx * vx + vy * vy) - c->tip_mass * c->g * y;

    const struct rod *rod = c->rods + i;
    double h = rod->len / 2;
    phi += *q;
    w += *qd;
    double ex = sin(phi), ey = -cos(phi);            /* along the rod */
    double cx = vx - h * w * ey, cy = vy + h * w * ex;
    double own = rod->mass * (cx * cx + cy * cy) / 2 + rod->mass * rod->len * rod->len / 12 * w * w / 2
                 - rod->mass * c->g * (y + h * ey);
    return own + rest_of(c, i + 1, q + 1, qd + 1, cx - h * w * ey, cy + h * w * ex, y + 2 * h * ey, phi, w);
}

double chain_lagrangian(const double *q, const double *qd, const struct chain *c)
{
    return rest_of(c, 0, q, qd, 0, 0, 0, 0, 0);
}
