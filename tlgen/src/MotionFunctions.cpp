// The functions of eom_motion: the statements of their results, and what comes between and after them.
#include "MotionFunctions.h"
#include "Regroup.h"
#include "Trace.h"

#include <algorithm>

namespace tlgen {
namespace {

std::string str(long n) { return std::to_string(n); }

bool isWordPart(char ch) { return isalnum(static_cast<unsigned char>(ch)) || ch == '_'; }

std::string withoutComments(std::string text) {
  for (size_t at; (at = text.find("/*")) != std::string::npos;) text.erase(at, text.find("*/", at) + 2 - at);
  return text;
}

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

std::string replaced(std::string text, const std::string &word, const std::string &by) {
  for (size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size()) text.replace(at, word.size(), by);
  return text;
}
std::string without(const std::string &text, const std::string &word) { return replaced(text, word, ""); }

// for (int i = 0; i < count; ++i) statement, and the same for two indices.
std::string each(long count, const std::string &statement) {
  return "  for (int i = 0; i < " + str(count) + "; ++i) " + statement + "\n";
}
std::string each(long rows, long columns, const std::string &statement) {
  return "  for (int i = 0; i < " + str(rows) + "; ++i)\n    for (int j = 0; j < " + str(columns) + "; ++j) " + statement + "\n";
}

std::string finite(const std::string &count, const std::string &array, bool lanes = false) {
  return std::string("  if (!") + (lanes ? "tl_lanes_finite(" : "tl_finite_array(") + count + ", " + array +
         ")) return EOM_MOTION_NOT_FINITE;\n";
}
std::string finite(long count, const std::string &array, bool lanes = false) { return count ? finite(str(count), array, lanes) : ""; }

const std::string lanesSuffix = "_lanes";

bool isOfLanes(const std::string &function) {
  return function.size() > lanesSuffix.size() && function.substr(function.size() - lanesSuffix.size()) == lanesSuffix;
}

// Some results of a need, printed without a break.
struct Part {
  std::string need;
  std::vector<std::string> names;
};

} // namespace

// The statements of one function. Results are given their places first, then printed part by part.
class MotionFunctions::Body {
public:
  Body(MotionFunctions &of, MotionValues &made, std::vector<Part> parts, bool ofLanes = false)
      : values(made), lanes(ofLanes), parts_(std::move(parts)), arrays_(regrouped()), schedule_(made.graph, phases()),
        printer(schedule_, of.program_, of.sites_, of.takenNames(), ofLanes) {}

  // The result, a row of numbers, is memory of that name.
  void vector(size_t part, const std::string &name, const std::string &lvalue) {
    auto found = arrays_[part].find(name);
    if (found != arrays_[part].end()) printer.bind(found->second, lvalue);
  }

  // The result, a matrix, is memory of that name with rows stride numbers apart.
  void matrix(size_t part, const std::string &name, const std::string &to, long columns, long stride) {
    auto row = results(part).rows.find(name);
    auto array = arrays_[part].find(name);
    if (row != results(part).rows.end())
      rows(part, columns).bind(row->second, to, stride);
    else if (array != arrays_[part].end())
      printer.bind(array->second, to + (columns == stride ? "[%]" : "[%*" + str(stride) + " + %]"), columns);
  }

  // The result, a matrix, comes to stand in an output without padding: text that copies it there, where it was made elsewhere.
  std::string output(size_t part, const std::string &name, const std::string &to, long count, long columns) {
    if (!results(part).rows.count(name)) {
      matrix(part, name, to, columns, columns);
      return "";
    }
    long stride = padded(columns);
    std::string from = memory(name + "_rows", count * stride);
    matrix(part, name, from, columns, stride);
    return unpack(part, name, to, from, count, columns, stride);
  }

  // Rows of r_y and g_y have the columns of a coordinate and its velocity side by side.
  bool paired(size_t part, const std::string &name) { return results(part).rows.count(name) && (name == "r_y" || name == "g_y"); }

  // Copies a matrix to an output. Pairs of columns are taken apart, and seen to be finite on the way.
  std::string unpack(size_t part, const std::string &name, const std::string &to, const std::string &from, long count, long columns,
                     long stride, const std::string &sign = "") {
    if (!paired(part, name))
      return each(count, columns, to + "[i*" + str(columns) + " + j] = " + sign + from + "[i*" + str(stride) + " + j];");
    std::string half = str(columns / 2);
    return "  if (!tl_rows_unpair(" + str(count) + ", " + to + ", " + to + " + " + half + ", " + str(columns) + ", " + from + ", " +
           str(stride) + ", " + sign + "TL_C(1.0), " + half + ")) return EOM_MOTION_NOT_FINITE;\n";
  }

  // The test that a matrix is finite, where unpack has none.
  std::string checkFinite(size_t part, const std::string &name, const std::string &to, long count) {
    return paired(part, name) ? "" : finite(count, to, lanes);
  }

  // Declares an array of so many numbers: on the stack in straight-line code, in the caller's memory otherwise.
  std::string memory(const std::string &name, long count) {
    memory_.push_back({name, padded(count)});
    return name;
  }

  std::string print(size_t part) {
    auto found = rows_.find(part);
    if (found == rows_.end() && !results(part).updates().empty()) rows(part, 1);
    if (rows_.count(part)) {
      RowPrinter *rows = rows_.at(part).get();
      printer.setRows([rows](const Loop *loop, bool start, int indent) { return rows->print(loop, start, indent); });
    }
    return printer.phase(part);
  }

  // The same, and the end where it failed for a place in the source.
  std::string printChecked(size_t part) {
    std::string s = print(part);
    return s + printer.returnSite();
  }

  // To be asked for last.
  std::string declarations() {
    std::string s = printer.declarations();
    workspace_ = printer.workspace();
    for (auto &[part, rows] : rows_) {
      s += rows->declarations(workspace_);
      workspace_ += rows->workspace();
    }
    std::string own;
    for (auto &[name, count] : memory_) {
      if (values.rows) {
        own += "  tl_real *const restrict " + name + " = work + " + str(workspace_) + ";\n";
        workspace_ += count;
      } else {
        own += "  " + number() + " " + name + "[" + str(count) + "];\n";
      }
    }
    return own + s;
  }
  long workspace() const { return workspace_; }
  void count(MotionFunction &f) const {
    f.operations = schedule_.operations();
    f.workspace = workspace_;
    f.tape = printer.kept();
    for (auto &[part, rows] : rows_) f.rows += rows->kept();
  }

  // The type of what depends on the state, and the kernel of that name for it.
  std::string number() const { return lanes ? "tl_lanes" : "tl_real"; }
  std::string kernel(const std::string &name) const { return lanes ? name + lanesSuffix : name; }

  MotionValues &values;
  const bool lanes;

private:
  Results &results(size_t part) { return values.results(parts_[part].need); }

  using Arrays = std::map<std::string, Array *>;

  // The results that are computed here; in straight-line code, of products that share most.
  std::vector<Arrays> regrouped() {
    std::vector<Arrays> all(parts_.size());
    std::vector<Node *> wanted;
    bool grouped = values.rows || !values.analyses.algebra;
    for (size_t part = 0; part < parts_.size(); ++part)
      for (const std::string &name : parts_[part].names) {
        auto array = results(part).arrays.find(name);
        if (array == results(part).arrays.end()) continue;
        all[part].insert(*array);
        grouped |= results(part).grouped;
        for (const Write &write : array->second->writes) wanted.push_back(write.value);
      }
    if (grouped) return all;
    Regrouping regrouping(values.graph, wanted);
    for (Arrays &arrays : all)
      for (auto &[name, array] : arrays) {
        const Array *original = array;
        array = values.graph.array(original->name, original->length);
        array->summed = original->summed;
        for (const Write &write : original->writes) values.graph.write(array, write.loop, write.index, regrouping(write.value));
      }
    return all;
  }

  std::vector<Phase> phases() {
    std::vector<Phase> all;
    for (size_t part = 0; part < parts_.size(); ++part) {
      Phase phase;
      for (const std::string &name : parts_[part].names) {
        auto array = arrays_[part].find(name);
        if (array != arrays_[part].end()) phase.arrays.push_back(array->second);
      }
      phase.updates = results(part).updates();
      phase.kept = results(part).kept();
      phase.columns = results(part).columns;
      all.push_back(phase);
    }
    return all;
  }

  RowPrinter &rows(size_t part, long columns) {
    auto &made = rows_[part];
    if (!made)
      made = std::make_unique<RowPrinter>(printer, schedule_, columns, [this](const std::string &wish) { return printer.fresh(wish); });
    return *made;
  }

  std::vector<Part> parts_;
  std::vector<Arrays> arrays_; // by part
  Schedule schedule_;
  std::map<size_t, std::unique_ptr<RowPrinter>> rows_;
  std::vector<std::pair<std::string, long>> memory_;
  long workspace_ = 0;

public:
  GraphPrinter printer;
};

// Names of arguments and of the variables that are printed here.
std::set<std::string> MotionFunctions::takenNames() const {
  std::set<std::string> names = {
      "params", "q",     "qd",      "t",     "qdd",  "lambda",   "k",        "c",          "w",      "work",     "out",
      "r",      "M",     "Q",       "A",     "b",    "dinv",     "pivot",    "energy",     "r_y",    "g_y",      "r_w",
      "g_w",    "r_p",   "g_p",     "phi",   "psi",  "phi_dot",  "qdd_y",    "lagrangian", "dqdd",   "solved",   "B",
      "sum",    "i",     "j",       "l",     "auto", "register", "restrict", "inline",     "signed", "momentum", "momentum_rate",
      "Qc",     "sound", "inverse", "growth"};
  names.insert(TRACE_PARAMS);
  for (const Variable *v : program_.globals) names.insert(v->name);
  for (const Function *f : program_.functions) names.insert(f->name);
  for (const auto &rule : program_.rules) names.insert({rule.second.function, rule.second.taylor});
  return names;
}

MotionFunction MotionFunctions::print(const std::string &name, MotionValues &values) {
  static const std::string given = "const tl_real *restrict qdd, ", fixed = given + "const tl_real *restrict lambda, ";
  static const std::string directions = "int k, const tl_real *restrict w, ";
  if (name == "energy") {
    Body body(*this, values, {{"energy", {"momentum", "momentum_rate", "lagrangian"}}});
    return define(name,
                  "tl_real *restrict momentum, tl_real *restrict momentum_rate, tl_real *restrict lagrangian, tl_real *restrict energy",
                  body, energy(body));
  }
  if (name == "simulate") {
    Body body(*this, values, {{"simulate", {"M", "Q", "phi", "phi_dot", "b_phi", "A_phi", "psi", "b_psi", "A_psi"}}});
    return define(name, "const eom_parts *out", body, simulate(body));
  }
  if (name == "residual") {
    Body body(*this, values, {{"residual", {"r"}}});
    return define(name, given + "tl_real *restrict r", body, residual(body));
  }
  if (name == "linearise") {
    Body body(*this, values, {{"linearise", {"r_y", "g_y"}}});
    return define(name, fixed + "tl_real *restrict r_y, tl_real *restrict g_y", body, derivatives(body, "y", 2 * values.n));
  }
  if (name == "parameters") {
    Body body(*this, values, {{"parameters", {"r_p", "g_p"}}});
    return define(name, fixed + "tl_real *restrict r_p, tl_real *restrict g_p", body,
                  derivatives(body, "p", long(values.parameters.size())));
  }
  if (name == "tangent") {
    Body body(*this, values, {{"tangent", {"r_w", "g_w"}}});
    return define(name, fixed + directions + "tl_real *restrict r_w, tl_real *restrict g_w", body, tangent(body));
  }
  if (name == "constrained") {
    Body body(*this, values, {{"constrained", {"qdd", "lambda", "Qc", "inverse", "growth"}}});
    return define(name, "tl_real *restrict solved, tl_real *restrict lambda, tl_real *restrict Qc", body, constrained(body));
  }
  if (name == "taylor") {
    Body body(*this, values, {{"taylor", {"fixed"}}});
    return taylor(body);
  }
  const bool lanes = isOfLanes(name);
  const std::string solved = lanes ? name.substr(0, name.size() - lanesSuffix.size()) : name;
  if (solved == "acceleration") {
    Body body(*this, values, {{"simulate", {"M", "Q"}}}, lanes);
    return define(name, "tl_real *restrict solved", body, acceleration(body));
  }
  if (solved == "jacobian") {
    Body body(*this, values, {{"simulate", {"M", "Q"}}, {"linearise", {"r_y"}}}, lanes);
    return define(name, "tl_real *restrict solved, tl_real *restrict qdd_y", body, jacobian(body));
  }
  Body body(*this, values, {{"simulate", {"M", "Q"}}, {"tangent", {"r_w"}}}, lanes);
  return define(name, directions + "tl_real *restrict solved, tl_real *restrict dqdd", body, directional(body));
}

MotionFunction MotionFunctions::define(const std::string &name, const std::string &args, Body &body, const std::string &statements,
                                       long x) {
  std::string text = body.declarations();
  if (x) text += "  tl_real *const restrict x = work + " + str(body.workspace()) + ";\n";
  text += statements;
  std::string start, code = withoutComments(text);
  std::string signature = "q, qd, t, " + args + ", work";
  for (const char *arg : {"q", "qd", "t", "qdd", "lambda", "w", "r_p", "g_y", "g_w", "g_p", "work"})
    if (usesWord(signature, arg) && !usesWord(code, arg)) start += (start.empty() ? "  (void)" : ", (void)") + std::string(arg);
  if (!start.empty()) start += ";\n";
  if (model_.params && usesWord(code, TRACE_PARAMS))
    start += "  const " + model_.params->spelling + " *const " + TRACE_PARAMS + " = params;\n";
  start += "  if (!" + model_.name + "_fits(params)) return EOM_MOTION_SIZE;\n";
  MotionFunction f;
  std::string head = "int " + model_.name + "_" + name +
                     "(const void *params, const tl_real *restrict q, const tl_real *restrict qd, " +
                     (body.lanes ? "const tl_real *restrict t, " : "tl_real t, ") + args + ", tl_real *restrict work)";
  if (body.lanes) head = replaced(head, "tl_real", "tl_lanes");
  f.definition = head + "\n{\n" + start + text + "  return 0;\n}\n\n";
  f.prototype = without(head, "restrict ") + ";\n";
  body.count(f);
  f.workspace += padded(x);
  return f;
}

// E = p.qd - L.
std::string MotionFunctions::energy(Body &body) {
  long n = body.values.n;
  body.vector(0, "momentum", "momentum[%]");
  body.vector(0, "momentum_rate", "momentum_rate[%]");
  body.vector(0, "lagrangian", "lagrangian[%]");
  std::string s = body.printChecked(0);
  return s + "  tl_real sum = -lagrangian[0];\n" + each(n, "sum += momentum[i] * qd[i];") + "  energy[0] = sum;\n" +
         finite(n, "momentum") + finite(n, "momentum_rate") +
         "  if (!TL_ISFINITE(lagrangian[0]) || !TL_ISFINITE(sum)) return EOM_MOTION_NOT_FINITE;\n";
}

std::string MotionFunctions::simulate(Body &body) {
  long n = body.values.n, m1 = body.values.m1, m2 = body.values.m2;
  std::string locals, copies;
  auto pointer = [&](const std::string &name, const std::string &to) {
    locals += "  tl_real *const restrict " + name + " = out->" + to + ";\n";
  };
  auto vector = [&](const std::string &name, const std::string &to) {
    pointer(name, to);
    body.vector(0, name, name + "[%]");
  };
  auto matrix = [&](const std::string &name, const std::string &to, long count) {
    pointer(name, to);
    copies += body.output(0, name, name, count, n);
  };
  matrix("M", "M", n);
  vector("Q", "Q");
  if (m1) vector("phi", "phi"), vector("phi_dot", "phi_dot"), vector("b_phi", "b"), matrix("A_phi", "A", m1);
  if (m2) vector("psi", "psi"), vector("b_psi", "b + " + str(m1)), matrix("A_psi", "A + " + str(m1 * n), m2);
  std::string s = locals + body.printChecked(0) + copies;
  if (n > 1)
    s += "  for (int i = 1; i < " + str(n) + "; ++i)\n    for (int j = 0; j < i; ++j) M[i*" + str(n) + " + j] = M[j*" + str(n) +
         " + i];\n";
  s += finite(n * n, "M") + finite(n, "Q") + finite(m1, "out->phi") + finite(m1, "out->phi_dot") + finite(m2, "out->psi");
  return s + finite((m1 + m2) * n, "out->A") + finite(m1 + m2, "out->b");
}

std::string MotionFunctions::residual(Body &body) {
  body.vector(0, "r", "r[%]");
  return body.printChecked(0) + finite(body.values.n, "r");
}

// r_y and g_y, or r_p and g_p.
std::string MotionFunctions::derivatives(Body &body, const std::string &suffix, long columns) {
  long n = body.values.n, m = body.values.m1 + body.values.m2;
  std::string r = "r_" + suffix, g = "g_" + suffix;
  const std::string constraints = body.output(0, g, g, m, columns), copies = body.output(0, r, r, n, columns) + constraints;
  return body.printChecked(0) + copies + body.checkFinite(0, r, r, n * columns) + body.checkFinite(0, g, g, m * columns);
}

// One direction after the other, each made in memory of its own: gcc 12 at -O3 makes a memset of zeros in several columns of a matrix
// even where that is too late for what has been added to them.
std::string MotionFunctions::tangent(Body &body) {
  long n = body.values.n, m = body.values.m1 + body.values.m2;
  body.vector(0, "r_w", body.memory("B", n + m) + "[%]");
  body.vector(0, "g_w", "B[" + str(n) + " + %]");
  std::string s = "  for (int c = 0; c < k; ++c) {\n" + indented(body.print(0)) + "  " + each(n, "r_w[i*k + c] = B[i];") +
                  (m ? "  " + each(m, "g_w[i*k + c] = B[" + str(n) + " + i];") : "") + "  }\n";
  s += body.printer.returnSite() + finite(str(n) + "*k", "r_w");
  return s + (m ? finite(str(m) + "*k", "g_w") : "");
}

// M and Q, and qdd from them. The pivots are looked at when the result is in its place, so that no compiler makes it wait for them.
std::string MotionFunctions::solve(Body &body) {
  long n = body.values.n, ld = padded(n);
  body.matrix(0, "M", body.memory("M", n * ld), n, ld);
  body.vector(0, "Q", body.memory("Q", n) + "[%]");
  body.memory("qdd", n), body.memory("dinv", 2 * padded(n)); // TL_LDL_DIAGONAL(n)
  const std::string pivot = "pivot * EOM_MOTION_LEAST_PIVOT(" + str(n) + ") < TL_C(1.0)";
  return body.printChecked(0) + "  const " + body.number() + " pivot = " + body.kernel("tl_ldl_factor_solve") + "(" + str(n) +
         ", qdd, M, " + str(ld) + ", dinv, Q);\n" + each(n, "solved[i] = qdd[i];") + "  if (!" + (body.lanes ? "tl_lanes_all(" : "(") +
         pivot + ")) return EOM_MOTION_PIVOT;\n";
}

// qdd, lambda and A' lambda by an elimination that knows the zeros of M and A.
std::string MotionFunctions::constrained(Body &body) {
  const long n = body.values.n, m = body.values.m1 + body.values.m2;
  body.vector(0, "qdd", "solved[%]");
  body.vector(0, "lambda", "lambda[%]");
  body.vector(0, "Qc", "Qc[%]");
  std::string checks = "  int sound = 1;\n";
  const std::vector<std::pair<std::string, std::string>> judged = {
      {"inverse", "(inverse[i] > TL_C(0.0)) & (inverse[i] <= TL_MAX)"},
      {"growth", "(growth[i] > TL_C(0.0)) & (growth[i] * EOM_MOTION_SAFE_PIVOT < TL_C(1.0))"}};
  for (auto &[name, condition] : judged) {
    const long count = body.values.results("constrained").arrays.at(name)->length;
    body.vector(0, name, body.memory(name, count) + "[%]");
    checks += each(count, "sound &= " + condition + ";");
  }
  return body.printChecked(0) + checks + "  if (!sound) return EOM_MOTION_PIVOT;\n" + finite(n, "solved") + finite(m, "lambda") +
         finite(n, "Qc");
}

// Order by order, in blocks of four.
MotionFunction MotionFunctions::taylor(Body &body) {
  const Recurrences &recurrences = body.values.recurrences();
  const std::string stem = model_.name + "_taylor", first = stem + "_first", later = stem + "_later", pairs = stem + "_pairs";
  const std::string n = str(body.values.n), count = str(long(recurrences.pairs().size()));
  const bool fixed = !recurrences.fixed().empty(), products = !recurrences.pairs().empty();
  if (fixed) body.vector(0, "fixed", body.memory("fixed", long(recurrences.fixed().size())) + "[%]");
  std::string s = body.printChecked(0);
  const std::string values = fixed ? "fixed" : "NULL", older = products ? "x + " + str(recurrences.older()) : "NULL";
  auto order = [&](const std::string &k, int place, bool begins) {
    return later + "(x, " + older + ", " + values + ", " + k + ", " + str(place) + ", " + (begins ? "1" : "0") + ");\n";
  };
  s += "  " + first + "(x, " + values + ", q, qd, t);\n";
  for (int k : {1, 2, 3}) s += "  if (order > " + str(k + 1) + ") " + order(str(k), k, true);
  s += "  for (int k = 4; k + 2 <= order; k += 4) {\n";
  if (products) s += "    tl_series_begin_block(x, " + older + ", " + count + ", " + pairs + ", k);\n";
  s += "    " + order("k", 0, false);
  for (int place : {1, 2, 3}) s += "    if (order > k + " + str(place + 1) + ") " + order("k + " + str(place), place, false);
  s += "  }\n  for (int i = 0; i < " + n + "; ++i)\n    for (int k = 0; k <= order; ++k) coef[i*(order + 1) + k] = (" +
       recurrences.coordinate("i") + ")[k];\n" + finite(n + "*(order + 1)", "coef");
  MotionFunction f = define("taylor", "int order, tl_real *restrict coef", body, s, recurrences.workspace());
  std::string table;
  for (auto &[a, b] : recurrences.pairs()) table += (table.empty() ? "{" : ", {") + str(a) + ", " + str(b) + "}";
  const std::string fixedArgument = "const tl_real *restrict fixed, ";
  f.definition = (products ? "static const tl_series_pair " + pairs + "[] = {" + table + "};\n\n" : "") + "TL_INLINE void " + first +
                 "(tl_real *restrict x, " + fixedArgument + "const tl_real *restrict q, const tl_real *restrict qd, tl_real t)\n{\n" +
                 "  (void)fixed, (void)t;\n" + recurrences.first() + "}\n\nTL_INLINE void " + later +
                 "(tl_real *restrict x, const tl_real *older, " + fixedArgument + "int k, int place, int first)\n{\n" +
                 "  (void)older, (void)fixed, (void)place, (void)first;\n" + recurrences.later() + "}\n\n" + f.definition;
  return f;
}

std::string MotionFunctions::acceleration(Body &body) { return solve(body) + finite(body.values.n, "qdd", body.lanes); }

std::string MotionFunctions::jacobian(Body &body) {
  long n = body.values.n, columns = 2 * n, ld = padded(columns);
  body.matrix(1, "r_y", body.memory("B", n * ld), columns, ld);
  std::string s = solve(body);
  const std::string factors = ", B, " + str(ld) + ", M, " + str(padded(n)) + ", dinv);\n", sizes = "(" + str(n) + ", " + str(columns);
  s += body.printChecked(1);
  if (body.lanes || body.paired(1, "r_y"))
    s += "  " + body.kernel("tl_ldl_solve_many") + sizes + factors + body.unpack(1, "r_y", "qdd_y", "B", n, columns, ld, "-");
  else
    s += "  tl_ldl_solve_negated" + sizes + ", qdd_y" + factors;
  return s + finite(n, "qdd", body.lanes) + body.checkFinite(1, "r_y", "qdd_y", n * columns);
}

std::string MotionFunctions::directional(Body &body) {
  long n = body.values.n;
  body.vector(1, "r_w", body.memory("B", n) + "[%]");
  std::string s = solve(body);
  s += "  for (int c = 0; c < k; ++c) {\n" + indented(body.print(1)) + "    " + body.kernel("tl_ldl_solve") + "(" + str(n) +
       ", B, M, " + str(padded(n)) + ", dinv, B);\n  " + each(n, "dqdd[i*k + c] = -B[i];") + "  }\n";
  return s + body.printer.returnSite() + finite(n, "qdd", body.lanes) + finite(str(n) + "*k", "dqdd", body.lanes);
}

} // namespace tlgen
