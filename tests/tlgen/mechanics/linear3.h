/* linear3.h -- vectors and matrices of three, header only */
#ifndef LINEAR3_H
#define LINEAR3_H

#include <math.h>

#ifndef L3_INLINE
#define L3_INLINE static inline __attribute__((always_inline, unused))
#endif

typedef double v3[3];
typedef double m3[3][3];

L3_INLINE void v3_copy(v3 r, v3 const a) { for (int i = 0; i < 3; ++i) r[i] = a[i]; }
L3_INLINE void v3_add(v3 r, v3 const a, v3 const b) { for (int i = 0; i < 3; ++i) r[i] = a[i] + b[i]; }
L3_INLINE void v3_scale(v3 r, v3 const v, double const s) { for (int i = 0; i < 3; ++i) r[i] = v[i] * s; }
L3_INLINE double v3_mul_inner(v3 const a, v3 const b) { double p = 0.; for (int i = 0; i < 3; ++i) p += b[i] * a[i]; return p; }
L3_INLINE void v3_mul_cross(v3 r, v3 const a, v3 const b)
{
    v3 c = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    v3_copy(r, c);
}
L3_INLINE void m3_rotate_axis(m3 r, int axis, double angle)
{
    double s = sin(angle), c = cos(angle);
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r[i][j] = i == j ? 1. : 0.;
    r[a][a] = c; r[a][b] = -s;
    r[b][a] = s; r[b][b] = c;
}
L3_INLINE void m3_mul_v3(v3 r, m3 m, v3 const v)
{
    v3 x;
    for (int j = 0; j < 3; ++j) { x[j] = 0.; for (int i = 0; i < 3; ++i) x[j] += m[j][i] * v[i]; }
    v3_copy(r, x);
}

#endif
