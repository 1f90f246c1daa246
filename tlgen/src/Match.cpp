// Finds the functions of the model by options and marks, and what each of their parameters is.
#include "Match.h"

#include "clang/AST/ASTContext.h"
#include "clang/AST/Attr.h"

#include <algorithm>

namespace tlgen {
namespace {

const char *const mark = "tlgen:";

// The text behind "tlgen:" of a mark on the declaration or an earlier one of it; empty where there is none.
std::string markOf(const clang::Decl *decl) {
  for (const clang::Decl *d = decl; d; d = d->getPreviousDecl())
    for (const auto *a : d->specific_attrs<clang::AnnotateAttr>())
      if (a->getAnnotation().substr(0, 6) == mark) return a->getAnnotation().substr(6).str();
  return "";
}

bool parseRole(const std::string &text, ArgRole &role) {
  static const std::pair<const char *, ArgRole> names[] = {
      {"q", ArgRole::Q}, {"qd", ArgRole::Qd}, {"t", ArgRole::T}, {"p", ArgRole::Params}, {"out", ArgRole::Out}};
  for (const auto &n : names)
    if (text == n.first) return role = n.second, true;
  return false;
}

bool isDouble(clang::QualType type) { return type->isSpecificBuiltinType(clang::BuiltinType::Double); }

bool isDoublePointer(clang::QualType type) { return type->isPointerType() && isDouble(type->getPointeeType()); }

bool fitsRole(const clang::ParmVarDecl *param, ArgRole role) {
  clang::QualType type = param->getType();
  switch (role) {
  case ArgRole::Q:
  case ArgRole::Qd:
    return isDoublePointer(type) || isDouble(type);
  case ArgRole::Out:
    return isDoublePointer(type) && !type->getPointeeType().isConstQualified();
  case ArgRole::T:
    return type->isSpecificBuiltinType(clang::BuiltinType::Double);
  case ArgRole::Params:
    return type->isPointerType() && type->getPointeeType()->isStructureType();
  }
  return false;
}

class Matcher {
public:
  Matcher(const Source &source, const Options &options, Diagnostics &diags) : source_(source), options_(options), diags_(diags) {}

  Match run() {
    if (!options_.lagrangian.empty()) addNamed(Role::Lagrangian, options_.lagrangian, "");
    if (!options_.force.empty()) addNamed(Role::Force, options_.force, "");
    if (!options_.dissipation.empty()) addNamed(Role::Dissipation, options_.dissipation, "");
    for (const FunctionOption &f : options_.holonomic) addNamed(Role::Holonomic, f.name, f.rows);
    for (const FunctionOption &f : options_.nonholonomic) addNamed(Role::Nonholonomic, f.name, f.rows);
    addMarked();
    for (const FunctionOption &f : options_.rules) match_.rules[f.name] = f.rows;
    std::stable_sort(match_.functions.begin(), match_.functions.end(),
                     [](const Matched &a, const Matched &b) { return a.role < b.role; });
    checkLagrangian();
    match_.dof = count(options_.dof, options_.dof.empty() ? "no-dof" : "bad-dof",
                       options_.dof.empty() ? "model '" + options_.model + "'" : "--dof " + options_.dof);
    for (const FunctionOption &f : options_.recursion) {
      if (const clang::FunctionDecl *function = source_.find(f.name))
        match_.recursion[function] = count(f.rows, "bad-depth", "--recursion " + f.name + ":" + f.rows);
      else
        diags_.add("no-function", options_.sources[0], 0, 0, "'" + f.name + "'");
    }
    if (match_.dof.value > 0 || !match_.dof.member.empty())
      for (const Matched &m : match_.functions) checkCount(m), checkArrays(m);
    return match_;
  }

private:
  void addNamed(Role role, const std::string &name, const std::string &rows) {
    const clang::FunctionDecl *function = source_.find(name);
    if (!function) return diags_.add("no-function", options_.sources[0], 0, 0, "'" + name + "'");
    add(role, function, rows);
  }

  void addMarked() {
    for (const clang::FunctionDecl *function : source_.definitions()) {
      std::string text = markOf(function), name = text.substr(0, text.find(':'));
      std::string rows = name.size() < text.size() ? text.substr(name.size() + 1) : "";
      if (text.empty() || name == "rule") continue;
      if (name == "lagrangian")
        add(Role::Lagrangian, function, rows);
      else if (name == "force")
        add(Role::Force, function, rows);
      else if (name == "dissipation")
        add(Role::Dissipation, function, rows);
      else if (name == "holonomic")
        add(Role::Holonomic, function, rows);
      else if (name == "nonholonomic")
        add(Role::Nonholonomic, function, rows);
      else
        source_.report("role-unknown", function->getASTContext(), function->getLocation(), "mark '" + text + "'");
    }
  }

  void add(Role role, const clang::FunctionDecl *function, const std::string &rows) {
    for (const Matched &m : match_.functions)
      if (m.role == role && m.function == function) return; // named and marked
    Matched m{role, function, {}, {}};
    bool known = true;
    for (const clang::ParmVarDecl *param : function->parameters()) known &= addArg(m, param);
    if (known) checkArgs(m);
    takeParams(m);
    if (role == Role::Holonomic || role == Role::Nonholonomic)
      m.rows = count(rows.empty() ? "1" : rows, "bad-rows", "'" + function->getNameAsString() + ":" + rows + "'");
    else
      m.rows.value = 1;
    bool returnsRow = function->getReturnType()->isSpecificBuiltinType(clang::BuiltinType::Double);
    if (returnsRow && !(m.rows.member.empty() && m.rows.value == 1))
      fault("role-missing", function, "'" + function->getNameAsString() + "' returns one row");
    match_.functions.push_back(m);
  }

  // False where it is not known what the parameter is.
  bool addArg(Matched &m, const clang::ParmVarDecl *param) {
    Arg arg{ArgRole::Q, -1};
    std::string name = param->getNameAsString(), text = markOf(param);
    auto option = options_.args.find(name);
    if (option != options_.args.end()) text = option->second.role;
    if (text.empty()) text = name;
    bool known = parseRole(text, arg.role);
    if (!known)
      fault("role-unknown", param, "parameter '" + name + "'");
    else if (!fitsRole(param, arg.role))
      fault("role-type", param, "parameter '" + name + "' of type '" + param->getType().getAsString() + "'");
    bool coordinate = (arg.role == ArgRole::Q || arg.role == ArgRole::Qd) && isDouble(param->getType());
    auto sameRole = [&](const Arg &a) { return a.role == arg.role; };
    if (coordinate)
      arg.index = option != options_.args.end() ? option->second.index
                                                : static_cast<int>(std::count_if(m.args.begin(), m.args.end(), sameRole));
    m.args.push_back(arg);
    return known;
  }

  // How many numbers an array parameter has, where that is a constant; 0 where it is not known here.
  long lengthOf(const Matched &m, ArgRole role) const {
    const Count &count = role == ArgRole::Out && m.role != Role::Force ? m.rows : match_.dof;
    return count.member.empty() ? count.value : 0;
  }

  // Declared lengths of the array parameters.
  void checkArrays(const Matched &m) {
    for (size_t i = 0; i < m.args.size(); ++i) {
      const clang::ParmVarDecl *param = m.function->getParamDecl(static_cast<unsigned>(i));
      if (m.args[i].index >= 0 || !isDoublePointer(param->getType())) continue;
      long length = lengthOf(m, m.args[i].role);
      const auto *declared = param->getASTContext().getAsConstantArrayType(param->getOriginalType());
      if (length && declared && static_cast<long>(declared->getSize().getZExtValue()) != length)
        fault("index-range", param,
              "'" + param->getNameAsString() + "' is declared with " + std::to_string(declared->getSize().getZExtValue()) +
                  " numbers and has " + std::to_string(length));
    }
  }

  // Coordinates that are passed one by one must be as many as the model has.
  void checkCount(const Matched &m) {
    for (ArgRole role : {ArgRole::Q, ArgRole::Qd}) {
      long count = std::count_if(m.args.begin(), m.args.end(), [&](const Arg &a) { return a.role == role && a.index >= 0; });
      if (count > 0 && !(match_.dof.member.empty() && match_.dof.value == count))
        fault("scalar-count", m.function,
              "'" + m.function->getNameAsString() + "' takes " + std::to_string(count) + " of " +
                  (match_.dof.member.empty() ? std::to_string(match_.dof.value) : match_.dof.member) +
                  (role == ArgRole::Q ? " coordinates" : " velocities"));
    }
  }

  void checkArgs(const Matched &m) {
    bool seen[5] = {};
    for (size_t i = 0; i < m.args.size(); ++i) {
      bool &s = seen[static_cast<int>(m.args[i].role)];
      bool twice = std::any_of(m.args.begin(), m.args.begin() + static_cast<long>(i),
                               [&](const Arg &a) { return a.role == m.args[i].role && (a.index < 0 || a.index == m.args[i].index); });
      if (twice || (s && m.args[i].index < 0))
        fault("role-twice", m.function->getParamDecl(static_cast<unsigned>(i)),
              "parameter '" + m.function->getParamDecl(static_cast<unsigned>(i))->getNameAsString() + "'");
      s = true;
    }
    bool returns = m.function->getReturnType()->isSpecificBuiltinType(clang::BuiltinType::Double);
    bool out = seen[static_cast<int>(ArgRole::Out)];
    std::string name = "'" + m.function->getNameAsString() + "'";
    bool silent = m.function->getReturnType()->isVoidType() || m.function->getReturnType()->isIntegerType(); // a code of success
    if (returns == out || (!returns && !silent)) fault("role-missing", m.function, name + " has no result, or two");
    if (m.role == Role::Force && !out) fault("role-missing", m.function, name + " has no 'out'");
    const bool constant = m.role == Role::Force; // a force may be
    if (!constant && !seen[static_cast<int>(ArgRole::Q)] && !seen[static_cast<int>(ArgRole::Qd)])
      fault("role-missing", m.function, name + " takes no coordinates");
    else if (m.role == Role::Dissipation && !seen[static_cast<int>(ArgRole::Qd)])
      fault("role-missing", m.function, name + " takes no velocities, so it dissipates nothing");
    if (m.role == Role::Nonholonomic && !seen[static_cast<int>(ArgRole::Qd)])
      fault("role-missing", m.function, name + " takes no velocities, so it is holonomic: say --holonomic");
    if (m.role == Role::Holonomic && seen[static_cast<int>(ArgRole::Qd)])
      fault("role-missing", m.function,
            name + " takes velocities, so it is not holonomic: a constraint on velocities is --nonholonomic");
  }

  void takeParams(const Matched &m) {
    for (size_t i = 0; i < m.args.size(); ++i) {
      const clang::ParmVarDecl *param = m.function->getParamDecl(static_cast<unsigned>(i));
      if (m.args[i].role != ArgRole::Params || !fitsRole(param, ArgRole::Params)) continue;
      const clang::RecordDecl *record = param->getType()->getPointeeType()->getAsStructureType()->getDecl()->getDefinition();
      if (!record) return fault("role-type", param, "parameter '" + param->getNameAsString() + "' of an incomplete struct");
      if (!match_.params)
        match_.params = record;
      else if (match_.params->getNameAsString() != record->getNameAsString() ||
               match_.params->getASTContext().getTypeDeclType(match_.params).getAsString() !=
                   record->getASTContext().getTypeDeclType(record).getAsString())
        fault("params-differ", param, "parameter '" + param->getNameAsString() + "'");
    }
  }

  void checkLagrangian() {
    std::map<Role, const clang::FunctionDecl *> first;
    for (const Matched &m : match_.functions) {
      if (m.role == Role::Holonomic || m.role == Role::Nonholonomic) continue;
      const clang::FunctionDecl *&slot = first[m.role];
      if (slot) fault("role-twice", m.function, "'" + m.function->getNameAsString() + "' beside '" + slot->getNameAsString() + "'");
      slot = m.function;
    }
    if (!first.count(Role::Lagrangian) && options_.lagrangian.empty())
      diags_.add("no-lagrangian", options_.sources[0], 0, 0, "model '" + options_.model + "'");
  }

  // A positive constant or an integer member of the parameter struct.
  Count count(const std::string &text, const char *id, const std::string &what) {
    Count c;
    bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() < 8;
    if (digits) c.value = std::stol(text);
    if (c.value > 0) return c;
    if (!digits && match_.params)
      for (const clang::FieldDecl *field : match_.params->fields())
        if (field->getNameAsString() == text && field->getType()->isIntegerType()) return c.member = text, c;
    diags_.add(id, options_.sources[0], 0, 0, what);
    return c;
  }

  void fault(const char *id, const clang::NamedDecl *at, const std::string &what) {
    source_.report(id, at->getASTContext(), at->getLocation(), what);
  }

  const Source &source_;
  const Options &options_;
  Diagnostics &diags_;
  Match match_;
};

} // namespace

std::string ruleOf(const clang::FunctionDecl *external, const Match &match) {
  auto named = match.rules.find(external->getNameAsString());
  if (named != match.rules.end()) return named->second;
  std::string text = markOf(external);
  return text.compare(0, 5, "rule:") == 0 ? text.substr(5) : "";
}

Match matchModel(const Source &source, const Options &options, Diagnostics &diags) { return Matcher(source, options, diags).run(); }

} // namespace tlgen
