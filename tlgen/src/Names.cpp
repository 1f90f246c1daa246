// Which names are taken, and by whom.
#include "Names.h"
#include "MathFunctions.h"

#include <map>

namespace tlgen {
namespace {

bool startsWith(const std::string &s, const std::string &prefix) { return s.compare(0, prefix.size(), prefix) == 0; }
bool endsWith(const std::string &s, const std::string &ending) {
  return s.size() >= ending.size() && s.compare(s.size() - ending.size(), ending.size(), ending) == 0;
}

// Names inside a printed function, and those of the headers it includes.
bool reservedInside(const std::string &name) {
  static const std::set<std::string> own = {"cx", "nc", "frame", "mark", "result"};
  bool temporary = startsWith(name, "tmp") && name.size() > 3 && name.find_first_not_of("0123456789", 3) == std::string::npos;
  return own.count(name) || temporary || startsWith(name, "tl_") || startsWith(name, "eom_");
}

// What the headers declare that the output includes, POSIX's and older names included.
bool inHeaders(const std::string &name) {
  static const std::set<std::string> others = {"drem",    "finite",  "frexp",       "gamma",      "j0",     "j1",
                                               "jn",      "modf",    "nan",         "nexttoward", "remquo", "scalb",
                                               "scalbln", "signgam", "significand", "y0",         "y1",     "yn"};
  return findMath(name) || others.count(name);
}

bool reservedOutside(const std::string &name, const std::string &model) {
  static const std::set<std::string> adapters = {"q", "qd", "t", "params", "out"},
                                     last = {"dof",        "model",        "description",  "parameter",   "coordinate", "velocity",
                                             "member",     "holonomic",    "nonholonomic", "fits",        "motion",     "motions",
                                             "sites",      "energy",       "simulate",     "residual",    "linearise",  "tangent",
                                             "parameters", "acceleration", "jacobian",     "directional", "constrained"};
  if (reservedInside(name) || inHeaders(name) || adapters.count(name)) return true;
  if (!startsWith(name, model + "_")) return false;
  std::string rest = name.substr(model.size() + 1);
  return last.count(rest) || endsWith(rest, "_jet") || endsWith(rest, "_frame") || endsWith(rest, "_rows");
}

} // namespace

void separateNames(Program &program, const std::string &model) {
  std::map<std::string, int> globals;
  for (const Variable &v : program.variables()) program.names.insert(v.name);
  for (const Function *f : program.functions) program.names.insert(f->name);
  for (const auto &rule : program.rules) program.names.insert({rule.second.function, rule.second.taylor});
  auto renamed = [&](std::string name) {
    do name += "_";
    while (program.names.count(name));
    return name;
  };
  std::map<std::string, std::string> inside; // one new name for all variables of an old one: scopes stay as they are
  for (Variable &v : program.variables()) {
    bool outside = v.scope == Variable::Global, again = outside && ++globals[v.name] > 1; // of another translation unit
    if (again || (outside && reservedOutside(v.name, model) && !reservedInside(v.name))) {
      v.name = renamed(v.name);
      program.names.insert(v.name);
    } else if (reservedInside(v.name)) {
      auto known = inside.emplace(v.name, "");
      if (known.second) known.first->second = renamed(v.name);
      v.name = known.first->second;
    }
  }
  for (const auto &pair : inside) program.names.insert(pair.second);
}

bool reservedFunctionName(const std::string &name, const std::string &model) { return reservedOutside(name, model); }

bool isSource(const std::string &file) { return file.size() > 2 && file.compare(file.size() - 2, 2, ".c") == 0; }

} // namespace tlgen
