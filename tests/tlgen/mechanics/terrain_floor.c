/* Point mass in a force field sampled on a square grid: a potential looked up by (int)floor and interpolated with cubic B-splines,
 * as a game or a robot planner has it. Outside of the map the nearest cells go on. */
#include <math.h>
#include <stdbool.h>

struct map {
    double west, south, cell;
    int width, height;
    signed char sample[8][8];
};

static struct map const yard = {
    -2.0, -1.5, 0.5, 8, 8,
    {
        {  3,  5,  9, 12, 10,  6,  2,  0 },
        {  4,  8, 17, 25, 21, 11,  5,  1 },
        {  2,  9, 22, 40, 33, 15,  4, -2 },
        {  0,  5, 15, 28, 24,  8, -3, -8 },
        { -2,  1,  6, 12,  7, -4,-14,-15 },
        { -3, -2,  0,  2, -3,-13,-24,-19 },
        { -2, -3, -4, -5, -9,-16,-21,-14 },
        {  0, -1, -3, -6, -8,-11,-12, -7 },
    },
};

static int clamp(int value, int low, int high)
{
    if (value < low) value = low;
    else if (value > high) value = high;
    return value;
}

static double spline(int tap, double u)
{
    double v = 1.0 - u;
    switch (tap) {
    case 0: return v * v * v / 6.0;
    case 1: return (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0;
    case 2: return (4.0 - 6.0 * v * v + 3.0 * v * v * v) / 6.0;
    default: return u * u * u / 6.0;
    }
}

static double look_up(struct map const *map, double x, double y)
{
    double const east = (x - map->west) / map->cell, north = (y - map->south) / map->cell;
    int const column = (int)floor(east), row = (int)floor(north);
    double const u = east - column, v = north - row;
    double sum = 0.0;
    int i, j;

    for (j = 0; j < 4; j++)
        for (i = 0; i < 4; i++)
            sum += map->sample[clamp(row + j - 1, 0, map->height - 1)][clamp(column + i - 1, 0, map->width - 1)] * spline(i, u) * spline(j, v);
    return 0.05 * sum;
}

double walker(double const *q, double const *qd, struct map const *map)
{
    return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) - look_up(map, q[0], q[1]);
}
