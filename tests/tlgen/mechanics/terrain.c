/* A puck that slides over measured ground. Heights on a grid of uneven steps, bicubic between them (Catmull and Rom's tangents
 * at uneven steps), so that slopes are continuous. */
#include <stddef.h>

#define COLUMNS 7
#define ROWS 6
#define COUNT(a) (sizeof(a) / sizeof((a)[0]))

static const float easting[COLUMNS] = { -4.0f, -2.5f, -1.0f, 0.0f, 1.25f, 2.5f, 4.0f };
static const double northing[ROWS] = { -3.0, -1.5, -0.5, 0.75, 2.0, 3.5 };
static const short centimetres[ROWS][COLUMNS] = {
    { 12, 18, 25, 31, 22, 15,  9 },
    { 20, 35, 41, 38, 30, 19, 11 },
    { 26, 44, 62, 57, 36, 25, 18 },
    { 31, 40, 58, 71, 49, 33, 27 },
    { 22, 29, 37, 46, 52, 41, 35 },
    {  8, 16, 21, 30, 38, 47, 44 },
};

/* Hermite's polynomials on the interval x1..x2, tangents from the neighbours */
static double hermite(double x, double x0, double x1, double x2, double x3, double y0, double y1, double y2, double y3)
{
    const double h = x2 - x1, u = (x - x1) / h;
    const double m1 = (y2 - y0) / (x2 - x0) * h, m2 = (y3 - y1) / (x3 - x1) * h;

    return y1 + u * (m1 + u * (3.0 * (y2 - y1) - 2.0 * m1 - m2 + u * (2.0 * (y1 - y2) + m1 + m2)));
}

double ground(double x, double y)
{
    size_t i = 1, j = 1, k;
    double line[4];

    while (i < COLUMNS - 3 && x > easting[i + 1])
        ++i;
    for (; j + 3 < COUNT(northing); ++j)
        if (y <= northing[j + 1])
            break;
    for (k = 0; k < 4; ++k) {
        const short *c = &centimetres[j - 1 + k][i - 1];
        line[k] = 0.01 * hermite(x, easting[i - 1], easting[i], easting[i + 1], easting[i + 2], c[0], c[1], c[2], c[3]);
    }
    return hermite(y, northing[j - 1], northing[j], northing[j + 1], northing[j + 2], line[0], line[1], line[2], line[3]);
}

/* the slope along a direction, from the same polynomials */
static double slope(double x0, double x1, double x2, double x3, double y0, double y1, double y2, double y3, double x)
{
    const double h = x2 - x1, u = (x - x1) / h;
    const double m1 = (y2 - y0) / (x2 - x0) * h, m2 = (y3 - y1) / (x3 - x1) * h;

    return (m1 + u * (2.0 * (3.0 * (y2 - y1) - 2.0 * m1 - m2) + 3.0 * u * (2.0 * (y1 - y2) + m1 + m2))) / h;
}

static double climb(double x, double y, double vx, double vy)
{
    size_t i = 1, j = 1, k;
    double line[4], east[4];

    while (i < COLUMNS - 3 && x > easting[i + 1])
        ++i;
    while (j < ROWS - 3 && y > northing[j + 1])
        ++j;
    for (k = 0; k < 4; ++k) {
        const short *c = centimetres[j - 1 + k] + i - 1;
        line[k] = 0.01 * hermite(x, easting[i - 1], easting[i], easting[i + 1], easting[i + 2], c[0], c[1], c[2], c[3]);
        east[k] = 0.01 * slope(easting[i - 1], easting[i], easting[i + 1], easting[i + 2], c[0], c[1], c[2], c[3], x);
    }
    return vx * hermite(y, northing[j - 1], northing[j], northing[j + 1], northing[j + 2], east[0], east[1], east[2], east[3])
         + vy * slope(northing[j - 1], northing[j], northing[j + 1], northing[j + 2], line[0], line[1], line[2], line[3], y);
}

double puck(double x, double y, double vx, double vy)
{
    const double mass = 0.17, gravity = 9.81, vz = climb(x, y, vx, vy);

    return 0.5 * mass * (vx * vx + vy * vy + vz * vz) - mass * gravity * ground(x, y);
}
