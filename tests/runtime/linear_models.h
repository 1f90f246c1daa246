/* Mechanisms whose small motions have closed forms, in plain C. */
#ifndef LINEAR_MODELS_H
#define LINEAR_MODELS_H

/* One struct for all of them; each says what it uses. */
typedef struct linear_model {
  double mass, length, gravity; /* kg, m, m/s^2 */
  double across, along;         /* moments of inertia about the centre of mass, kg m^2 */
  double spin;                  /* rad/s */
  double cart;                  /* mass, kg */
  double push;                  /* force, N: an input */
  double damping;               /* N s/m */
} linear_model;

/* A mass on a rod in cylindrical coordinates (r, turn, z), z up: mass, length, gravity. */
double conical_lagrangian(const double *q, const double *qd, const linear_model *p);
double conical_rod(const double *q, const linear_model *p);

/* A symmetric top on a fixed point: q = (r, z, precession, nutation, spin) with its centre of mass at distance r from the vertical and
 * height z: mass, length of that point from the tip, gravity, across, along. */
double top_lagrangian(const double *q, const double *qd, const linear_model *p);
void top_tip(const double *q, const linear_model *p, double *out);

/* The same top by the unit vector of its axis, q = (x, y, z), for a given spin about it (its momentum is constant): mass, length,
 * gravity, across (about the tip), along, spin. */
double sleeping_lagrangian(const double *q, const double *qd, const linear_model *p);
double sleeping_unit(const double *q);

/* A thin uniform disk of radius length that rolls on a plane: q = (x, y of its centre, yaw, lean, roll): mass, length, gravity. */
double disk_lagrangian(const double *q, const double *qd, const linear_model *p);
void disk_rolls(const double *q, const double *qd, const linear_model *p, double *out);

/* Chaplygin's sleigh: q = (x, y of the blade, heading), its centre of mass at distance length ahead: mass, length, across. */
double chaplygin_lagrangian(const double *q, const double *qd, const linear_model *p);
double chaplygin_blade(const double *q, const double *qd);

/* A mass on a rod below a cart, q = (cart, x, y), pushed: mass, length, gravity, cart, push, damping of the cart. */
double crane_lagrangian(const double *q, const double *qd, const linear_model *p);
double crane_rod(const double *q, const linear_model *p);
void crane_push(const double *q, const double *qd, const linear_model *p, double *out);

#endif
