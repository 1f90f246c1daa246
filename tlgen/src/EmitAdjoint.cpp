// The adjoint emitter: which functions, in which form, and the tables beside them.
#include "EmitAdjoint.h"
#include "Report.h"
#include "Trace.h"

#include <algorithm>
#include <optional>

namespace tlgen {
namespace {

// Characters of one function: compilers take minutes for much longer ones.
const size_t longestFunction = 100000;

// The same of sums and products alone, without branches and functions.
const size_t longestSolution = 400000;

// Functions of eom_motion; the last four are solved forms, which come with the needs that they are made of.
const std::vector<std::pair<std::string, std::string>> &allFunctions() {
  static const std::vector<std::pair<std::string, std::string>> functions = {
      {"energy", "energy"},       {"simulate", "simulate"},     {"residual", "residual"},     {"linearise", "linearise"},
      {"tangent", "tangent"},     {"parameters", "parameters"}, {"acceleration", "simulate"}, {"jacobian", "linearise"},
      {"directional", "tangent"}, {"constrained", "simulate"},  {"taylor", "taylor"}};
  return functions;
}

bool isSolved(const std::string &function) { return function == "acceleration" || function == "jacobian" || function == "directional"; }

// The same list with the needs that others are built on.
std::set<std::string> completed(std::set<std::string> needs) {
  if (needs.count("linearise") || needs.count("tangent") || needs.count("parameters") || needs.count("taylor"))
    needs.insert("simulate");
  return needs;
}

class MotionEmitter {
public:
  MotionEmitter(const Program &program, const Model &model, const MotionOptions &options, Diagnostics &diags)
      : program_(program), model_(model), options_(options), diags_(diags), name_(model.name), functions_(program, model, sites_) {}

  MotionText run() {
    const std::set<std::string> needs = completed(options_.needs);
    for (auto &[function, need] : allFunctions()) {
      bool based = function == need || has(need); // jacobian beside linearise, linearise beside simulate
      if (need == "linearise" || need == "tangent" || need == "parameters") based = based && has("simulate");
      if (!needs.count(need) || !based) continue;
      if (function == "constrained") {
        if (constrained()) printConstrained();
        continue;
      }
      if (function == "taylor") {
        printTaylor();
        continue;
      }
      if (isSolved(function) && constrained()) continue;
      print(function);
      if (options_.lanes && isSolved(function)) printLanes(function + "_lanes");
    }
    MotionText text;
    if (printed_.empty()) return text;
    text.source = fits() + identity() + definitions_ + description();
    text.header = header();
    text.n = last_->n, text.m1 = last_->m1, text.m2 = last_->m2, text.work = workspace_;
    text.constantMass = has("simulate") && last_->constantMass();
    text.functions = printed_;
    text.sizes = options_.sizes;
    text.report = report();
    return text;
  }

private:
  bool has(const std::string &function) const { return std::count(printed_.begin(), printed_.end(), function) > 0; }

  bool constrained() const {
    return std::any_of(model_.functions.begin(), model_.functions.end(),
                       [](const ModelFunction &f) { return f.role == Role::Holonomic || f.role == Role::Nonholonomic; });
  }

  long coordinates() const { return model_.dof.member.empty() ? model_.dof.value : options_.sizes.at(model_.dof.member); }

  MotionValues &values(bool rows) {
    auto &made = values_[rows];
    if (!made) made = std::make_unique<MotionValues>(program_, model_, options_, rows);
    return *made;
  }

  // The function in one form; nothing where that cannot be.
  struct Candidate {
    std::optional<MotionFunction> made;
    std::optional<Unsuitable> why; // not
  };

  Candidate candidate(const std::string &function, bool rows) {
    Candidate c;
    try {
      c.made = functions_.print(function, values(rows));
    } catch (const Unsuitable &why) {
      c.why = why;
    }
    return c;
  }

  double estimate(const Candidate &c, bool rows) const { return options_.cost.estimate(c.made->operations, rows); }

  // In the form that is asked for or estimated to be faster, or in the other one where that cannot be.
  void print(const std::string &function) {
    const bool few = coordinates() <= MOST_IN_REGISTERS, open = options_.form == Form::Auto && few;
    bool rows = options_.form == Form::Auto ? !few : options_.form == Form::Rows;
    std::string why = options_.form != Form::Auto ? "asked for" : few ? "estimated" : "many coordinates";
    Candidate made[2];
    made[rows] = candidate(function, rows);
    if (open || !made[rows].made) made[!rows] = candidate(function, !rows);
    if (!made[0].made && !made[1].made) {
      if (function != "parameters") throw *made[rows].why; // what the others are made of
      return leaveOut("parameters-unsuitable", function, *made[rows].why);
    }
    const bool both = made[0].made && made[1].made;
    if (both)
      rows = estimate(made[true], true) < estimate(made[false], false);
    else if (!made[rows].made)
      rows = !rows, why = "the only one";
    take(function, rows, why, made);
  }

  // The same for many states at once, in registers.
  void printLanes(const std::string &function) {
    const bool rows = false;
    Candidate made[2];
    if (coordinates() <= MOST_IN_LANES)
      made[rows] = candidate(function, rows);
    else
      made[rows].why = Unsuitable{"straight-line code for more than " + std::to_string(MOST_IN_LANES) + " coordinates is too long", {}};
    if (made[rows].made)
      take(function, rows, "lanes", made);
    else
      leaveOut("lanes-unsuitable", function, *made[rows].why);
  }

  // The solution of the constrained equations, in registers: where few coordinates or few numbers other than zero make it short. The
  // general solver needs no such function.
  void printConstrained() {
    const bool rows = false, forced = options_.form == Form::Registers;
    if (options_.form == Form::Rows || (!forced && coordinates() > MOST_IN_REGISTERS && !isSparse())) return;
    Candidate made[2];
    made[rows] = candidate("constrained", rows);
    if (!made[rows].made)
      report_.proved.push_back("No solution of the constrained equations: " + made[rows].why->why + ".");
    else if (readLength(made[rows].made->definition) <= longestSolution)
      take("constrained", rows, forced ? "asked for" : "the only one", made);
  }

  // Coefficients along a motion, in registers; without them there are other methods.
  void printTaylor() {
    const bool rows = false;
    Candidate made[2];
    made[rows] = candidate("taylor", rows);
    if (made[rows].made)
      take("taylor", rows, "the only one", made);
    else
      leaveOut("taylor-unsuitable", "taylor", *made[rows].why);
  }

  // Whether M has few elements in each row, as the functions before say. How many A has is only seen in registers.
  bool isSparse() { return classesOf(last_->results("simulate"), "M", last_->n, last_->n).entries <= 4 * last_->n; }

  void leaveOut(const char *id, const std::string &function, const Unsuitable &why) {
    diags_.add(id, program_, why.loc, "'" + function + "': " + why.why);
  }

  void take(const std::string &function, bool rows, const std::string &why, const Candidate (&made)[2]) {
    const MotionFunction &f = *made[rows].made;
    if (const size_t length = readLength(f.definition);
        length > longestFunction && options_.form == Form::Auto && function != "constrained" && function != "taylor") {
      std::string size = std::to_string(length / 1000);
      diags_.add("adjoint-large", program_, model_.functions[0].function->loc, "'" + function + "' would be " + size + " kB of C");
      return;
    }
    definitions_ += f.definition;
    prototypes_ += f.prototype;
    workspace_ = std::max(workspace_, f.workspace);
    printed_.push_back(function);
    last_ = &values(rows);
    for (bool form : {false, true})
      if (made[form].made) report_.forms.push_back({function, form, form == rows, why, *made[form].made, estimate(made[form], form)});
    reportMatrices(function);
  }

  // Of the needs that have matrices; others share them.
  void reportMatrices(const std::string &function) {
    const long n = last_->n, columns = function == "linearise" ? 2 * n : function == "parameters" ? long(last_->parameters.size()) : n;
    static const std::map<std::string, std::vector<std::string>> matrices = {
        {"simulate", {"M", "A_phi", "A_psi"}}, {"linearise", {"r_y", "g_y"}}, {"parameters", {"r_p", "g_p"}}};
    auto known = matrices.find(function);
    if (known == matrices.end()) return;
    for (const std::string &name : known->second) {
      const RowClasses classes = classesOf(last_->results(function), name, columns, function == "parameters" ? columns : n);
      if (classes.all) report_.matrices.push_back({name, classes});
    }
  }

  std::string report() {
    report_.model = name_;
    const Analyses &on = options_.analyses;
    report_.proved.push_back(last_->autonomous ? "t occurs in no equation."
                             : on.time         ? "t occurs in the equations."
                                               : "t: not looked at.");
    if (has("simulate"))
      report_.proved.push_back(last_->constantMass() ? "M depends on parameters alone."
                               : on.constantMass     ? "M depends on the state."
                                                     : "M: not looked at.");
    for (const Analysis &a : allAnalyses())
      if (!(on.*(a.on))) report_.proved.push_back("Without " + std::string(a.name) + ": " + a.off + ".");
    return options_.reportAsCsv ? report_.csv() : report_.text();
  }

  std::string fits() const {
    std::string test;
    for (const auto &size : options_.sizes)
      test += (test.empty() ? "" : " && ") + (std::string(TRACE_PARAMS) + "->" + size.first) + " == " + std::to_string(size.second);
    std::string body = "  (void)params;\n  return 1;\n";
    if (!test.empty()) body = "  const " + model_.params->spelling + " *const " + TRACE_PARAMS + " = params;\n  return " + test + ";\n";
    return "/* Whether the parameters have the sizes that the functions below are for. */\nstatic int " + name_ +
           "_fits(const void *params)\n{\n" + body + "}\n\n";
  }

  // What the functions read where they were made without activity.
  std::string identity() const {
    const Identity &identity = last_->identity;
    if (definitions_.find(identity.name) == std::string::npos) return "";
    std::string ones;
    for (long k = 0; k < identity.stride; ++k) ones += (k ? ", [" : "[") + std::to_string(k * identity.stride + k) + "] = TL_C(1.0)";
    return "static const tl_real " + identity.name + "[" + std::to_string(identity.stride * identity.stride) + "] = {" + ones +
           "};\n\n";
  }

  // A constant array and its length as members of the description.
  std::string list(const std::string &type, const std::string &name, const std::vector<std::string> &items, std::string &members,
                   const std::string &member, const std::string &count) const {
    if (items.empty()) return "";
    std::string s = "static const " + type + name_ + "_" + name + "[] = {\n";
    for (const std::string &item : items) s += "  " + item + ",\n";
    members += "  ." + member + " = " + name_ + "_" + name + ",\n  ." + count + " = " + std::to_string(items.size()) + ",\n";
    return s + "};\n\n";
  }

  std::string description() const {
    std::vector<std::string> sites, parameters;
    for (const Sites::Site &site : sites_.all())
      sites.push_back("{TL_FN_" + site.function + ", \"" + program_.files[size_t(site.loc.file)] + "\", " +
                      std::to_string(site.loc.line) + "}");
    if (has("parameters"))
      for (const std::string &p : last_->parameters) parameters.push_back("\"" + p + "\"");
    auto number = [](const std::string &member, long value) { return "  ." + member + " = " + std::to_string(value) + ",\n"; };
    std::string members = number("n", last_->n) + number("m1", last_->m1) + number("m2", last_->m2) + "  .fits = " + name_ +
                          "_fits,\n" + number("work", workspace_);
    if (last_->autonomous) members += number("autonomous", 1);
    if (has("simulate") && last_->constantMass()) members += number("constant_mass", 1);
    const std::string names = list("char *const ", "parameter", parameters, members, "parameter", "np");
    std::string s = list("eom_site ", "sites", sites, members, "sites", "nsite") + names;
    const bool lanes =
        std::any_of(printed_.begin(), printed_.end(), [&](const std::string &f) { return f.find("_lanes") != std::string::npos; });
    if (lanes) members += "  .lanes = TL_LANES,\n";
    for (const std::string &function : printed_) members += "  ." + function + " = " + name_ + "_" + function + ",\n";
    return s + "const eom_motion " + name_ + "_motion = {\n" + members + "};\n\n";
  }

  std::string header() const {
    std::string sizes;
    for (const auto &size : options_.sizes)
      sizes += (sizes.empty() ? " with " : ", ") + size.first + " = " + std::to_string(size.second);
    return "\n/* Its motion" + sizes + ": what the functions compute is said in eom/motion.h. */\nextern const eom_motion " + name_ +
           "_motion;\n" + prototypes_;
  }

  const Program &program_;
  const Model &model_;
  const MotionOptions &options_;
  Diagnostics &diags_;
  const std::string name_;
  Sites sites_;
  MotionFunctions functions_;
  std::unique_ptr<MotionValues> values_[2]; // in registers, in rows
  MotionValues *last_ = nullptr;
  std::vector<std::string> printed_;
  std::string definitions_, prototypes_;
  Report report_;
  long workspace_ = 0;
};

// Sizes that a count needs and nobody gave, or the reverse; null where all is well.
std::string missingSizes(const Model &model, const MotionOptions &options) {
  std::set<std::string> members;
  auto need = [&](const Count &count) {
    if (!count.member.empty() && !options.sizes.count(count.member)) members.insert(count.member);
  };
  need(model.dof);
  for (const ModelFunction &f : model.functions) need(f.rows);
  std::string s;
  for (const std::string &member : members) s += (s.empty() ? "" : ", ") + member;
  return s;
}

// The first size of something that is no integer member; empty where there is none.
std::string wrongSize(const Model &model, const MotionOptions &options) {
  for (const auto &size : options.sizes) {
    bool known = false;
    for (const Field &field : model.params ? model.params->fields : std::vector<Field>())
      known |= field.name == size.first && field.type->kind == Type::Integer;
    if (!known) return size.first;
  }
  return "";
}

// The first member to differentiate by that is no number and no array of numbers; empty where there is none.
std::string wrongParameter(const Model &model, const MotionOptions &options) {
  for (const std::string &member : options.parameters)
    if (!numberMember(model, member)) return member;
  return "";
}

} // namespace

const std::vector<std::string> &allNeeds() {
  static const std::vector<std::string> needs = {"energy", "simulate", "residual", "linearise", "tangent", "parameters", "taylor"};
  return needs;
}

std::string reportHeader() { return Report::csvHeader(); }

MotionText emitAdjoint(const Program &program, const Model &model, const MotionOptions &options, Diagnostics &diags) {
  Loc place = model.functions[0].function->loc;
  const std::string wrong = wrongSize(model, options), missing = missingSizes(model, options), unknown = wrongParameter(model, options);
  if (!wrong.empty()) diags.add("bad-size", program, place, "'" + wrong + "'");
  if (!unknown.empty()) diags.add("bad-parameter", program, place, "'" + unknown + "'");
  if (options.needs.empty() || !wrong.empty() || !unknown.empty()) return {};
  if (!missing.empty()) {
    diags.add("no-size", program, place, "'" + missing + "'");
    return {};
  }
  try {
    return MotionEmitter(program, model, options, diags).run();
  } catch (const Unsuitable &u) {
    diags.add(u.id, program, u.loc, u.why);
    return {};
  }
}

} // namespace tlgen
