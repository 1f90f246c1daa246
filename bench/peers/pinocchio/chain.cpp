/* Pinocchio as a contender: the planar chain of point masses on hinges about z, gravity along x, each angle relative to the link
 * before.
 *
 * Two contenders, by macro:
 *   (default)   F: aba; J: computeABADerivatives; V: the same, times the direction
 *   -DCHOLESKY  F: crba, nonLinearEffects and the sparse factorisation of M; V: aba on numbers with a derivative, O(n)
 * The pendulum's absolute angles are converted outside the timing. */
#include "contender.h"
#include "hinge.h"
#include "relative_angles.h"

#include <pinocchio/algorithm/aba.hpp>
#ifdef CHOLESKY
#include "dual.h"
#include <pinocchio/algorithm/cholesky.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#else
#include <pinocchio/algorithm/aba-derivatives.hpp>
#endif

#include <memory>
#include <string>

namespace {

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;
using RowMatrix = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

template <typename Number> struct mechanism {
  typedef pinocchio::ModelTpl<Number, 0, hinges> Model;
  typedef Eigen::Matrix<Number, Eigen::Dynamic, 1> Numbers;

  Model model;
  pinocchio::DataTpl<Number, 0, hinges> data;
  Numbers q, qd, torque;

  explicit mechanism(const bench_case &problem)
      : model(build(problem)), data(model), q(problem.n), qd(problem.n), torque(Numbers::Zero(problem.n)) {}

  static Model build(const bench_case &problem) {
    typedef Eigen::Matrix<Number, 3, 1> Point;
    typedef Eigen::Matrix<Number, 3, 3> Tensor;
    Model model;
    pinocchio::JointIndex parent = 0;
    model.gravity.linear(Point(problem.gravity, 0, 0));
    for (int i = 0; i < problem.n; i++) {
      pinocchio::SE3Tpl<Number> hinge = pinocchio::SE3Tpl<Number>::Identity();
      if (i) hinge.translation() = Point(problem.length[i - 1], 0, 0);
      parent = model.addJoint(parent, typename hinges<Number, 0>::JointModelRZ(), hinge, "hinge" + std::to_string(i));
      model.appendBodyToJoint(parent,
                              pinocchio::InertiaTpl<Number>(problem.mass[i], Point(problem.length[i], 0, 0), Tensor(Tensor::Zero())));
    }
    return model;
  }
};

struct chain {
  int n;
  bool absolute; /* the model's angles are absolute */
  mechanism<double> plain;
#ifdef CHOLESKY
  mechanism<dual> moving;
  explicit chain(const bench_case &problem) : n(problem.n), absolute(has_absolute_angles(problem)), plain(problem), moving(problem) {}
#else
  explicit chain(const bench_case &problem) : n(problem.n), absolute(has_absolute_angles(problem)), plain(problem) {}
#endif
};

#ifdef CHOLESKY

int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  Vector result(qdd, c.n);
  pinocchio::crba(c.plain.model, c.plain.data, ConstVector(q, c.n), pinocchio::Convention::LOCAL);
  pinocchio::nonLinearEffects(c.plain.model, c.plain.data, ConstVector(q, c.n), ConstVector(qd, c.n));
  pinocchio::cholesky::decompose(c.plain.model, c.plain.data);
  result = -c.plain.data.nle;
  pinocchio::cholesky::solve(c.plain.model, c.plain.data, result);
  return 0;
}

int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  chain &c = *static_cast<chain *>(self);
  for (int i = 0; i < c.n; i++) {
    c.moving.q[i] = dual(q[i], w[i]);
    c.moving.qd[i] = dual(qd[i], w[c.n + i]);
  }
  const auto &result =
      pinocchio::aba(c.moving.model, c.moving.data, c.moving.q, c.moving.qd, c.moving.torque, pinocchio::Convention::LOCAL);
  for (int i = 0; i < c.n; i++) {
    qdd[i] = result[i].v;
    dqdd[i] = result[i].d;
  }
  return 0;
}

constexpr auto jacobian = nullptr;

#else

int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  Vector(qdd, c.n) = pinocchio::aba(c.plain.model, c.plain.data, ConstVector(q, c.n), ConstVector(qd, c.n), c.plain.torque,
                                    pinocchio::Convention::LOCAL);
  return 0;
}

/* qdd_y: d/dq, then d/dqd. */
int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  chain &c = *static_cast<chain *>(self);
  RowMatrix by_q(qdd_y, c.n, c.n), by_qd(qdd_y + c.n * c.n, c.n, c.n);
  pinocchio::computeABADerivatives(c.plain.model, c.plain.data, ConstVector(q, c.n), ConstVector(qd, c.n), c.plain.torque, by_q, by_qd,
                                   c.plain.data.Minv);
  Vector(qdd, c.n) = c.plain.data.ddq;
  return 0;
}

int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  chain &c = *static_cast<chain *>(self);
  pinocchio::computeABADerivatives(c.plain.model, c.plain.data, ConstVector(q, c.n), ConstVector(qd, c.n), c.plain.torque);
  Vector(qdd, c.n) = c.plain.data.ddq;
  Vector result(dqdd, c.n);
  result.noalias() = c.plain.data.ddq_dq * ConstVector(w, c.n);
  result.noalias() += c.plain.data.ddq_dv * ConstVector(w + c.n, c.n);
  return 0;
}

#endif

void to_native(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd, double *native_w) {
  const chain &c = *static_cast<chain *>(self);
  relative_state(c.n, c.absolute, q, qd, w, native_q, native_qd, native_w);
}

void from_native(void *self, char need, const double *, const double *, double *qdd, double *qdd_y, double *dqdd) {
  const chain &c = *static_cast<chain *>(self);
  model_results(c.n, c.absolute, need, qdd, qdd_y, dqdd);
}

} // namespace

extern "C" int bench_open(const bench_case *problem, bench_contender *contender) {
  std::unique_ptr<chain> c(new chain(*problem));
  *contender = {c.release(), 1, acceleration, jacobian, directional, to_native, from_native};
  return 0;
}
