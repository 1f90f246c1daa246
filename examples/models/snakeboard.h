/* The snakeboard: a board on two wheel axles that are steered against each other, with a rotor on top. Rotor and steering are driven along
 * given sines, by constraints that depend on time; the wheels do not slip sideways. q = (x, y, heading, rotor, back, front): middle of the
 * board, m, m; rad, the last three relative to the board. */
#ifndef SNAKEBOARD_H
#define SNAKEBOARD_H

enum { SNAKEBOARD_COORDINATES = 6, SNAKEBOARD_DRIVES = 3, SNAKEBOARD_SLIPS = 2 };

typedef struct snakeboard {
  double mass;                /* kg */
  double board, rotor, axle;  /* moments of inertia, kg m^2 */
  double half_length;         /* from the middle to an axle, m */
  double rotor_swing, steering; /* amplitudes, rad */
  double rate;                /* of both, rad/s */
} snakeboard;

double snakeboard_lagrangian(const double *q, const double *qd, const snakeboard *p);

/* Rotor, back and front axle less what they are driven along, swing sin(rate t), -steering sin(rate t), steering sin(rate t): rad. */
void snakeboard_drives(const double *q, double t, const snakeboard *p, double *out);

/* Velocity of the back and of the front wheels along their axle, m/s. */
void snakeboard_slips(const double *q, const double *qd, const snakeboard *p, double *out);

#endif
