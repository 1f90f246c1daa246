/* The joints that masses in a plane need: sliders along x and y. See hinge.h. */
#pragma once
#include <pinocchio/multibody.hpp>
#include <pinocchio/multibody/joint.hpp>

template <typename Number, int options> struct sliders {
  typedef Number Scalar;
  static constexpr int Options = options;
  typedef pinocchio::JointModelPrismaticTpl<Scalar, Options, 0> JointModelPX;
  typedef pinocchio::JointDataPrismaticTpl<Scalar, Options, 0> JointDataPX;
  typedef pinocchio::JointModelPrismaticTpl<Scalar, Options, 1> JointModelPY;
  typedef pinocchio::JointDataPrismaticTpl<Scalar, Options, 1> JointDataPY;

  /* Named by Pinocchio's headers in any collection, not used here. */
  typedef pinocchio::JointModelMimicTpl<Scalar, Options, sliders> JointModelMimic;
  typedef pinocchio::JointDataMimicTpl<Scalar, Options, sliders> JointDataMimic;
  typedef pinocchio::JointModelCompositeTpl<Scalar, Options, sliders> JointModelComposite;
  typedef pinocchio::JointDataCompositeTpl<Scalar, Options, sliders> JointDataComposite;

  typedef boost::variant<JointModelPX, JointModelPY, boost::recursive_wrapper<JointModelMimic>> JointModelVariant;
  typedef boost::variant<JointDataPX, JointDataPY, boost::recursive_wrapper<JointDataMimic>> JointDataVariant;
};
