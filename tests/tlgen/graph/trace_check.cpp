// Runs the graph that Trace makes of each function of a model beside the compiled C, at random points.
//
//   trace_check [--refused] [--loops] [--params POINTER] [--with SOURCE] COMPILER FOLDER NAME.c.. OPTIONS -- COMPILER-ARGUMENTS
//
// OPTIONS and what follows are those of tlgen. POINTER is a C expression for the parameters that the sources define; the integer
// members of their struct are taken as known sizes. --refused: one of the functions at least has no graph. SOURCE holds external
// functions. FOLDER takes what is compiled.
#include "Evaluator.h"
#include "Frontend.h"
#include "Lower.h"
#include "PrintC.h"
#include "Trace.h"

#include <cmath>
#include <dlfcn.h>
#include <fstream>
#include <iostream>
#include <random>
#include <regex>
#include <sstream>

using namespace tlgen;

namespace {

// Rounding of some hundreds of operations in another grouping, relative to the largest number that may cancel.
const double VALUE_RTOL = 1e-12;
const int POINTS = 40;

struct Arguments {
  bool loops = false, refused = false;
  std::string params = "0", with, compiler, folder;
  Options options;
};

// The model's C and what the test asks of it, as a library.
class Compiled {
public:
  Compiled(const Arguments &args, const Model &model) : args_(args), model_(model) {}

  void build(const std::string &name, const std::string &code) {
    std::string stem = args_.folder + "/" + args_.options.model + "_" + name;
    std::ofstream out(stem + ".c");
    out << "#include <math.h>\n#include <stdbool.h>\n#include <stddef.h>\n";
    for (const std::string &source : args_.options.sources) out << "#include \"" << source << "\"\n";
    out << "typedef double tl_real;\n#define TL_C(x) x\n#define TL_LIBM(name) name\n" << code; // of which tables are made
    out.close();
    std::string command = args_.compiler + " -w -O1 -ffp-contract=off -shared -fPIC -o " + stem + ".so " + stem + ".c " + args_.with;
    for (const std::string &arg : args_.options.compilerArgs) command += " '" + arg + "'";
    if (std::system((command + " -lm").c_str()) != 0) throw std::runtime_error("cannot compile: " + command);
    library_ = dlopen((stem + ".so").c_str(), RTLD_LAZY);
    if (!library_) throw std::runtime_error(dlerror());
  }

  template <class F> F *function(const std::string &name) const { return reinterpret_cast<F *>(dlsym(library_, name.c_str())); }

  // The pointer to the parameters under the name that slots know it by.
  std::string parameters() const {
    if (!model_.params) return "";
    return "const " + model_.params->spelling + " *" + TRACE_PARAMS + " = (const void *)(" + args_.params + ");\n(void)" +
           TRACE_PARAMS + ";\n";
  }

private:
  const Arguments &args_;
  const Model &model_;
  void *library_ = nullptr;
};

std::string number(size_t k) { return std::to_string(k); }

// The integer members of the parameter struct.
std::map<std::string, long> sizesOf(const Arguments &args, const Model &model) {
  std::map<std::string, long> sizes;
  if (!model.params || args.params == "0") return sizes;
  Compiled library(args, model);
  std::string code;
  for (const Field &f : model.params->fields)
    if (f.type->kind == Type::Integer)
      code += "long size_" + f.name + "(void) {\n" + library.parameters() + "return (long)" + TRACE_PARAMS + "->" + f.name + ";\n}\n";
  library.build("sizes", code);
  for (const Field &f : model.params->fields)
    if (f.type->kind == Type::Integer) sizes[f.name] = library.function<long()>("size_" + f.name)();
  return sizes;
}

// A function of the model called with all arrays: void call_3(out, q, qd, t).
std::string callText(const ModelFunction &f, size_t k, const std::string &parameters) {
  std::string call = f.function->name + "(";
  for (size_t i = 0; i < f.args.size(); ++i) {
    const Arg &arg = f.args[i];
    std::string text = arg.role == ArgRole::Q     ? "q"
                       : arg.role == ArgRole::Qd  ? "qd"
                       : arg.role == ArgRole::T   ? "t"
                       : arg.role == ArgRole::Out ? "out"
                                                  : TRACE_PARAMS;
    if (arg.index >= 0) text += "[" + std::to_string(arg.index) + "]";
    call += (i ? ", " : "") + text;
  }
  std::string result = f.function->result->kind == Type::Real ? "out[0] = " : "";
  return "void call_" + number(k) + "(double *out, double *q, double *qd, double t) {\n" + parameters + result + call + ");\n}\n";
}

std::string slotText(const Slot &slot, size_t k, const std::string &parameters) {
  std::string table, text = std::regex_replace(slot.text, std::regex("unnamed[0-9]+_*\\."), ""); // as the source has it
  for (int i = 0;; ++i) {
    size_t at = text.find('%');
    if (at == std::string::npos) break;
    text.replace(at, 1, "i[" + std::to_string(i) + "]");
  }
  const Variable *v = slot.variable;
  if (v && v->isStatic && v->scope == Variable::Local)
    table = "static " + declaration(v->type, v->name) + " = " + initializer(v->init) + ";\n";
  return "double slot_" + number(k) + "(const long *i) {\n" + parameters + table + "return (double)" + text + ";\n}\n";
}

std::string externalText(const Rule &rule) {
  std::string args, types;
  for (size_t i = 0; i < rule.arity; ++i) {
    args += (i ? ", x[" : "x[") + number(i) + "]";
    types += i ? ", double" : "double";
  }
  return "double external_" + rule.function + "(const double *x) {\ndouble " + rule.function + "(" + types + ");\nreturn " +
         rule.function + "(" + args + ");\n}\n";
}

// What the nodes behind these read.
void collect(const Node *n, std::set<const Node *> &seen, std::vector<const Slot *> &slots);
void collect(const Array *a, std::set<const Node *> &seen, std::vector<const Slot *> &slots) {
  for (const Write &w : a->writes) {
    collect(w.index, seen, slots);
    collect(w.value, seen, slots);
  }
}
void collect(const Node *n, std::set<const Node *> &seen, std::vector<const Slot *> &slots) {
  if (!n || !seen.insert(n).second) return;
  if (n->slot && n->slot->kind == Slot::Member && std::find(slots.begin(), slots.end(), n->slot) == slots.end())
    slots.push_back(n->slot);
  for (const Node *arg : n->args) collect(arg, seen, slots);
  if (n->array) collect(n->array, seen, slots);
  if (!n->of) return;
  collect(n->of->trips, seen, slots);
  collect(n->of->condition, seen, slots);
  for (const Carry &c : n->of->carried) {
    collect(c.init, seen, slots);
    collect(c.out, seen, slots);
  }
}

struct Case {
  const ModelFunction *function;
  Traced traced;
  size_t nodes = 0, loops = 0;
};

int compare(const Arguments &args, const Program &program, const Model &model, const std::vector<Case> &cases, long n) {
  Compiled library(args, model);
  std::vector<const Slot *> slots;
  std::set<const Node *> seen;
  for (const Case &c : cases) c.traced.rows ? collect(c.traced.rows, seen, slots) : collect(c.traced.value, seen, slots);
  std::string code;
  for (size_t k = 0; k < cases.size(); ++k) code += callText(*cases[k].function, k, library.parameters());
  for (size_t k = 0; k < slots.size(); ++k) code += slotText(*slots[k], k, library.parameters());
  for (auto &rule : program.rules) code += externalText(rule.second);
  library.build("check", code);

  std::map<const Slot *, double (*)(const long *)> getters;
  for (size_t k = 0; k < slots.size(); ++k) getters[slots[k]] = library.function<double(const long *)>("slot_" + number(k));
  std::mt19937 random(1234);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int faults = 0;
  for (int point = 0; point < POINTS; ++point) {
    std::vector<double> q(size_t(n) + 8), qd(size_t(n) + 8);
    for (double &x : q) x = uniform(random);
    for (double &x : qd) x = uniform(random);
    double t = uniform(random);
    auto input = [&](const Slot &slot, const std::vector<long> &i) {
      if (slot.kind == Slot::Q) return Value::of(q.at(size_t(i.at(0))));
      if (slot.kind == Slot::Qd) return Value::of(qd.at(size_t(i.at(0))));
      if (slot.kind == Slot::T) return Value::of(t);
      double x = getters.at(&slot)(i.data());
      return slot.integer ? Value::of(long(x)) : Value::of(x);
    };
    auto external = [&](const std::string &f, const std::vector<double> &x) {
      return library.function<double(const double *)>("external_" + f)(x.data());
    };
    for (size_t k = 0; k < cases.size(); ++k) {
      const Case &c = cases[k];
      size_t rows = c.traced.rows ? size_t(c.traced.rows->length) : 1;
      std::vector<double> expected(rows + 64, 0.0), actual;
      library.function<void(double *, double *, double *, double)>("call_" + number(k))(expected.data(), q.data(), qd.data(), t);
      Evaluator evaluator(input, external);
      actual = c.traced.rows ? evaluator.rows(c.traced.rows) : std::vector<double>{evaluator.value(c.traced.value)};
      for (size_t i = 0; i < rows; ++i) {
        bool same = std::fabs(actual[i] - expected[i]) <= VALUE_RTOL * (1 + std::fabs(expected[i])) ||
                    (std::isnan(actual[i]) && std::isnan(expected[i])) || actual[i] == expected[i];
        if (same || ++faults > 10) continue;
        std::fprintf(stderr, "%s, point %d: row %zu is %.17g, expected %.17g\n", c.function->function->name.c_str(), point, i,
                     actual[i], expected[i]);
      }
    }
  }
  return faults ? 1 : 0;
}

int check(const Arguments &args) {
  Diagnostics diags;
  Frontend frontend;
  Parsed parsed = frontend.parse(args.options, diags);
  if (parsed.units.empty()) return diags.print(std::cerr), 2;
  Source source(parsed.units, diags);
  Match match = matchModel(source, args.options, diags);
  auto functions = checkSubset(source, match);
  if (diags.hasErrors()) return diags.print(std::cerr), 2;
  Program program;
  Model model;
  lower(source, match, functions, args.options.model, program, model);

  TraceOptions options;
  options.sizes = sizesOf(args, model);
  options.keepLoops = args.loops;
  options.minTrips = 2;
  Graph graph;
  std::vector<Case> cases;
  bool refused = false;
  for (const ModelFunction &f : model.functions) {
    size_t nodes = graph.size(), loops = graph.loops().size();
    try {
      Traced traced = trace(graph, program, model, f, options);
      cases.push_back({&f, traced, graph.size() - nodes, graph.loops().size() - loops});
      std::printf("%s: %zu nodes, %zu loops\n", f.function->name.c_str(), cases.back().nodes, cases.back().loops);
      for (const Unsuitable &u : traced.unrolled)
        std::printf("%s:%u: unrolled: %s\n", program.files[size_t(u.loc.file)].c_str(), u.loc.line, u.why.c_str());
    } catch (const Unsuitable &u) {
      std::string file = u.loc.file >= 0 ? program.files[size_t(u.loc.file)] : "";
      std::printf("%s:%u:%u: %s: %s\n", file.c_str(), u.loc.line, u.loc.column, f.function->name.c_str(), u.why.c_str());
      refused = true;
    }
  }
  long n = model.dof.member.empty() ? model.dof.value : options.sizes[model.dof.member];
  int status = compare(args, program, model, cases, n);
  if (refused != args.refused) std::fprintf(stderr, refused ? "a function has no graph\n" : "all functions have graphs\n");
  return status || refused != args.refused;
}

} // namespace

int main(int argc, char **argv) {
  Arguments args;
  std::vector<const char *> rest = {argv[0]};
  int i = 1;
  for (; i < argc && argv[i][0] == '-'; ++i) {
    std::string option = argv[i];
    if (option == "--loops") args.loops = true;
    if (option == "--refused") args.refused = true;
    if (option == "--params") args.params = argv[++i];
    if (option == "--with") args.with = argv[++i];
  }
  args.compiler = argv[i++];
  args.folder = argv[i++];
  rest.insert(rest.end(), argv + i, argv + argc);
  Run run;
  if (parseOptions(int(rest.size()), rest.data(), run) != Command::Generate) return 2;
  args.options = run.models.at(0);
  try {
    return check(args);
  } catch (const std::exception &e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
