/* N four-bar linkages side by side in a plane (N-four-bar mechanism, IFToMM problem A02): uniform rods between the ground's points (i, 0) and
 * the joints B_i, i = 0..N, and between neighbouring joints. q = (x, y) of B_0 .. B_N, m. Upright or hanging it turns as one parallelogram; where
 * all rods lie on one line N of the rods' rows depend on the others, and other motions branch off. */
#ifndef FOUR_BARS_H
#define FOUR_BARS_H

#define FOUR_BARS_MAX_LOOPS 40

typedef struct four_bars {
  int loops;              /* N: 1..FOUR_BARS_MAX_LOOPS */
  int coordinates;        /* 2 (N + 1) */
  int rods;               /* 2 N + 1 */
  double length, mass, g; /* of each rod, m and kg; m/s^2, along -y */
} four_bars;

/* Rods of 1 m and 1 kg; a start upright with 1 m/s along x. */
four_bars four_bars_parameters(int loops);
void four_bars_start(const four_bars *p, double *q, double *qd);

double four_bars_lagrangian(const double *q, const double *qd, const four_bars *p);

/* out[k] = squared length of rod k less what it should be, m^2: N + 1 rods on the ground, then N couplers. */
void four_bars_rods(const double *q, const four_bars *p, double *out);

#endif
