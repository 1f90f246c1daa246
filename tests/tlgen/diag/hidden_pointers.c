/* Pointers to active numbers inside structs and arrays: what they point to would be lost. */
struct view { const double *x; int n; };
struct room { double *x; };
static double first(const struct view *v) { return v->x[0]; }
static double value(struct view v) { return v.x[0]; }
static void set(struct room *r, double *x) { r->x = x; }    /* expect: pointer-to-pointer */
static void fill(struct room *r, double x) { r->x[0] = x; } /* expect: pointer-to-pointer */
double L(const double *q, const double *qd)
{
  const double *rows[2] = {q, qd};       /* expect: pointer-to-pointer */
  const double *late[2];                 /* expect: pointer-to-pointer */
  struct view v = {q, 1}, w, u[2];       /* expect: pointer-to-pointer */
  struct view list[] = {{qd, 1}};        /* expect: pointer-to-pointer */
  double room[2] = {q[0], 1.0}, other[2] = {0.0, 0.0};
  struct room r, s;
  late[0] = q;                           /* expect: pointer-to-pointer */
  w.x = q;                               /* expect: pointer-to-pointer */
  u[1].x = &q[0];                        /* expect: pointer-to-pointer */
  set(&r, room);
  s.x = other;                           /* expect: pointer-to-pointer */
  fill(&s, q[0]);
  return rows[1][0] + late[0][0] + first(&v) + w.x[0] + value(*u) + r.x[0] + other[0] + value(list[0]) +  /* expect: pointer-to-pointer */
         first(&(struct view){q, 1});    /* expect: pointer-to-pointer */
}
