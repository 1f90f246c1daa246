/* Parameters of the damped slider. */
#ifndef TEST_DAMPER_H
#define TEST_DAMPER_H

typedef struct damper {
  double mass, dry, creep, drag; /* kg, N, m/s, N s^2/m^2 */
} damper;

#endif
