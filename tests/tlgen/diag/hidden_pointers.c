/* Pointers to active numbers inside structs: what they point to would be lost. */
struct view { const double *x; int n; };
struct room { double *x; };
static double first(const struct view *v) { return v->x[0]; }
static double value(struct view v) { return v.x[0]; }
static void set(struct room *r, double *x) { r->x = x; }    /* expect: pointer-in-struct */
static void fill(struct room *r, double x) { r->x[0] = x; } /* expect: pointer-in-struct */
double L(const double *q, const double *qd)
{
  struct view v = {q, 1}, w, u[2];       /* expect: pointer-in-struct */
  struct view list[] = {{qd, 1}};        /* expect: pointer-in-struct */
  double room[2] = {q[0], 1.0}, other[2] = {0.0, 0.0};
  struct room r, s;
  w.x = q;                               /* expect: pointer-in-struct */
  u[1].x = &q[0];                        /* expect: pointer-in-struct */
  set(&r, room);
  s.x = other;                           /* expect: pointer-in-struct */
  fill(&s, q[0]);
  return first(&v) + w.x[0] + value(u[1]) + r.x[0] + other[0] + value(list[0]) +  /* expect: pointer-in-struct */
         first(&(struct view){q, 1});    /* expect: pointer-in-struct */
}
