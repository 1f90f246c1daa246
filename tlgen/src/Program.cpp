// The table of mathematical functions that both the lowering and the emitters go by.
#include "Program.h"

namespace tlgen {

static const MathFunction table[] = {
    {"sqrt", 1},  {"cbrt", 1}, {"exp", 1},  {"expm1", 1}, {"exp2", 1},     {"log", 1},   {"log1p", 1}, {"log2", 1},
    {"log10", 1}, {"sin", 1},  {"cos", 1},  {"tan", 1},   {"asin", 1},     {"acos", 1},  {"atan", 1},  {"atan2", 2},
    {"sinh", 1},  {"cosh", 1}, {"tanh", 1}, {"asinh", 1}, {"acosh", 1},    {"atanh", 1}, {"pow", 2},   {"hypot", 2},
    {"fabs", 1},  {"fmin", 2}, {"fmax", 2}, {"fma", 3},   {"copysign", 2}, {"erf", 1},
};

const MathFunction *findMath(const std::string &name) {
  for (const MathFunction &f : table)
    if (name == f.name) return &f;
  return nullptr;
}

} // namespace tlgen
