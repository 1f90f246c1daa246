/* Two carriages on a rail with end stops and a coupling with play: potentials made of pieces. */
#include <math.h>

#define RAIL      1.0
#define PLAY      0.3
#define STOP_K    800.0
#define BUMPER_K  150.0
#define BUMPER    0.15   /* length of the rubber in front of a stop */

/* left and right end of the rail: rubber first, then steel */
static double end_stop(double x)
{
    double depth;

    if (x >= -RAIL + BUMPER && x <= RAIL - BUMPER)
        return 0.0;
    depth = x < 0.0 ? -RAIL + BUMPER - x : x - (RAIL - BUMPER);
    if (depth < BUMPER)
        return 0.5 * BUMPER_K * depth * depth;
    return 0.5 * BUMPER_K * BUMPER * BUMPER
         + BUMPER_K * BUMPER * (depth - BUMPER)
         + 0.5 * STOP_K * (depth - BUMPER) * (depth - BUMPER);
}

/* progressive coupling: free within the play, then soft, then hard */
static double coupling(double gap)
{
    double s = fabs(gap);
    return s < PLAY       ? 0.0
         : s < 2.0 * PLAY ? 20.0 * (s - PLAY) * (s - PLAY)
         : s < 3.0 * PLAY ? 20.0 * PLAY * PLAY + 40.0 * PLAY * (s - 2.0 * PLAY) + 45.0 * pow(s - 2.0 * PLAY, 2)
         :                  20.0 * PLAY * PLAY + 40.0 * PLAY * (s - 2.0 * PLAY) + 45.0 * pow(s - 2.0 * PLAY, 2) + 300.0 * pow(s - 3.0 * PLAY, 3);
}

double carriages(const double q[], const double qd[])
{
    return 0.5 * (2.0 * qd[0] * qd[0] + 1.2 * qd[1] * qd[1]) - end_stop(q[0]) - end_stop(q[1]) - coupling(q[1] - q[0]);
}

/* oil dampers behind the stops: they push, and never pull */
void dampers(const double q[], const double qd[], double out[])
{
    int i;
    for (i = 0; i < 2; i++) {
        if (fabs(q[i]) < RAIL - BUMPER) {
            out[i] = 0.0;
            continue;
        }
        out[i] = -fmax(0.0, q[i] > 0.0 ? qd[i] : -qd[i]) * (q[i] > 0.0 ? 30.0 : -30.0) * (fabs(q[i]) - (RAIL - BUMPER));
    }
}
