/* Array members of temporary structs, and lists of pointers made on the spot. */
typedef struct vec {
  double x[3];
} vec;
typedef struct frame {
  vec r, axis[2];
  double m;
} frame;

static vec make(double a, double b, double c)
{
  vec v = {{a, b, c}};
  return v;
}

static vec cross(vec a, vec b)
{
  return make(a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2], a.x[0] * b.x[1] - a.x[1] * b.x[0]);
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static frame place(double angle)
{
  frame f = {{{angle, angle * angle, 1.0}}, {{{1.0, angle, 0.0}}, {{0.0, 2.0, angle}}}, 3.0};
  return f;
}

static double of_list(const double *const *list, int n)
{
  double s = 0.0;
  for (int i = 0; i < n; i++) s += list[i][0] * list[i][1] * (i + 1);
  return s;
}

static double change_first(double *const *list)
{
  *list[0] *= list[1][0];
  return **list;
}

double lagrangian(const double *q, const double *qd, double t)
{
  vec a = make(q[0], q[1], t);
  double s = cross(a, make(qd[0], 1.0, qd[1])).x[2];
  s += dot(make(q[0], 2.0, t).x, make(q[1], qd[0], 1.0).x);
  s += place(q[0]).axis[1].x[2] * place(q[1]).r.x[1] + place(2.0).axis[0].x[1] * place(t).m;
  s += make(1.0, 2.0, 3.0).x[1] * q[0] * q[1];
  s += (q[0] > 0.0 ? a : cross(a, a)).x[1];

  double u = q[0] * 2.0, v = q[1], *p = &u, *r = &v;
  s += of_list((const double *const[]){q, qd, a.x}, 3);
  s += change_first((double *const[]){p, r}) * change_first((double *const[2]){r, p});
  double *const *pp = (double *const[]){p, r};
  **pp *= *pp[1];
  return s + u * v;
}
