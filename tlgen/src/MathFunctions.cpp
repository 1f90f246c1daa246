// The table of math.h that the lowering, the analyses and the emitters go by.
#include "MathFunctions.h"

#include <algorithm>

namespace tlgen {

#define SMOOTH(name, arity) {#name, arity, MathFunction::Smooth, #name}
#define OTHER(name, arity, kind) {#name, arity, MathFunction::kind, nullptr}

// clang-format off
static const MathFunction table[] = {
    SMOOTH(sqrt, 1),  SMOOTH(cbrt, 1),  SMOOTH(hypot, 2), SMOOTH(pow, 2),
    SMOOTH(exp, 1),   SMOOTH(exp2, 1),  SMOOTH(expm1, 1), SMOOTH(log, 1),   SMOOTH(log2, 1),  SMOOTH(log10, 1), SMOOTH(log1p, 1),
    SMOOTH(sin, 1),   SMOOTH(cos, 1),   SMOOTH(tan, 1),   SMOOTH(asin, 1),  SMOOTH(acos, 1),  SMOOTH(atan, 1),  SMOOTH(atan2, 2),
    SMOOTH(sinh, 1),  SMOOTH(cosh, 1),  SMOOTH(tanh, 1),  SMOOTH(asinh, 1), SMOOTH(acosh, 1), SMOOTH(atanh, 1),
    SMOOTH(erf, 1),   SMOOTH(erfc, 1),  SMOOTH(tgamma, 1), SMOOTH(lgamma, 1),
    SMOOTH(fabs, 1),  SMOOTH(fmin, 2),  SMOOTH(fmax, 2),  SMOOTH(fdim, 2),  SMOOTH(copysign, 2),
    SMOOTH(fmod, 2),  SMOOTH(remainder, 2), SMOOTH(fma, 3), SMOOTH(scalbn, 2), {"ldexp", 2, MathFunction::Smooth, "scalbn"},
    OTHER(floor, 1, Step), OTHER(ceil, 1, Step), OTHER(trunc, 1, Step), OTHER(round, 1, Step), OTHER(rint, 1, Step), OTHER(nearbyint, 1, Step),
    OTHER(lround, 1, Step), OTHER(lrint, 1, Step), OTHER(llround, 1, Step), OTHER(llrint, 1, Step),
    OTHER(isnan, 1, Test), OTHER(isinf, 1, Test), OTHER(isfinite, 1, Test), OTHER(isnormal, 1, Test), OTHER(signbit, 1, Test),
    OTHER(isgreater, 2, Test), OTHER(isgreaterequal, 2, Test), OTHER(isless, 2, Test), OTHER(islessequal, 2, Test),
    OTHER(islessgreater, 2, Test), OTHER(isunordered, 2, Test), OTHER(abs, 1, Test), OTHER(labs, 1, Test), OTHER(llabs, 1, Test),
    OTHER(logb, 1, Opaque), OTHER(ilogb, 1, Opaque), OTHER(nextafter, 2, Opaque),
};
// clang-format on

std::string mathName(const std::string &name) {
  const std::string builtin = "__builtin_";
  if (name == "__builtin_isinf_sign") return "isinf";
  return name.compare(0, builtin.size(), builtin) == 0 ? name.substr(builtin.size()) : name;
}

const MathFunction *findMath(const std::string &name) {
  std::string plain = mathName(name);
  auto find = [&](const std::string &wanted) {
    return std::find_if(std::begin(table), std::end(table), [&](const MathFunction &f) { return wanted == f.name; });
  };
  auto found = find(plain);
  if (found == std::end(table) && !plain.empty() && plain.back() == 'f') {
    found = find(plain.substr(0, plain.size() - 1));
    if (found != std::end(table) && found->kind == MathFunction::Test) return nullptr;
  }
  return found == std::end(table) ? nullptr : &*found;
}

} // namespace tlgen
