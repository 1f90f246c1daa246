/* The spectrum by hand: DOP853 written out for this size, the chain's Jacobian in closed form, P' = F P by rows.
 * Steps are chosen by the error of y alone. Built with -DLINKS=n -DN=n, and -DREGISTERS for the chain's straight-line form. */
#include "hand/chain.c"

#include "spectrum.h"

enum { MOST = D + D * D, EVERY = 16 }; /* unknowns; steps between two QR */
#include "hand/dop853.h"

/* (y, P)' */
INLINE int flow(void *user, double t, const double *restrict z, double *restrict zdot) {
  double ALIGNED qdd_y[LINKS * D + 8];
  (void)t;
  memcpy(zdot, z + LINKS, LINKS * sizeof *z);
  jacobian(user, z, z + LINKS, zdot + LINKS, qdd_y);
  spectrum_tangents(qdd_y, z + D, zdot + D);
  return 0;
}

static int spectrum_run(double t_end, double tolerance, spectrum *result) {
  static dop853 z;
  struct pendulum p = {.n = LINKS, .g = GRAVITY};
  double start[MOST] = {0.0};
  for (int i = 0; i < LINKS; i++) p.mass[i] = p.length[i] = 1.0;
  spectrum_start(start);
  for (int i = 0; i < D; i++) start[D + i * D + i] = 1.0;
  dop853_start(&z, flow, &p, MOST, 0.0, start, 1e-3);
  for (double t = 0.0; t < t_end;) {
    t = dop853_good_step(&z, flow, &p, MOST, D, t, t_end, tolerance);
    if (z.steps % EVERY != 0 && t < t_end) continue;
    spectrum_orthonormalise(z.y + D, result->rho);
    spectrum_check(result, z.y);
    flow(&p, t, z.y, z.k[0]);
    result->t = t;
  }
  result->steps = z.steps;
  return 0;
}
