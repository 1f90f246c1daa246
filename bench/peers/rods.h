/* The conversions of a contender for the chain in Cartesian coordinates, whose self is a Chain with members n and length. */
#pragma once
#include "cartesian.h"

template <typename Chain>
void to_rods(void *self, const double *q, const double *qd, const double *, double *native_q, double *native_qd, double *) {
  const Chain &c = *static_cast<Chain *>(self);
  cartesian_state(c.n, c.length.data(), q, qd, native_q, native_qd);
}

template <typename Chain> void from_rods(void *self, char, const double *q, const double *, double *qdd, double *, double *) {
  const Chain &c = *static_cast<Chain *>(self);
  angular_accelerations(c.n, c.length.data(), q, qdd);
}
