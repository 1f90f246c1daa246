/* Thin disk rolling on a rough plane. q = (X, Y of the contact point, YAW, LEAN, SPIN).
   In the manner of Autolev's output: intermediate results in Z[], numbered from 1. */
#include <math.h>
#define  M      1.5
#define  R      0.35
#define  G      9.81

typedef double ARR[24];

double disk_L(const double *q, const double *qd) {
  ARR    Z;
  double u1,u2,u3,u4,u5,KE,PE;

  u1 = qd[0];  u2 = qd[1];  u3 = qd[2];  u4 = qd[3];  u5 = qd[4];
  Z[1] = cos(q[2]);
  Z[2] = sin(q[2]);
  Z[3] = cos(q[3]);
  Z[4] = sin(q[3]);
  Z[5] = u5 + u3*Z[4];
  Z[6] = u3*Z[3];
  Z[7] = R*Z[4];
  Z[8] = R*Z[3];
  Z[9] = Z[1]*Z[7];
  Z[10] = Z[2]*Z[7];
  Z[11] = u1 + Z[2]*Z[8]*u4 + Z[9]*u3;
  Z[12] = u2 - Z[1]*Z[8]*u4 + Z[10]*u3;
  Z[13] = -Z[7]*u4;
  Z[14] = M*R*R/4;
  Z[15] = 2*Z[14];
  KE = 0.5*M*(Z[11]*Z[11] + Z[12]*Z[12] + Z[13]*Z[13]) + 0.5*Z[14]*(u4*u4 + Z[6]*Z[6]) + 0.5*Z[15]*Z[5]*Z[5];
  PE = M*G*Z[8];
  return KE - PE;
}

void disk_roll(const double *q, const double *qd, double *out) {
  ARR    Z;

  Z[1] = cos(q[2]);  Z[2] = sin(q[2]);
  Z[3] = R*qd[4];
  out[0] = qd[0] - Z[1]*Z[3];
  out[1] = qd[1] - Z[2]*Z[3];
}
