// The adjoint emitter: trace, needs, functions, tables.
#include "EmitAdjoint.h"
#include "Needs.h"
#include "PrintGraph.h"
#include "Trace.h"

#include <algorithm>
#include <optional>

namespace tlgen {
namespace {

// Up to here the form of registers is the faster one (bench/README.md).
const long mostInRegisters = 8;

bool isWordPart(char ch) { return isalnum(static_cast<unsigned char>(ch)) || ch == '_'; }

bool usesWord(const std::string &text, const std::string &word) {
  for (size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) {
    size_t end = at + word.size();
    if ((at == 0 || !isWordPart(text[at - 1])) && (end == text.size() || !isWordPart(text[end]))) return true;
  }
  return false;
}

std::string indented(const std::string &text) {
  std::string s;
  for (size_t at = 0, end; at < text.size(); at = end) {
    end = text.find('\n', at) + 1;
    s += "  " + text.substr(at, end - at);
  }
  return s;
}

// Functions of eom_motion; the last three are solved forms, which come with the needs that they are made of.
const std::vector<std::string> &allFunctions() {
  static const std::vector<std::string> functions = [] {
    std::vector<std::string> all = allNeeds();
    all.insert(all.end(), {"acceleration", "jacobian", "directional"});
    return all;
  }();
  return functions;
}

class MotionEmitter {
public:
  MotionEmitter(const Program &program, const Model &model, const MotionOptions &options)
      : program_(program), model_(model), options_(options), name_(model.name) {}

  MotionText run() {
    traceAll();
    std::string functions;
    for (const std::string &need : allFunctions())
      if (wanted(need)) functions += function(need);
    if (needs_->noFormula())
      throw Unsuitable{"the derivative of '" + needs_->noFormula()->text + "' has no formula", needs_->noFormula()->loc};
    MotionText text;
    text.source = fits() + functions + description();
    text.header = header();
    text.report = report_;
    return text;
  }

private:
  // What is printed of one function.
  struct Printing {
    Printing(MotionEmitter &of, std::vector<Phase> phases)
        : schedule(of.graph_, std::move(phases)), printer(schedule, of.program_, of.sites_, of.takenNames()) {}
    Schedule schedule;
    GraphPrinter printer;
  };

  bool constrained() const { return m1_ + m2_ > 0; }

  bool wanted(const std::string &function) const {
    static const std::map<std::string, std::string> of = {
        {"acceleration", "simulate"}, {"jacobian", "linearise"}, {"directional", "tangent"}};
    auto solved = of.find(function);
    if (solved == of.end()) return options_.needs.count(function) > 0;
    return !constrained() && options_.needs.count(solved->second);
  }

  long number(const Count &count) const { return count.member.empty() ? count.value : options_.sizes.at(count.member); }

  void traceAll() {
    TraceOptions how;
    how.sizes = options_.sizes;
    n_ = equations_.n = number(model_.dof);
    rows_ = options_.form == Form::Rows;
    how.keepLoops = rows_;
    for (const ModelFunction &f : model_.functions) {
      Traced traced = trace(graph_, program_, model_, f, how);
      if (f.role == Role::Lagrangian) equations_.lagrangian = traced.value;
      if (f.role == Role::Force) equations_.force = traced.rows;
      if (f.role == Role::Holonomic) equations_.holonomic.push_back(traced.rows), m1_ += traced.rows->length;
      if (f.role == Role::Nonholonomic) equations_.nonholonomic.push_back(traced.rows), m2_ += traced.rows->length;
    }
    needs_ = std::make_unique<Needs>(graph_, equations_, true);
  }

  std::set<std::string> takenNames() const {
    std::set<std::string> names = {"params", "q",        "qd",         "t",      "qdd",   "lambda", "k",    "c",    "w",     "work",
                                   "out",    "momentum", "lagrangian", "energy", "r",     "M",      "Q",    "A",    "b",     "LD",
                                   "dinv",   "pivot",    "r_y",        "g_y",    "r_w",   "g_w",    "r_p",  "g_p",  "phi",   "phi_dot",
                                   "psi",    "qdd_y",    "dqdd",       "x",      "sines", "cosines", "B",   "row",  "column", "auto",
                                   "register", "restrict", "inline",   "signed", "sum",   "solved"};
    names.insert(TRACE_PARAMS);
    for (const Variable *v : program_.globals) names.insert(v->name);
    for (const Function *f : program_.functions) names.insert(f->name);
    for (const auto &rule : program_.rules) names.insert({rule.second.function, rule.second.taylor});
    return names;
  }

  // Results of a need, computed once for all functions that use them.
  Results &results(const std::string &need) {
    auto known = results_.find(need);
    if (known != results_.end()) return known->second;
    Results made = need == "energy"      ? needs_->energy()
                   : need == "simulate"  ? needs_->simulate()
                   : need == "residual"  ? needs_->residual()
                   : need == "linearise" ? needs_->linearise()
                   : need == "tangent"   ? needs_->tangent()
                                         : needs_->parameters(columns_, np_);
    return results_.emplace(need, std::move(made)).first->second;
  }

  static Phase phase(const Results &results, const std::vector<std::string> &names) {
    Phase p;
    for (const std::string &name : names) {
      auto array = results.arrays.find(name);
      if (array != results.arrays.end()) p.arrays.push_back(array->second);
    }
    return p;
  }

  static void bind(Printing &p, const Results &results, const std::string &name, const std::string &to, long columns = 0) {
    auto array = results.arrays.find(name);
    if (array != results.arrays.end()) p.printer.bind(array->second, to, columns);
  }

  // One function: its frame around the statements. tail: after all that can fail for a place in the source.
  std::string define(const std::string &function, const std::string &args, Printing &p, const std::string &statements, const std::string &tail) {
    std::string body = p.printer.declarations() + statements + p.printer.returnSite() + tail, start;
    workspace_ = std::max(workspace_, p.printer.workspace());
    for (const char *arg : {"q", "qd", "t", "qdd", "lambda", "work"}) {
      bool there = usesWord(args, arg) || std::string("q qd t work").find(arg) != std::string::npos;
      if (there && !usesWord(body, arg)) start += (start.empty() ? "  (void)" : ", (void)") + std::string(arg);
    }
    if (!model_.params) start += start.empty() ? "  (void)params" : ", (void)params";
    if (!start.empty()) start += ";\n";
    if (model_.params && usesWord(body, TRACE_PARAMS))
      start += "  const " + model_.params->spelling + " *const " + TRACE_PARAMS + " = params;\n";
    if (model_.params) start += "  if (!" + name_ + "_fits(params)) return EOM_MOTION_SIZE;\n";
    return "int " + name_ + "_" + function + "(const void *params, const tl_real *restrict q, const tl_real *restrict qd, tl_real t, " + args +
           ", tl_real *restrict work)\n{\n" + start + body + "  return 0;\n}\n\n";
  }

  static std::string finite(const std::string &array, long count) {
    if (!count) return "";
    return "  if (!tl_finite_array(" + std::to_string(count) + ", " + array + ")) return EOM_MOTION_NOT_FINITE;\n";
  }

  std::string function(const std::string &need) {
    if (need == "energy") return energy();
    if (need == "simulate") return simulate();
    if (need == "residual") return residual();
    if (need == "linearise") return derivatives(need, "y", 2 * n_, "tl_real *restrict r_y, tl_real *restrict g_y");
    if (need == "tangent") return tangent();
    if (need == "parameters") return derivatives(need, "p", np_, "tl_real *restrict r_p, tl_real *restrict g_p");
    if (need == "acceleration") return acceleration();
    if (need == "jacobian") return jacobian();
    return directional();
  }

  std::string energy() {
    Results &values = results("energy");
    Printing p(*this, {phase(values, {"momentum", "lagrangian"})});
    bind(p, values, "momentum", "momentum[%]");
    bind(p, values, "lagrangian", "lagrangian[%]");
    std::string statements = p.printer.phase(0);
    std::string n = std::to_string(n_);
    std::string tail = "  tl_real sum = -lagrangian[0];\n  for (int i = 0; i < " + n +
                       "; ++i) sum += momentum[i] * qd[i];\n  energy[0] = sum;\n" + finite("momentum", n_) +
                       "  if (!TL_ISFINITE(lagrangian[0]) || !TL_ISFINITE(sum)) return EOM_MOTION_NOT_FINITE;\n";
    return define("energy", "tl_real *restrict momentum, tl_real *restrict lagrangian, tl_real *restrict energy", p, statements, tail);
  }

  std::string simulate() {
    Results &values = results("simulate");
    Printing p(*this, {phase(values, {"M", "Q", "phi", "phi_dot", "b_phi", "A_phi", "psi", "b_psi", "A_psi"})});
    std::string locals;
    auto give = [&](const std::string &name, const std::string &part, const std::string &offset, long columns) {
      if (!values.arrays.count(name)) return;
      bind(p, values, name, name + "[%]", columns);
      locals += "  tl_real *const restrict " + name + " = out->" + part + (offset.empty() ? "" : " + " + offset) + ";\n";
    };
    std::string behind = m1_ && m2_ ? std::to_string(m1_) : "", rows = m1_ && m2_ ? std::to_string(m1_ * n_) : "";
    for (const char *name : {"M", "Q", "phi", "phi_dot", "psi"}) give(name, name, "", 0);
    give("b_phi", "b", "", 0), give("A_phi", "A", "", 0);
    give("b_psi", "b", behind, 0), give("A_psi", "A", rows, 0);
    std::string n = std::to_string(n_), statements = locals + p.printer.phase(0);
    std::string mirror = "  for (int i = 1; i < " + n + "; ++i)\n    for (int j = 0; j < i; ++j) M[i*" + n + " + j] = M[j*" + n + " + i];\n";
    long m = m1_ + m2_;
    std::string tail = (n_ > 1 ? mirror : "") + finite("M", n_ * n_) + finite("Q", n_) + finite("out->phi", m1_) + finite("out->phi_dot", m1_) +
                       finite("out->psi", m2_) + finite("out->A", m * n_) + finite("out->b", m);
    return define("simulate", "const eom_parts *out", p, statements, tail);
  }

  std::string residual() {
    Results &values = results("residual");
    Printing p(*this, {phase(values, {"r"})});
    bind(p, values, "r", "r[%]");
    std::string statements = p.printer.phase(0);
    return define("residual", "const tl_real *restrict qdd, tl_real *restrict r", p, statements, finite("r", n_));
  }

  // r_y and g_y, or r_p and g_p.
  std::string derivatives(const std::string &need, const std::string &suffix, long columns, const std::string &outputs) {
    Results &values = results(need);
    std::string r = "r_" + suffix, g = "g_" + suffix;
    Printing p(*this, {phase(values, {r, g})});
    bind(p, values, r, r + "[%]");
    bind(p, values, g, g + "[%]");
    std::string statements = p.printer.phase(0);
    if (!constrained()) statements += "  (void)" + g + ";\n";
    return define(need, "const tl_real *restrict qdd, const tl_real *restrict lambda, " + outputs, p, statements,
                  finite(r, n_ * columns) + finite(g, (m1_ + m2_) * columns));
  }

  // One direction after the other.
  std::string tangent() {
    Results &values = results("tangent");
    Printing p(*this, {phase(values, {"r_w", "g_w"})});
    bind(p, values, "r_w", "r_w[%*k + c]", 1);
    bind(p, values, "g_w", "g_w[%*k + c]", 1);
    std::string statements = "  for (int c = 0; c < k; ++c) {\n" + indented(p.printer.phase(0)) + "  }\n";
    if (!constrained()) statements += "  (void)g_w;\n";
    std::string tail = finite("r_w", n_), m = std::to_string(m1_ + m2_), n = std::to_string(n_);
    tail = "  if (!tl_finite_array(" + n + "*k, r_w)) return EOM_MOTION_NOT_FINITE;\n";
    if (constrained()) tail += "  if (!tl_finite_array(" + m + "*k, g_w)) return EOM_MOTION_NOT_FINITE;\n";
    return define("tangent",
                  "const tl_real *restrict qdd, const tl_real *restrict lambda, int k, const tl_real *restrict w, tl_real *restrict r_w, "
                  "tl_real *restrict g_w",
                  p, statements, tail);
  }

  // M, Q and from these qdd.
  std::string solve(Printing &p) {
    Results &values = results("simulate");
    std::string n = std::to_string(n_);
    bind(p, values, "M", "M[%*LD + %]", n_);
    bind(p, values, "Q", "Q[%]");
    return "  enum { LD = TL_LDL_ROW(" + n + ") };\n  tl_real M[" + n + " * LD], Q[" + n + "], dinv[TL_ROW(" + n + ")], qdd[" + n + "];\n" +
           p.printer.phase(0) + "  const tl_real pivot = tl_ldl_factor_solve(" + n + ", qdd, M, LD, dinv, Q);\n";
  }

  std::string checkPivot() const { return "  if (!(pivot > EOM_MOTION_LEAST_PIVOT(" + std::to_string(n_) + "))) return EOM_MOTION_PIVOT;\n"; }

  // Copies n numbers of a local array to the output.
  std::string copyOut() const { return "  for (int i = 0; i < " + std::to_string(n_) + "; ++i) solved[i] = qdd[i];\n"; }

  std::string acceleration() {
    Printing p(*this, {phase(results("simulate"), {"M", "Q"})});
    std::string statements = solve(p);
    return define("acceleration", "tl_real *restrict solved", p, statements, copyOut() + checkPivot() + finite("qdd", n_));
  }

  std::string jacobian() {
    Results &values = results("linearise");
    Printing p(*this, {phase(results("simulate"), {"M", "Q"}), phase(values, {"r_y"})});
    std::string n = std::to_string(n_), columns = std::to_string(2 * n_);
    bind(p, values, "r_y", "B[%*TL_ROW(" + columns + ") + %]", 2 * n_);
    std::string statements = solve(p);
    statements += "  tl_real B[" + n + " * TL_ROW(" + columns + ")];\n" + p.printer.phase(1) + "  tl_ldl_solve_many(" + n + ", " + columns +
                  ", B, TL_ROW(" + columns + "), M, LD, dinv);\n";
    std::string tail = "  for (int i = 0; i < " + n + "; ++i)\n    for (int j = 0; j < " + columns + "; ++j) qdd_y[i*" + columns +
                       " + j] = -B[i*TL_ROW(" + columns + ") + j];\n" + copyOut() + checkPivot() + finite("qdd", n_) +
                       finite("qdd_y", 2 * n_ * n_);
    return define("jacobian", "tl_real *restrict solved, tl_real *restrict qdd_y", p, statements, tail);
  }

  std::string directional() {
    Results &values = results("tangent");
    Printing p(*this, {phase(results("simulate"), {"M", "Q"}), phase(values, {"r_w"})});
    std::string n = std::to_string(n_);
    bind(p, values, "r_w", "B[%]");
    std::string statements = solve(p) + checkPivot();
    statements += "  for (int c = 0; c < k; ++c) {\n    tl_real B[" + n + "];\n" + indented(p.printer.phase(1)) + "    tl_ldl_solve(" + n +
                  ", B, M, LD, dinv, B);\n    for (int i = 0; i < " + n + "; ++i) dqdd[i*k + c] = -B[i];\n  }\n";
    std::string tail = copyOut() + finite("qdd", n_) + "  if (!tl_finite_array(" + n + "*k, dqdd)) return EOM_MOTION_NOT_FINITE;\n";
    return define("directional", "int k, const tl_real *restrict w, tl_real *restrict solved, tl_real *restrict dqdd", p, statements, tail);
  }

  std::string fits() const {
    std::string test;
    std::set<std::string> members;
    for (const auto &size : options_.sizes)
      test += (test.empty() ? "" : " && ") + (std::string("p->") + size.first) + " == " + std::to_string(size.second);
    std::string body = "  (void)params;\n  return 1;\n";
    if (!test.empty()) body = "  const " + model_.params->spelling + " *const p = params;\n  return " + test + ";\n";
    return "/* Whether the parameters have the sizes that the functions below are for. */\nstatic int " + name_ +
           "_fits(const void *params)\n{\n" + body + "}\n\n";
  }

  std::vector<std::string> present() const {
    std::vector<std::string> all;
    for (const std::string &need : allFunctions())
      if (wanted(need)) all.push_back(need);
    return all;
  }

  std::string description() const {
    std::string s, sites = "NULL";
    if (!sites_.all().empty()) {
      sites = name_ + "_sites";
      s += "static const eom_site " + sites + "[] = {\n";
      for (const Sites::Site &site : sites_.all())
        s += "  {TL_FN_" + site.function + ", \"" + program_.files[size_t(site.loc.file)] + "\", " + std::to_string(site.loc.line) + "},\n";
      s += "};\n\n";
    }
    s += "const eom_motion " + name_ + "_motion = {\n  .n = " + std::to_string(n_) + ",\n  .m1 = " + std::to_string(m1_) +
         ",\n  .m2 = " + std::to_string(m2_) + ",\n  .fits = " + name_ + "_fits,\n  .work = " + std::to_string(workspace_) +
         ",\n  .sites = " + sites + ",\n  .nsite = " + std::to_string(sites_.all().size()) + ",\n";
    for (const std::string &need : present()) s += "  ." + need + " = " + name_ + "_" + need + ",\n";
    return s + "};\n\nstatic const eom_motion *const " + name_ + "_motions[] = {&" + name_ + "_motion};\n\n";
  }

  std::string header() const {
    std::string s = "/* Its motion with";
    std::string sizes;
    for (const auto &size : options_.sizes) sizes += (sizes.empty() ? " " : ", ") + size.first + " = " + std::to_string(size.second);
    s = "/* Its motion" + (sizes.empty() ? "" : " with" + sizes) + ": eom/motion.h says what each function computes. */\nextern const eom_motion " +
        name_ + "_motion;\n";
    for (const std::string &need : present()) s += "extern eom_" + need + "_fn " + name_ + "_" + need + ";\n";
    return s;
  }

  const Program &program_;
  const Model &model_;
  const MotionOptions &options_;
  const std::string name_;
  Graph graph_;
  Equations equations_;
  std::unique_ptr<Needs> needs_;
  std::map<std::string, Results> results_;
  std::vector<ParameterColumns> columns_;
  Sites sites_;
  long n_ = 0, m1_ = 0, m2_ = 0, np_ = 0, workspace_ = 0;
  bool rows_ = false;
  std::string report_;
};

// Sizes that a count needs and nobody gave.
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

} // namespace

const std::vector<std::string> &allNeeds() {
  static const std::vector<std::string> needs = {"energy", "simulate", "residual", "linearise", "tangent", "parameters"};
  return needs;
}

MotionText emitAdjoint(const Program &program, const Model &model, const MotionOptions &options, Diagnostics &diags) {
  if (options.needs.empty()) return {};
  std::string missing = missingSizes(model, options);
  if (!missing.empty()) {
    diags.add("no-size", program, model.functions[0].function->loc, "'" + missing + "'");
    return {};
  }
  try {
    return MotionEmitter(program, model, options).run();
  } catch (const Unsuitable &u) {
    diags.add("adjoint-unsuitable", program, u.loc, u.why);
    return {};
  }
}

} // namespace tlgen
