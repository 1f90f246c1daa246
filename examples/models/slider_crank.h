/* A crank and a rod, both massless, that drive a slider along x: q = (x, y) of the crank's pin, then x of the slider, m. At the outer dead
 * point the rod lies along the crank. Where both have the same length the slider comes to the crank's bearing twice a turn: there the two rows
 * depend on each other, and two motions meet, one where the slider goes through and one where it stays while the rod turns with the crank. */
#ifndef SLIDER_CRANK_H
#define SLIDER_CRANK_H

enum { SLIDER_CRANK_COORDINATES = 3, SLIDER_CRANK_RODS = 2 };

typedef struct slider_crank {
  double crank, rod;           /* lengths, m */
  double pin_mass, slider_mass; /* kg */
} slider_crank;

double slider_crank_lagrangian(const double *q, const double *qd, const slider_crank *p);

/* Squared lengths of crank and rod less what they should be, m^2. */
void slider_crank_rods(const double *q, const slider_crank *p, double *out);

#endif
