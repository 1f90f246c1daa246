/* A number with its derivative in one direction, for Pinocchio's algorithms that are templates of the scalar. */
#pragma once
#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <limits>

struct dual {
  double v, d; /* value, derivative */
  dual(double value = 0, double derivative = 0) : v(value), d(derivative) {}
  dual &operator+=(dual b) { return v += b.v, d += b.d, *this; }
  dual &operator-=(dual b) { return v -= b.v, d -= b.d, *this; }
  dual &operator*=(dual b) { return d = d * b.v + v * b.d, v *= b.v, *this; }
  dual &operator/=(dual b) {
    v /= b.v;
    d = (d - v * b.d) / b.v;
    return *this;
  }
  explicit operator double() const { return v; }
};

inline dual operator+(dual a) { return a; }
inline dual operator-(dual a) { return {-a.v, -a.d}; }
inline dual operator+(dual a, dual b) { return a += b; }
inline dual operator-(dual a, dual b) { return a -= b; }
inline dual operator*(dual a, dual b) { return a *= b; }
inline dual operator/(dual a, dual b) { return a /= b; }
inline bool operator==(dual a, dual b) { return a.v == b.v; }
inline bool operator!=(dual a, dual b) { return a.v != b.v; }
inline bool operator<(dual a, dual b) { return a.v < b.v; }
inline bool operator>(dual a, dual b) { return a.v > b.v; }
inline bool operator<=(dual a, dual b) { return a.v <= b.v; }
inline bool operator>=(dual a, dual b) { return a.v >= b.v; }
inline dual sin(dual a) { return {std::sin(a.v), std::cos(a.v) * a.d}; }
inline dual cos(dual a) { return {std::cos(a.v), -std::sin(a.v) * a.d}; }
inline dual sqrt(dual a) {
  const double root = std::sqrt(a.v);
  return {root, a.d / (2 * root)};
}
inline dual abs(dual a) { return a.v < 0 ? -a : a; }
inline dual abs2(dual a) { return a * a; }
inline bool isfinite(dual a) { return std::isfinite(a.v) && std::isfinite(a.d); }

namespace std {
template <> struct numeric_limits<dual> : numeric_limits<double> {};
} // namespace std

namespace Eigen {
template <> struct NumTraits<dual> : NumTraits<double> {
  typedef dual Real;
  typedef dual NonInteger;
  typedef dual Literal;
  typedef dual Nested;
  enum { RequireInitialization = 1, ReadCost = 2, AddCost = 2, MulCost = 3 };
};
} // namespace Eigen
