/* Small matrices for attitude dynamics: results first, as array typedefs. All inline. */
#ifndef SATELLITE_H
#define SATELLITE_H

#include <assert.h>
#include <math.h>

typedef double vec3_t[3];
typedef double mat3_t[3][3];

static inline double v3_dot(const vec3_t a, const vec3_t b)
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

static inline void m3_vec(vec3_t r, mat3_t m, const vec3_t v)
{
    int i;
    for (i = 0; i < 3; ++i)
        r[i] = v3_dot(m[i], v);
}

static inline void m3_mul(mat3_t r, mat3_t a, mat3_t b)
{
    int i, j, k;
    mat3_t tmp;
    for (i = 0; i < 3; ++i)
        for (j = 0; j < 3; ++j) {
            tmp[i][j] = 0.0;
            for (k = 0; k < 3; ++k)
                tmp[i][j] += a[i][k] * b[k][j];
        }
    for (i = 0; i < 3; ++i)
        for (j = 0; j < 3; ++j)
            r[i][j] = tmp[i][j];
}

/* Frame rotation by an angle about axis 0, 1 or 2. */
static inline void m3_axis(mat3_t r, int axis, double angle)
{
    int i, j, u = (axis + 1) % 3, v = (axis + 2) % 3;
    assert(axis >= 0 && axis < 3);
    for (i = 0; i < 3; ++i)
        for (j = 0; j < 3; ++j)
            r[i][j] = i == j ? 1.0 : 0.0;
    r[u][u] = r[v][v] = cos(angle);
    r[u][v] = sin(angle);
    r[v][u] = -r[u][v];
}

#endif
