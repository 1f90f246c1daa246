/* Pinocchio as a contender for the chain in Cartesian coordinates: point masses on two sliders each, rods as rows of a constraint
 * Jacobian that the caller fills, as Pinocchio's own constraints are contacts and loops of rigid bodies. F: forwardDynamics, which
 * factors M with its sparse Cholesky and J M^-1 J' densely. */
#include "rods.h"
#include "contender.h"
#include "sliders.h"

#include <pinocchio/algorithm/contact-dynamics.hpp>

#include <memory>
#include <string>
#include <vector>

namespace {

using ConstVector = Eigen::Map<const Eigen::VectorXd>;

struct chain {
  typedef pinocchio::ModelTpl<double, 0, sliders> Model;

  int n;
  std::vector<double> length;
  Model model;
  pinocchio::DataTpl<double, 0, sliders> data;
  Eigen::VectorXd torque, gamma;
  Eigen::MatrixXd J;

  explicit chain(const bench_case &problem)
      : n(problem.n), length(problem.length, problem.length + n), model(build(problem)), data(model),
        torque(Eigen::VectorXd::Zero(2 * n)), gamma(n), J(Eigen::MatrixXd::Zero(n, 2 * n)) {}

  static Model build(const bench_case &problem) {
    Model model;
    model.gravity.linear(Eigen::Vector3d(0, -problem.gravity, 0));
    for (int i = 0; i < problem.n; i++) {
      const pinocchio::JointIndex along =
          model.addJoint(0, sliders<double, 0>::JointModelPX(), pinocchio::SE3::Identity(), "x" + std::to_string(i));
      const pinocchio::JointIndex up =
          model.addJoint(along, sliders<double, 0>::JointModelPY(), pinocchio::SE3::Identity(), "y" + std::to_string(i));
      model.appendBodyToJoint(up, pinocchio::Inertia(problem.mass[i], Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()));
    }
    return model;
  }
};

/* J qdd + gamma = 0: half the second derivative of each rod's squared length. */
int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  for (int k = 0; k < c.n; k++) {
    double d[2] = {q[2 * k], q[2 * k + 1]}, e[2] = {qd[2 * k], qd[2 * k + 1]};
    for (int i = 0; k && i < 2; i++) d[i] -= q[2 * k - 2 + i], e[i] -= qd[2 * k - 2 + i];
    for (int i = 0; i < 2; i++) {
      c.J(k, 2 * k + i) = d[i];
      if (k) c.J(k, 2 * k - 2 + i) = -d[i];
    }
    c.gamma[k] = e[0] * e[0] + e[1] * e[1];
  }
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  Eigen::Map<Eigen::VectorXd>(qdd, 2 * c.n) =
      pinocchio::forwardDynamics(c.model, c.data, ConstVector(q, 2 * c.n), ConstVector(qd, 2 * c.n), c.torque, c.J, c.gamma, 0.0);
#pragma GCC diagnostic pop
  return 0;
}

} // namespace

extern "C" int bench_open(const bench_case *problem, bench_contender *contender) {
  std::unique_ptr<chain> c(new chain(*problem));
  *contender = {c.release(), 1, acceleration, nullptr, nullptr, to_rods<chain>, from_rods<chain>, 2 * problem->n};
  return 0;
}
