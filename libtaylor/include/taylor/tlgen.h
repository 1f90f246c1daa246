/* Marks for tlgen, for who would rather say roles in the source than on the command line:
 *
 *     TLGEN(lagrangian) double energy_difference(TLGEN(q) const double *x, TLGEN(qd) const double *v);
 *     TLGEN(holonomic:3) void loop_closure(const double *q, double *out);
 *
 * Roles of functions: lagrangian, force, dissipation, holonomic:ROWS, nonholonomic:ROWS. Roles of parameters: q, qd, t, p, out. To any
 * other compiler the marks are empty. */
#ifndef TAYLOR_TLGEN_H
#define TAYLOR_TLGEN_H

#ifdef __TLGEN__
#define TLGEN(role) __attribute__((annotate("tlgen:" #role)))
#else
#define TLGEN(role)
#endif

#endif
