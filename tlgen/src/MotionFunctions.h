// The functions of eom_motion as C, each made of the results of needs.
#ifndef TLGEN_MOTIONFUNCTIONS_H
#define TLGEN_MOTIONFUNCTIONS_H

#include "MotionValues.h"
#include "PrintRows.h"

namespace tlgen {

struct MotionFunction {
  std::string definition, prototype;
  Operations operations; // without those of the solution of M qdd = Q, which is the same in every form
  long tape = 0;         // numbers that loops leave behind for others
  long rows = 0;         // numbers of tangents in memory
  long workspace = 0;    // numbers of the caller's memory
};

class MotionFunctions {
public:
  MotionFunctions(const Program &program, const Model &model, Sites &sites) : program_(program), model_(model), sites_(sites) {}

  // name: of the members of eom_motion; of those for lanes only from values in registers. Throws Unsuitable.
  MotionFunction print(const std::string &name, MotionValues &values);

private:
  class Body;
  std::string energy(Body &body);
  std::string simulate(Body &body);
  std::string residual(Body &body);
  std::string derivatives(Body &body, const std::string &suffix, long columns);
  std::string tangent(Body &body);
  std::string constrained(Body &body);
  MotionFunction taylor(Body &body);
  std::string acceleration(Body &body);
  std::string jacobian(Body &body);
  std::string directional(Body &body);
  std::string solve(Body &body);
  MotionFunction define(const std::string &name, const std::string &args, Body &body, const std::string &statements,
                        long x = 0); // numbers of memory of that name
  std::set<std::string> takenNames() const;

  const Program &program_;
  const Model &model_;
  Sites &sites_;
};

} // namespace tlgen

#endif
