/* A thin disk that rolls without slipping on a level plane; q = (x, y, yaw, lean, spin): point of contact, m; heading, angle of the disk
 * from the vertical and rotation about its axle, rad. */
#ifndef ROLLING_DISK_H
#define ROLLING_DISK_H

enum { ROLLING_DISK_COORDINATES = 5, ROLLING_DISK_SLIPS = 2 };

typedef struct rolling_disk {
  double mass, radius, gravity; /* kg, m, m/s^2 */
} rolling_disk;

double rolling_disk_lagrangian(const double *q, const double *qd, const rolling_disk *p);

/* Velocity of the disk's material at the contact: out[0], out[1], m/s. */
void rolling_disk_slip(const double *q, const double *qd, const rolling_disk *p, double *out);

#endif
