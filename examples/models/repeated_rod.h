/* A mass on a rigid rod in a vertical plane, whose one constraint is written several times, each time in another unit; q = (x, y) from the
 * pivot, m; y points up. */
#ifndef REPEATED_ROD_H
#define REPEATED_ROD_H

enum { REPEATED_ROD_MOST = 3 };

typedef struct repeated_rod {
  double mass, length, gravity;    /* kg, m, m/s^2 */
  int rows;                        /* 1..REPEATED_ROD_MOST */
  double scale[REPEATED_ROD_MOST]; /* of each row */
} repeated_rod;

double repeated_rod_lagrangian(const double *q, const double *qd, const repeated_rod *p);

/* out[i] = scale[i] (squared length less what it should be, m^2). */
void repeated_rod_lengths(const double *q, const repeated_rod *p, double *out);

#endif
