/*
 * GIMBAL.C  --  gyroscope in two frames: outer frame about the vertical, inner frame about
 *               a horizontal axis, rotor about the inner frame's axis; the centre of mass
 *               of the inner frame is off its axis.
 */
#include <math.h>

#define X 0
#define Y 1
#define Z 2

#define VSET(v, a, b, c)      { (v)[X] = (a); (v)[Y] = (b); (v)[Z] = (c); }
#define VADDS(r, a, s, b)     { (r)[X] = (a)[X] + (s) * (b)[X]; (r)[Y] = (a)[Y] + (s) * (b)[Y]; (r)[Z] = (a)[Z] + (s) * (b)[Z]; }
#define VDOT(a, b)            ((a)[X] * (b)[X] + (a)[Y] * (b)[Y] + (a)[Z] * (b)[Z])
#define VCROSS(r, a, b)       { (r)[X] = (a)[Y] * (b)[Z] - (a)[Z] * (b)[Y]; \
                                (r)[Y] = (a)[Z] * (b)[X] - (a)[X] * (b)[Z]; \
                                (r)[Z] = (a)[X] * (b)[Y] - (a)[Y] * (b)[X]; }
#define INERTIA(J, w, e1, e2, e3) (0.5 * ((J)[X] * VDOT(w, e1) * VDOT(w, e1) + (J)[Y] * VDOT(w, e2) * VDOT(w, e2) \
                                          + (J)[Z] * VDOT(w, e3) * VDOT(w, e3)))

typedef struct GYRO
{
  double Outer;         /* about the vertical */
  double Inner[3];      /* about its principal axes */
  double Rotor[3];
  double Mass, Offset[3], Gravity, Spring, RestAngle;
} GYRO;

GYRO const Gyro = { 0.031, { 0.012, 0.017, 0.009 }, { 0.006, 0.006, 0.011 }, 1.4, { 0.004, -0.002, 0.013 }, 9.81, 0.8, 0.1 };

double GyroLagrangian(const double *q, const double *qd, const GYRO *p)
{
  double e1[3], e2[3], e3[3], up[3], wo[3], wi[3], wr[3], v[3], c[3], zero[3] = { 0.0, 0.0, 0.0 };
  double T, V;

  VSET(up, 0.0, 0.0, 1.0);
  VSET(e1, cos(q[0]), sin(q[0]), 0.0);                                            /* the inner frame's bearing */
  VSET(e2, -sin(q[0]) * cos(q[1]), cos(q[0]) * cos(q[1]), sin(q[1]));
  VCROSS(e3, e1, e2);                                                             /* the rotor's axis */
  VADDS(wo, zero, qd[0], up);
  VADDS(wi, wo, qd[1], e1);
  VADDS(wr, wi, qd[2], e3);
  VADDS(c, zero, p->Offset[X], e1);
  VADDS(c, c, p->Offset[Y], e2);
  VADDS(c, c, p->Offset[Z], e3);
  VCROSS(v, wi, c);
  T = 0.5 * p->Outer * VDOT(wo, wo) + INERTIA(p->Inner, wi, e1, e2, e3) + INERTIA(p->Rotor, wr, e1, e2, e3) + 0.5 * p->Mass * VDOT(v, v);
  V = p->Mass * p->Gravity * VDOT(c, up) + 0.5 * p->Spring * (q[1] - p->RestAngle) * (q[1] - p->RestAngle);
  return T - V;
}
