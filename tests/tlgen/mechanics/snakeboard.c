/*
 * Code generated from a symbolic script (ccode). Do not edit by hand.
 * Snakeboard, q = [x y th psi phi_b phi_f]: nonholonomic, rotor and steering driven by PD laws along sinusoids.
 */
#include "snakeboard.h"
#include <math.h>

real_T snakeboard_L(const real_T q[6], const real_T qd[6])
{
  real_T t2;
  real_T t3;
  real_T t4;
  real_T t5;
  real_T t6;
  real_T t7;
  (void)q;
  t2 = qd[0] * qd[0];
  t3 = qd[1] * qd[1];
  t4 = qd[2] + qd[3];
  t5 = qd[2] + qd[4];
  t6 = qd[2] + qd[5];
  t7 = t2 + t3;
  return SB_M * t7 * 0.5 + SB_J * (qd[2] * qd[2]) * 0.5 + SB_JR * (t4 * t4) * 0.5 + SB_JW * (t5 * t5 + t6 * t6) * 0.5
         - SB_M * 9.81 * sin(SB_SLOPE) * q[0];
}

void snakeboard_psi(const real_T q[6], const real_T qd[6], real_T out[2])
{
  real_T t2;
  real_T t3;
  real_T t4;
  real_T t5;
  t2 = q[2] + q[4];
  t3 = q[2] + q[5];
  t4 = SB_LEN * qd[2] * cos(q[4]);
  t5 = SB_LEN * qd[2] * cos(q[5]);
  out[0] = qd[1] * cos(t2) - qd[0] * sin(t2) - t4;
  out[1] = qd[1] * cos(t3) - qd[0] * sin(t3) + t5;
}

void snakeboard_tau(const real_T q[6], const real_T qd[6], real_T t, real_T out[6])
{
  real_T t2;
  real_T t3;
  real_T t4;
  t2 = t * SB_FREQ;
  t3 = sin(t2) * SB_AMP;
  t4 = cos(t2) * SB_AMP * SB_FREQ;
  out[0] = 0.0;
  out[1] = 0.0;
  out[2] = 0.0;
  out[3] = -SB_KP * (q[3] - t3) - SB_KD * (qd[3] - t4);
  out[4] = -SB_KP * (q[4] + t3) - SB_KD * (qd[4] + t4);
  out[5] = -SB_KP * (q[5] - t3) - SB_KD * (qd[5] - t4);
}
