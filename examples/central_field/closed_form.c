/* The equations of motion in the central field, derived by hand: what the jets must reproduce (eqs 67-71). */
#include "closed_form.h"

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* full:     M = m [ u.u  r u' ]    Q = [ -2 m rd u.ud - mu m/r^2 ]
 *                 [ r u  r^2 I ]       [ -2 m r rd ud            ]
 * reduced:  M = m diag(1, r^2 I)   Q = [ m r ud.ud - mu m/r^2    ]
 *                                      [ -2 m r rd ud            ] */
static void fill_mass(equations *e, kinetic kind, double m, double r, const double *u) {
  e->M[0] = kind == KINETIC_FULL ? m * dot(u, u) : m;
  for (int i = 1; i < 4; i++) {
    e->M[5 * i] = m * r * r;
    if (kind == KINETIC_FULL) e->M[i] = e->M[4 * i] = m * r * u[i - 1];
  }
}

static void fill_force(equations *e, kinetic kind, const struct central_field *p, const double *q, const double *qd) {
  const double r = q[0], rd = qd[0], *u = q + 1, *ud = qd + 1;
  const double inertial = kind == KINETIC_FULL ? -2.0 * rd * dot(u, ud) : r * dot(ud, ud);
  e->Q[0] = p->m * inertial - p->mu * p->m / (r * r);
  for (int i = 1; i < 4; i++) e->Q[i] = -2.0 * p->m * r * rd * ud[i - 1];
}

/* u.u = 1, differentiated twice: 2 u.udd = -2 ud.ud. */
static void fill_constraint(equations *e, const double *u, const double *ud) {
  for (int i = 1; i < 4; i++) e->A[i] = 2.0 * u[i - 1];
  e->b[0] = -2.0 * dot(ud, ud);
}

/* full:     rdd = (r ud.ud - 2 rd u.ud - mu/r^2) / u.u
 * reduced:  rdd =  r ud.ud - mu/r^2
 * both:     udd = -2 (rd/r) ud + alpha u,  alpha = (2 (rd/r) u.ud - ud.ud) / u.u
 * On the manifold, where u.u = 1 and u.ud = 0, both are rdd = r |ud|^2 - mu/r^2, udd = -|ud|^2 u - 2 (rd/r) ud (eq 71). */
static void fill_acceleration(equations *e, kinetic kind, const struct central_field *p, const double *q, const double *qd) {
  const double r = q[0], rd = qd[0], *u = q + 1, *ud = qd + 1;
  const double alpha = (2.0 * (rd / r) * dot(u, ud) - dot(ud, ud)) / dot(u, u);
  e->qdd[0] = r * dot(ud, ud) - p->mu / (r * r);
  if (kind == KINETIC_FULL) e->qdd[0] = (e->qdd[0] - 2.0 * rd * dot(u, ud)) / dot(u, u);
  for (int i = 1; i < 4; i++) e->qdd[i] = alpha * u[i - 1] - 2.0 * (rd / r) * ud[i - 1];
}

equations closed_form(kinetic kind, const double *q, const double *qd, const struct central_field *p) {
  equations e = {0};
  fill_mass(&e, kind, p->m, q[0], q + 1);
  fill_force(&e, kind, p, q, qd);
  fill_constraint(&e, q + 1, qd + 1);
  fill_acceleration(&e, kind, p, q, qd);
  return e;
}
