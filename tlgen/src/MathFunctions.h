// The functions of math.h, and what becomes of each where its argument is active.
#ifndef TLGEN_MATHFUNCTIONS_H
#define TLGEN_MATHFUNCTIONS_H

#include <string>

namespace tlgen {

struct MathFunction {
  enum Kind {
    Smooth, // an operation on jets
    Step,   // constant between jumps: its derivative is taken as zero, with a warning
    Test,   // an integer from the value alone, as a comparison is
    Opaque  // of passive values only
  };
  const char *name;
  int arity;
  Kind kind;
  const char *operation; // Smooth: tl_<operation>
};

// By the name of the function in double, its single-precision form (sinf) or as a builtin of the compiler; null for other names.
const MathFunction *findMath(const std::string &name);

// The name that math.h gives it: without the mark of a builtin.
std::string mathName(const std::string &name);

} // namespace tlgen

#endif
