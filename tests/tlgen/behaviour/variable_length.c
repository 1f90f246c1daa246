/* Arrays whose length comes from the parameters and from arguments, in loops and in helpers. */
struct sizes {
  int n;
  double k;
};

static const struct sizes params = {2, 0.75};

static void outer(int n, const double *a, double m[n][n]) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) m[i][j] = a[i] * a[j] * a[j];
}

static double norm(int n, const double *x) {
  double copy[2 * n], s = 0;
  for (int i = 0; i < n; i++) copy[i] = copy[n + i] = x[i] * x[i];
  for (int i = 0; i < 2 * n; i++) s += copy[i];
  return s;
}

/* The length of the caller's array too, three times. */
static double mean_square(int n, const double *x) {
  double copy[n], squares[n], sums[n];
  for (int i = 0; i < n; i++) {
    copy[i] = x[i];
    squares[i] = copy[i] * x[i];
    sums[i] = squares[i] + (i > 0 ? sums[i - 1] : 0);
  }
  return sums[n - 1] / n;
}

double lagrangian(const double *q, const double *qd, const struct sizes *p) {
  const int n = p->n;
  double w[n], m[p->n][p->n], s = 0;
  for (int i = 0; i < n; i++) w[i] = q[i] + p->k * qd[i];
  outer(n, w, m);
  for (int i = 0; i < 3 * n; i++) {
    double row[n + 1];
    if (i % 3 == 1) continue;
    for (int j = 0; j < n; j++) row[j] = m[i % n][j] * qd[j];
    row[n] = row[0];
    if (i == 5) break;
    s += row[n] * row[n - 1] * mean_square(p->n, row);
  }
  return s + norm(n, w) * m[0][n - 1];
}
