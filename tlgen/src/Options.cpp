// The command line of tlgen: one table of options, one loop over the arguments.
#include "Options.h"
#include "Diagnostics.h"
#include "ModelsFile.h"
#include "Names.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace tlgen {
namespace {

const char *const helpOfModels =
    R"(usage: tlgen [options] SOURCE.c [SOURCE.c ..] [-- compiler arguments]
       tlgen --models FILE [options] [-- compiler arguments]

Reads a Lagrangian, and constraint, force and dissipation functions, written as plain C, and writes them as functions on truncated Taylor
series, so that the runtime gets every derivative exactly. The C source stays as it is.

Model
  --lagrangian NAME      the function L(q,qd,t), in J
  --holonomic NAME[:M]   a constraint function phi(q,t) = 0 with M rows; may be repeated
  --nonholonomic NAME[:M]  a constraint function psi(q,qd,t) = 0; may be repeated
  --force NAME           the generalized force (one row per coordinate)
  --dissipation NAME     Rayleigh's dissipation function D(q,qd,t), in W; its force is -dD/dqd
  --dof N                the number of coordinates: a constant, or the name of an integer member of the parameter struct
  --recursion NAME:D     the helper function NAME may call itself, at most D deep (a constant or a member); may be repeated
  --rule NAME:RULE       the function NAME has no C here; RULE is one that fills its Taylor coefficients (a tl_rule, or a tl_rule_n
                         for several arguments, of <taylor/rule.h>); may be repeated
  --model NAME           name of the model (default: the first source's name without its ending)
  --arg ROLE=NAME        a parameter called NAME has this role: q, qd, t, p (parameter struct) or out.
                         Parameters with those very names need no option. Coordinates that are passed one by one are
                         listed: --arg q=x,y --arg qd=xd,yd for L(double x, double y, double xd, double yd)
  M may be a constant (default 1) or the name of an integer member of the parameter struct. Functions can also be marked in the
  source: TLGEN(lagrangian), TLGEN(holonomic:3), and TLGEN(q) on a parameter, with the macro of <taylor/tlgen.h>.

Motion functions (eom/motion.h): fast ones for the runtime, at sizes that are known when they are printed
  --need NEED,..         energy, simulate, residual, linearise, tangent, parameters; all of these, or none. Default: energy, simulate
                         and linearise where all sizes are known. Beside them: taylor, coefficients of the motion in time for
                         integration by Taylor series
  --size MEMBER=N        the integer member of the parameter struct is N; may be repeated. Other sizes are served by the slower
                         functions that are always printed
  --parameter MEMBER,..  the members of the parameter struct that 'parameters' differentiates by
  --form FORM            registers: straight-line code; rows: loops as in the source; auto (default): what is estimated to be faster
  --lanes                print acceleration, jacobian and directional for several states at once too, in vectors (taylor/lanes.h)
  --report, --report=csv print on stdout what each of these functions costs, why it has its form, and what was proved
  --cost NAME=NS,..      other constants of the estimate that --form auto decides by (bench/cost measures them):
@costs@  --without ANALYSIS,..  switch off an analysis that leaves work out, to see what it is worth; the numbers stay the same
)";

const char *const helpOfFiles = R"(
Output
  -o FILE.c              where to write (default: SOURCE_tl.c); FILE.h is written beside it
  --export DIR           write a folder for a processor without heap and operating system in the place of FILE.c: the model, the files
                         of libtaylor and the runtime that it needs and no others, an example program, and a MANIFEST. DIR must be new,
                         or hold nothing of that name but what an earlier export has written
  --real TYPE            the numbers of an export: double (default) or float
  --carry FILE           a C file or header of yours that an export takes along, with what of libtaylor it needs: the one that defines
                         the rule of a function of --rule; may be repeated
  -MD                    also write FILE.c.d, a make rule of all files that were read
  --selftest             also write MODEL_selftest.c beside FILE.c (and MODEL_selftest_2.c .. for further sources): a program that checks
                         every derivative of the model against differences of SOURCE.c in quad precision, at points that you name. A function of --rule
                         must be linked to it on __float128, and its rule
  -p DIR                 take the compiler arguments from DIR/compile_commands.json
  --sarif FILE           also write all messages to FILE, as SARIF 2.1.0; it is written where the source is refused too
  --werror               treat warnings as errors
  --cmake                name options in messages as taylor_add_model() of the CMake package does

Several models
  --models FILE          each line of FILE is one model: its sources and options, and compiler arguments behind '--', with quotes as in
                         a shell; # starts a comment, and \ at the end of a line continues it. What stands on the command line
                         holds for every model. Sources are read once, all messages come in one run, and either all files of all
                         models are written or none

Help
  --explain ID           explain the message with this id; without ID list all ids
  --version, --help

Example
  tlgen pendulum.c --lagrangian pendulum_lagrangian --dof n -o pendulum_tl.c -- -Iinclude
Then compile pendulum_tl.c with your program, include pendulum_tl.h, and hand pendulum_model to the runtime.
Exit status: 0 written, 1 the source was refused (nothing is written), 2 wrong usage.
)";

const size_t optionColumn = 25;

std::string help() {
  std::string s = helpOfModels, costs(optionColumn, ' '), analyses;
  for (const FormCostConstant &c : formCostConstants()) {
    std::ostringstream item;
    item << c.name << "=" << FormCost().*(c.value) << " ns" << (&c == &formCostConstants().back() ? "\n" : ", ");
    costs += item.str();
  }
  for (const Analysis &a : allAnalyses())
    analyses += std::string(optionColumn, ' ') + a.name + std::string(14 - std::string(a.name).size(), ' ') + a.off + "\n";
  const std::string place = "@costs@";
  return s.replace(s.find(place), place.size(), costs) + analyses + helpOfFiles;
}

std::string place; // of the line that is being read, in a file of models

bool usageError(const std::string &message) {
  std::cerr << "tlgen: " << place << message << "\nTry 'tlgen --help'.\n";
  return false;
}

FunctionOption splitRows(const std::string &text) {
  size_t colon = text.find(':');
  if (colon == std::string::npos) return {text, ""};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

bool addRule(Options &o, const std::string &text) {
  FunctionOption rule = splitRows(text);
  if (rule.name.empty() || rule.rows.empty()) return usageError("--rule wants NAME:RULE, for example --rule drag:drag_taylor");
  return o.rules.push_back(rule), true;
}

bool addArg(Options &o, const std::string &text) {
  size_t eq = text.find('=');
  if (eq == std::string::npos || eq == 0 || eq + 1 == text.size())
    return usageError("--arg wants ROLE=NAME, for example --arg q=theta");
  std::string role = text.substr(0, eq);
  if (role != "q" && role != "qd" && role != "t" && role != "p" && role != "out")
    return usageError("--arg: '" + role + "' is no role; the roles are q, qd, t, p and out");
  std::istringstream names(text.substr(eq + 1));
  int index = 0;
  for (std::string name; std::getline(names, name, ','); ++index) {
    if (name.empty()) return usageError("--arg: a name is empty in '" + text + "'");
    if (!o.args.emplace(name, ArgOption{role, index}).second) return usageError("--arg: the parameter '" + name + "' has two roles");
  }
  return true;
}

// The items of a list with commas; none where one is empty.
std::vector<std::string> items(const std::string &text) {
  std::vector<std::string> all;
  std::istringstream in(text + ",");
  for (std::string item; std::getline(in, item, ',');) {
    if (item.empty()) return {};
    all.push_back(item);
  }
  return all;
}

bool addNeeds(Options &o, const std::string &text) {
  o.needsGiven = true;
  std::vector<std::string> given = items(text);
  if (given.empty()) return usageError("--need wants a list such as simulate,linearise; all, or none");
  for (const std::string &need : given) {
    bool known = std::count(allNeeds().begin(), allNeeds().end(), need) > 0;
    if (!known && need != "all" && need != "none") {
      std::string names;
      for (const std::string &name : allNeeds()) names += name + ", ";
      return usageError("--need: '" + need + "' is no need; the needs are " + names + "all and none");
    }
    if (need != "all" && known) o.motion.needs.insert(need);
    o.needsAll |= need == "all";
    if (need == "all")
      for (const std::string &one : allNeeds())
        if (one != "taylor") o.motion.needs.insert(one); // long code, of use to one method of integration
  }
  return true;
}

bool addSize(Options &o, const std::string &text) {
  size_t eq = text.find('=');
  std::string member = text.substr(0, eq), value = eq == std::string::npos ? "" : text.substr(eq + 1);
  bool digits = !value.empty() && value.size() < 7 && value.find_first_not_of("0123456789") == std::string::npos;
  if (member.empty() || !digits || std::stol(value) < 1)
    return usageError("--size wants MEMBER=N with N of 1 or more, for example --size n=6");
  if (!o.motion.sizes.emplace(member, std::stol(value)).second) return usageError("--size: the member '" + member + "' has two sizes");
  return true;
}

bool addParameters(Options &o, const std::string &text) {
  std::vector<std::string> given = items(text);
  if (given.empty()) return usageError("--parameter wants names of members, for example --parameter mass,length");
  o.motion.parameters.insert(o.motion.parameters.end(), given.begin(), given.end());
  return true;
}

bool setForm(Options &o, const std::string &text) {
  static const std::map<std::string, Form> forms = {{"auto", Form::Auto}, {"registers", Form::Registers}, {"rows", Form::Rows}};
  auto form = forms.find(text);
  if (form == forms.end()) return usageError("--form: '" + text + "' is no form; the forms are registers, rows and auto");
  return o.motion.form = form->second, true;
}

bool switchOff(Options &o, const std::string &text) {
  std::vector<std::string> given = items(text);
  if (given.empty()) return usageError("--without wants a list such as activity,views");
  for (const std::string &name : given) {
    const auto &all = allAnalyses();
    auto analysis = std::find_if(all.begin(), all.end(), [&](const Analysis &a) { return a.name == name; });
    if (analysis == all.end()) {
      std::string names;
      for (const Analysis &a : all) names += (names.empty() ? "" : ", ") + std::string(a.name);
      return usageError("--without: '" + name + "' is no analysis; the analyses are " + names);
    }
    o.motion.analyses.*(analysis->on) = false;
  }
  return true;
}

bool setCosts(Options &o, const std::string &text) {
  std::vector<std::string> given = items(text);
  if (given.empty()) return usageError("--cost wants NAME=NS, for example --cost operation=0.3");
  for (const std::string &item : given) {
    size_t eq = item.find('=');
    const auto &all = formCostConstants();
    auto constant = std::find_if(all.begin(), all.end(), [&](const FormCostConstant &c) { return c.name == item.substr(0, eq); });
    if (constant == all.end()) {
      std::string names;
      for (const FormCostConstant &c : all) names += (names.empty() ? "" : ", ") + std::string(c.name);
      return usageError("--cost: '" + item.substr(0, eq) + "' is no constant; the constants are " + names);
    }
    const std::string value = eq == std::string::npos ? "" : item.substr(eq + 1);
    char *end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (value.empty() || *end || !(number >= 0)) return usageError("--cost: '" + value + "' is no time in nanoseconds");
    o.motion.cost.*(constant->value) = number;
  }
  return true;
}

bool setReport(Options &o, const std::string &format) {
  if (format != "csv") return usageError("--report: '" + format + "' is no format; there is --report, and --report=csv");
  return o.report = o.motion.reportAsCsv = true;
}

bool setOnce(std::string &slot, const std::string &name, const std::string &value) {
  if (!slot.empty()) return usageError(name + " is given twice");
  if (value.empty()) return usageError(name + " is empty");
  slot = value;
  return true;
}

bool setReal(Options &o, const std::string &type) {
  if (type != "float" && type != "double")
    return usageError("--real: '" + type + "' is no type of an export; these are float and double");
  return setOnce(o.exportReal, "--real", type);
}

bool ofTheRun(const std::string &name) { return name == "--sarif" || name == "--werror" || name == "--cmake" || name == "--models"; }

bool setOption(Options &o, Run *run, const std::string &name, const std::string &value) {
  if (name == "--sarif") return setOnce(run->sarif, name, value);
  if (name == "--models") return setOnce(run->modelsFile, name, value);
  if (name == "--lagrangian") return setOnce(o.lagrangian, name, value);
  if (name == "--force") return setOnce(o.force, name, value);
  if (name == "--dissipation") return setOnce(o.dissipation, name, value);
  if (name == "--dof") return setOnce(o.dof, name, value);
  if (name == "--model") return setOnce(o.model, name, value);
  if (name == "-o") return setOnce(o.output, name, value);
  if (name == "--export") return setOnce(o.exportFolder, name, value);
  if (name == "--real") return setReal(o, value);
  if (name == "--carry") return value.empty() ? usageError("--carry is empty") : (o.carried.push_back(value), true);
  if (name == "-p") return setOnce(o.compileCommands, name, value);
  if (name == "--arg") return addArg(o, value);
  if (name == "--need") return addNeeds(o, value);
  if (name == "--size") return addSize(o, value);
  if (name == "--parameter") return addParameters(o, value);
  if (name == "--form") return setForm(o, value);
  if (name == "--cost") return setCosts(o, value);
  if (name == "--report") return setReport(o, value);
  if (name == "--without") return switchOff(o, value);
  if (name == "--holonomic") return o.holonomic.push_back(splitRows(value)), true;
  if (name == "--rule") return addRule(o, value);
  if (name == "--recursion") return o.recursion.push_back(splitRows(value)), true;
  if (name == "--nonholonomic") return o.nonholonomic.push_back(splitRows(value)), true;
  return usageError("unknown option '" + name + "'");
}

bool isIdentifier(const std::string &s) {
  for (size_t i = 0; i < s.size(); ++i)
    if (!(isalpha(static_cast<unsigned char>(s[i])) || s[i] == '_' || (i > 0 && isdigit(static_cast<unsigned char>(s[i])))))
      return false;
  return !s.empty();
}

std::string stem(const std::string &path) {
  size_t slash = path.find_last_of('/');
  std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  return file.substr(0, file.find_last_of('.'));
}

bool complete(Options &o) {
  if (o.sources.empty()) return usageError("no source file given");
  if (o.model.empty()) o.model = stem(o.sources[0]);
  if (!isIdentifier(o.model)) return usageError("'" + o.model + "' cannot be a model's name in C; say --model NAME");
  if (!o.exportFolder.empty()) {
    if (!o.output.empty() || o.depfile || o.selftest || o.motion.lanes)
      return usageError("--export writes a folder of its own: -o, -MD, --selftest and --lanes do not go with it");
    if (!o.needsGiven) o.motion.needs = {"simulate", "linearise"};
    if (o.motion.needs.count("simulate") || o.motion.needs.count("linearise")) o.motion.needs.insert("energy");
    o.needsGiven = true;
    o.output = o.exportFolder + "/" + o.model + "_tl.c";
  }
  if (o.exportFolder.empty() && !o.exportReal.empty()) return usageError("--real belongs to --export");
  if (o.exportFolder.empty() && !o.carried.empty()) return usageError("--carry belongs to --export");
  if (o.output.empty()) o.output = stem(o.sources[0]) + "_tl.c";
  if (!isSource(o.output)) return usageError("-o: the file name must end in .c");
  if (o.motion.needs.count("parameters") && o.motion.parameters.empty() && !o.needsAll)
    return usageError("--need parameters wants --parameter with the members to differentiate by");
  if (!o.needsGiven) o.motion.needs = {"energy", "simulate", "linearise"};
  return true;
}

// Options without a value; false where it is none of them.
bool setFlag(Options &o, Run *run, const std::string &arg) {
  if (arg == "-MD") return o.depfile = true;
  if (arg == "--selftest") return o.selftest = true;
  if (arg == "--lanes") return o.motion.lanes = true;
  if (arg == "--report") return o.report = true;
  if (arg == "--werror") return run->werror = true;
  if (arg == "--cmake") return run->cmake = true;
  return false;
}

// Of options with one dash tlgen has -o and -p with a value; what else begins so was meant for the compiler.
bool isForTheCompiler(const std::string &arg) { return arg[0] == '-' && arg[1] != '-' && arg != "-o" && arg != "-p"; }

// run is null on a line of a file of models.
bool parseArguments(const std::vector<std::string> &args, Options &o, Run *run) {
  for (size_t i = 0; i < args.size(); ++i) {
    const std::string &arg = args[i];
    if (arg == "--") {
      o.compilerArgs.insert(o.compilerArgs.end(), args.begin() + static_cast<long>(i) + 1, args.end());
      return true;
    }
    size_t eq = arg.rfind("--", 0) == 0 ? arg.find('=') : std::string::npos;
    std::string name = arg.substr(0, eq);
    if (!run && ofTheRun(name)) return usageError(name + " belongs on the command line: it holds for all models");
    if (setFlag(o, run, arg)) continue;
    if (arg.size() < 2 || arg[0] != '-') {
      o.sources.push_back(arg);
      continue;
    }
    if (isForTheCompiler(arg))
      return usageError("'" + arg + "' is no option of tlgen; compiler arguments belong behind '--': tlgen SOURCE.c .. -- " + arg);
    if (eq == std::string::npos && i + 1 >= args.size()) return usageError(name + " wants a value (or is no option)");
    if (!setOption(o, run, name, eq == std::string::npos ? args[++i] : arg.substr(eq + 1))) return false;
  }
  return true;
}

// The models of the file, each with the options of the command line.
bool readModels(const Options &common, Run &run) {
  std::vector<ModelLine> lines;
  std::string error;
  if (!readModelsFile(run.modelsFile, lines, error)) return usageError(error);
  for (const ModelLine &line : lines) {
    place = run.modelsFile + ":" + std::to_string(line.number) + ": ";
    Options o = common;
    o.sources.clear();
    if (!parseArguments(line.words, o, nullptr)) return false;
    o.sources.insert(o.sources.end(), common.sources.begin(), common.sources.end());
    if (!complete(o)) return false;
    run.models.push_back(o);
  }
  place.clear();
  return !lines.empty() || usageError(run.modelsFile + " names no model");
}

Command explain(const std::string &id) {
  if (id.empty()) {
    for (const DiagnosticKind &k : allDiagnostics()) std::cout << k.id << ": " << k.why << '\n';
    return Command::Done;
  }
  const DiagnosticKind *kind = findDiagnostic(id);
  if (!kind) {
    usageError("no message has the id '" + id + "'; 'tlgen --explain' lists them");
    return Command::Fail;
  }
  std::cout << kind->id << " (" << nameOf(kind->severity) << ")\n" << kind->why << "\nInstead: " << kind->instead << '\n';
  return Command::Done;
}

} // namespace

std::string Options::selftestFile(size_t k) const {
  std::string folder = output.substr(0, output.find_last_of('/') + 1);
  return folder + model + "_selftest" + (k ? "_" + std::to_string(k + 1) : "") + ".c";
}

Command parseOptions(int argc, const char *const *argv, Run &run) {
  std::vector<std::string> args(argv + 1, argv + argc);
  for (size_t i = 0; i < args.size() && args[i] != "--"; ++i) {
    if (args[i] == "--help" || args[i] == "-h") return std::cout << help(), Command::Done;
    if (args[i] == "--version")
      return std::cout << "tlgen " TLGEN_VERSION " (built with LLVM and Clang " TLGEN_CLANG_VERSION ")\n", Command::Done;
    if (args[i] == "--explain") return explain(i + 1 < args.size() ? args[i + 1] : "");
  }
  Options o;
  if (!parseArguments(args, o, &run)) return Command::Fail;
  if (!run.modelsFile.empty()) return readModels(o, run) ? Command::Generate : Command::Fail;
  if (!complete(o)) return Command::Fail;
  run.models.push_back(o);
  return Command::Generate;
}

} // namespace tlgen
