/* The way from the pendulum's absolute angles to a chain's relative ones, and back with the results, for peers that know hinges only:
 *   q_rel = D q_abs, D the differences;  qdd_abs = S qdd_rel, S the sums;  J_abs = S J_rel D.  */
#pragma once
#include "contender.h"

#include <cstring>
#include <string>
#include <vector>

inline bool has_absolute_angles(const bench_case &problem) { return std::string("pendulum") == problem.model; }

inline void differences(int n, const double *absolute, double *relative) {
  for (int i = n - 1; i >= 0; i--) relative[i] = absolute[i] - (i ? absolute[i - 1] : 0.0);
}

inline void sums(int n, double *x) {
  for (int i = 1; i < n; i++) x[i] += x[i - 1];
}

/* q, qd: n; w: (dq, dqd). */
inline void relative_state(int n, bool absolute, const double *q, const double *qd, const double *w, double *native_q,
                           double *native_qd, double *native_w) {
  const double *from[] = {q, qd, w, w ? w + n : nullptr};
  double *to[] = {native_q, native_qd, native_w, native_w ? native_w + n : nullptr};
  for (int k = 0; k < 4; k++) {
    if (!from[k] || !to[k]) continue;
    if (absolute)
      differences(n, from[k], to[k]);
    else
      std::memcpy(to[k], from[k], n * sizeof(double));
  }
}

/* part: n x n, d qdd / d(q or qd) in relative angles, into columns first .. first + n of the model's n x 2n matrix. */
inline void model_columns(int n, bool absolute, const double *part, double *qdd_y, int first) {
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      double *at = &qdd_y[i * 2 * n + first + j];
      *at = part[i * n + j];
      if (!absolute) continue;
      if (j + 1 < n) *at -= part[i * n + j + 1];
      if (i) *at += qdd_y[(i - 1) * 2 * n + first + j];
    }
  }
}

/* qdd, dqdd: n; qdd_y: d qdd/dq, then d qdd/dqd, each n x n, becomes n x 2n. In place. */
inline void model_results(int n, bool absolute, char need, double *qdd, double *qdd_y, double *dqdd) {
  if (absolute) sums(n, qdd);
  if (absolute && need == 'V') sums(n, dqdd);
  if (need == 'J') {
    const std::vector<double> parts(qdd_y, qdd_y + 2 * n * n);
    model_columns(n, absolute, parts.data(), qdd_y, 0);
    model_columns(n, absolute, parts.data() + n * n, qdd_y, n);
  }
}
