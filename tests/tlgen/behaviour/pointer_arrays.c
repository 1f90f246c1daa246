/* Pointers behind pointers: arrays of them, a walk through an address, rows that change places. */
static void next(const double **p) { ++*p; }

static void exchange(double **a, double **b) {
  double *keep = *a;
  *a = *b;
  *b = keep;
}

static double square(double x) { return x * x; }

static double cross(const double *const *rows, int n) {
  double s = 0;
  for (int i = 0; i < n; i++) s += rows[i][0] * rows[n - 1 - i][1];
  return s;
}

double lagrangian(const double *q, const double *qd) {
  const double *rows[2] = {q, qd}, *walk = {q}, **at = &walk;
  double even[2] = {0, 1}, odd[2] = {2, 3}, *pair[2] = {even, odd};
  double s = 0;
  for (int i = 0; i < 4; i++) s += rows[i % 2][i / 2] * (i + 1);
  const double *picked = square(q[0]) > 0.25 ? &rows[(int)(square(2) > 3)][square(q[1]) > 0.3] : qd;
  s += picked[0];
  next(at);
  even[0] = walk[0] * qd[0];
  exchange(&pair[0], &pair[1]);
  pair[0][1] = s;
  return pair[1][0] * pair[0][1] + even[1] * **at + odd[0] + cross((const double *const[]){q, qd}, 2) * cross(&(const double *){qd}, 1);
}
