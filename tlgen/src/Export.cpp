// Makes an export: the files, and the manifest that knows them again.
#include "Export.h"
#include "LibraryFiles.h"
#include "Names.h"
#include "PrintC.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace tlgen {
namespace {

namespace fs = std::filesystem;

const char *const manifestName = "MANIFEST";
const std::string manifestTitle = "tlgen export, model ";

// 64 bits of Fowler, Noll and Vo's hash 1a: to know a file again.
std::string hashOf(const std::string &text) {
  uint64_t h = 0xcbf29ce484222325;
  for (char ch : text) h = (h ^ static_cast<unsigned char>(ch)) * 0x100000001b3;
  std::ostringstream s;
  s << std::hex;
  s.width(16);
  s.fill('0');
  s << h;
  return s.str();
}

std::string readAll(const fs::path &path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

std::string replaced(std::string text, const std::string &what, const std::string &by) {
  const size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

// libtaylor's own choices for a small processor: no vectors, jets as the runtime needs them.
std::string configFor(const std::string &text, const std::string &real) {
  std::string s =
      replaced(text, "#define TL_REAL TL_DOUBLE", "#define TL_REAL TL_" + std::string(real == "float" ? "FLOAT" : "DOUBLE"));
  s = replaced(s, "#define TL_MAX_ORDER 16", "#define TL_MAX_ORDER 2");
  s = replaced(s, "#define TL_MAX_CURVE 64", "#define TL_MAX_CURVE 2");
  s = replaced(s, "#define TL_ALIGNMENT 64", "#define TL_ALIGNMENT 8");
  return replaced(s, "/* The number type:",
                  "/* Plain C without vectors. */\n#ifndef TL_NO_VECTORS\n#define TL_NO_VECTORS\n#endif\n\n/* The number type:");
}

// A value for each number of the parameters: ones, and the sizes that the functions are made for.
std::string valueOf(const Type *type, const std::string &member, const std::map<std::string, long> &sizes) {
  const long most = 16; // elements written out
  switch (type->kind) {
  case Type::Real:
    return isSingle(type) ? "1.0f" : "TL_C(1.0)";
  case Type::Integer: {
    auto size = sizes.find(member);
    return size == sizes.end() ? "1" : std::to_string(size->second);
  }
  case Type::Array: {
    std::string s;
    for (long i = 0; i < std::min(type->count, most); ++i) s += (i ? ", " : "") + valueOf(type->element, "", sizes);
    return "{" + s + "}";
  }
  case Type::Struct: {
    std::string s;
    for (const Field &f : type->record->fields) s += (s.empty() ? "." : ", .") + f.name + " = " + valueOf(f.type, "", sizes);
    return "{" + s + "}";
  }
  case Type::Pointer: {
    if (type->element->kind == Type::Void || type->element->kind == Type::Pointer) return "0";
    std::string s;
    for (long i = 0; i < most; ++i) s += (i ? ", " : "") + valueOf(type->element, "", sizes);
    return "(" + declaration(type->element, "[" + std::to_string(most) + "]") + "){" + s + "}";
  }
  default:
    return "0";
  }
}

class Example {
public:
  Example(const Model &model, const MotionText &motion, const EmittedModel &text, Content content)
      : model_(model), motion_(motion), text_(text), motionAlone_(content == Content::Motion), name_(model.name) {}

  bool linearises() const { return motionAlone_ ? has("jacobian") : has("linearise"); }

  std::vector<std::string> needs() const {
    std::vector<std::string> all = {"simulate"};
    if (linearises()) all.push_back("linearise");
    all.push_back("step");
    return all;
  }

  std::string text() const {
    std::string s =
        "/* An example: the motion of \"" + name_ + "\" by a Runge-Kutta method of fixed step" +
        (linearises() ? ", and its linear model where it ends" : "") +
        ".\n *\n * Memory is static, and nothing allocates. What is marked YOURS is made up. */\n#include \"example.h\"\n\n#include "
        "\"" +
        name_ + "_tl.h\"\n" +
        (motionAlone_ ? "" : std::string("#include <eom/bytes.h>\n") + (linearises() ? "#include <eom/linearise.h>\n" : "")) +
        "#include <eom/integrate.h>\n" + (motionAlone_ ? "" : "#include <eom/solve.h>\n") +
        "\n#ifdef EXAMPLE_PRINT\n#include <stdio.h>\n#endif\n\n";
    s += "enum { N = " + std::to_string(motion_.n) + ", STEPS = 1000 };\n\n";
    s += "static tl_real y[2 * N] = {" + state() + "}; /* coordinates, velocities: YOURS */\n";
    s += "static eom_integrator integrator;\nstatic tl_real work[EOM_INTEGRATOR_SIZE(4, 0, 2 * N)]; /* of rk4 */\n";
    if (model_.params) s += "static const " + model_.params->spelling + " params = { /* YOURS */\n" + parameters() + "};\n";
    s += motionAlone_ ? byFunctions() : bySystem();
    s += "int example_step(void) {\n  if (!integrator.method) eom_integrator_init(&integrator, &eom_rk4, " +
         std::string(motionAlone_ ? "rhs, NULL" : "eom_rhs, &sys") +
         ", 2 * N, TL_C(0.0), y, TL_C(1e-3), work);\n  return (int)eom_integrator_step(&integrator);\n}\n\nint example_start(void) {\n";
    s += (motionAlone_ ? "" : startSystem()) +
         "  return 0;\n}\n\n#ifndef EXAMPLE_WITHOUT_MAIN\nint main(void) {\n  int status = "
         "example_start();\n  for (int i = 0; i < STEPS && status == 0; i++) status = example_step();\n  for (int i = 0; i < 2 * N; "
         "i++) y[i] = "
         "integrator.y[i];\n";
    s += "  if (status == 0) status = example_" + std::string(linearises() ? "linearise" : "simulate") + "();\n";
    s += "#ifdef EXAMPLE_PRINT\n  for (int i = 0; i < 2 * N; i++) printf(\"y[%d] = %.5g\\n\", i, (double)y[i]);\n";
    if (linearises())
      s += "  for (int i = 0; i < N; i++)\n    for (int j = 0; j < 2 * N; j++) printf(\"%.5g%s\", (double)" + linear("2 * N * i + j") +
           ", j + 1 < 2 * N ? \" \" : \"\\n\");\n";
    s += "  printf(\"status %d\\n\", status);\n#endif\n  return status;\n}\n#endif\n";
    return s;
  }

private:
  bool has(const std::string &function) const { return std::count(motion_.functions.begin(), motion_.functions.end(), function) > 0; }

  std::string state() const {
    std::string s;
    for (long i = 0; i < motion_.n; ++i) s += (i ? ", " : "") + realConstant(0.1 * double(i + 1));
    return s;
  }

  std::string parameters() const {
    std::string s;
    for (const Field &f : model_.params->fields) s += "  ." + f.name + " = " + valueOf(f.type, f.name, motion_.sizes) + ",\n";
    return s;
  }

  std::string params() const { return model_.params ? "&params" : "NULL"; }
  std::string linear(const std::string &at) const { return (motionAlone_ ? "qdd_y[" : "sys.qdd_y[") + at + "]"; }

  std::string byFunctions() const {
    const bool works = motion_.work > 0;
    const std::string memory = works ? "memory" : "NULL";
    std::string s = "static tl_real qdd[N];\n";
    if (linearises()) s += "static tl_real qdd_y[N * 2 * N]; /* d qdd/d(q,qd) */\n";
    if (works) s += "static _Alignas(EOM_MOTION_ALIGNMENT) tl_real memory[" + std::to_string(motion_.work) + "];\n";
    s += "\n/* y' of y = (q,qd). */\nstatic int rhs(void *user, tl_real t, const tl_real *at, tl_real *ydot) {\n  (void)user;\n"
         "  for (int i = 0; i < N; i++) ydot[i] = at[N + i];\n  return " +
         name_ + "_acceleration(" + params() + ", at, at + N, t, ydot + N, " + memory + ");\n}\n\n";
    s += "int example_simulate(void) { return " + name_ + "_acceleration(" + params() + ", y, y + N, TL_C(0.0), qdd, " + memory +
         "); }\n";
    if (linearises())
      s += "int example_linearise(void) { return " + name_ + "_jacobian(" + params() + ", y, y + N, TL_C(0.0), qdd, qdd_y, " + memory +
           "); }\n";
    return s;
  }

  std::string needBits() const { return linearises() ? "EOM_NEED_LINEARISE" : "EOM_NEED_SIMULATE"; }

  std::string bySystem() const {
    std::string s = "static eom_system sys;\nstatic _Alignas(EOM_MOTION_ALIGNMENT) unsigned char memory[EOM_SYSTEM_BYTES(" +
                    needBits() + ", " + text_.sizes + ")];\n\n";
    s += "int example_simulate(void) { return (int)eom_acceleration(&sys, y, y + N, TL_C(0.0)); }\n";
    if (linearises()) s += "int example_linearise(void) { return (int)eom_linearise(&sys, y, y + N, TL_C(0.0)); }\n";
    return s;
  }

  std::string startSystem() const {
    return "  eom_options options = eom_options_default();\n  options.needs = " + needBits() +
           ";\n  options.emitter = EOM_EMITTER_MOTION;\n  const eom_status status = eom_system_init(&sys, &" + name_ + "_model, " +
           params() + ", &options, memory, sizeof memory);\n  if (status != EOM_OK) return (int)status;\n";
  }

  const Model &model_;
  const MotionText &motion_;
  const EmittedModel &text_;
  const bool motionAlone_;
  const std::string name_;
};

// The rule of a function that no file defines; none where all are defined.
const Rule *undefinedRule(const Program &program, const ExportFiles &carried) {
  std::set<std::string> defined;
  for (const auto &file : carried)
    if (isSource(file.first)) defined.merge(namesDefinedIn(file.second));
  for (const auto &rule : program.rules)
    if (!defined.count(rule.second.taylor)) return &rule.second;
  return nullptr;
}

// What main.c offers to a program that measures it.
std::string exampleHeader(const std::vector<std::string> &needs) {
  std::string s =
      "/* What main.c offers to a program that measures it: each returns 0, or a status other than 0. */\n#ifndef EXAMPLE_H\n"
      "#define EXAMPLE_H\n\nint example_start(void); /* to be called first */\n\n/* Once, at the state of the example. */\n";
  for (const std::string &need : needs) s += "int example_" + need + "(void);\n";
  return s + "\n#endif\n";
}

std::string cmakeFor(const std::string &name, const ExportFiles &carried) {
  std::string more;
  for (const auto &file : carried)
    if (isSource(file.first)) more += file.first + " ";
  return "# The model \"" + name +
         "\" with what it needs, as a library and as an example program; printed by tlgen.\n"
         "cmake_minimum_required(VERSION 3.22)\nproject(" +
         name +
         "_export LANGUAGES C)\nif(NOT CMAKE_BUILD_TYPE)\n"
         "  set(CMAKE_BUILD_TYPE Release)\nendif()\nset(CMAKE_C_STANDARD 11)\nset(CMAKE_C_EXTENSIONS OFF)\n"
         "file(GLOB sources CONFIGURE_DEPENDS src/*.c)\nadd_library(" +
         name + "_model STATIC " + name + "_tl.c " + more +
         "${sources})\n"
         "target_include_directories(" +
         name + "_model PUBLIC . include)\ntarget_link_libraries(" + name +
         "_model PUBLIC m)\nif(CMAKE_C_COMPILER_ID MATCHES \"GNU|Clang\")\n  target_compile_options(" + name +
         "_model PRIVATE -fno-math-errno) # a square root is then one instruction where the processor has it\nendif()\n"
         "add_executable(" +
         name + "_example main.c)\ntarget_compile_definitions(" + name +
         "_example PRIVATE EXAMPLE_PRINT)\n"
         "target_link_libraries(" +
         name + "_example PRIVATE " + name +
         "_model)\n\n"
         "# Flash, memory, stack and instructions, and what MISRA-C:2012 says, into MANIFEST and MISRA.\nfind_package(Python3 "
         "COMPONENTS Interpreter)\n"
         "if(Python3_FOUND)\n  add_custom_target(footprint COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/footprint.py\n"
         "    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})\nendif()\n";
}

// The manifest of an earlier export: hashes by path; none where there is no such manifest.
std::map<std::string, std::string> earlierFiles(const fs::path &folder) {
  std::map<std::string, std::string> files;
  std::istringstream in(readAll(folder / manifestName));
  std::string line;
  if (!std::getline(in, line) || line.compare(0, manifestTitle.size(), manifestTitle) != 0) return files;
  files[manifestName] = "";
  while (std::getline(in, line))
    if (line.compare(0, 2, "  ") == 0 && line.size() > 20 && line[18] == ' ' && line.find_first_not_of("0123456789abcdef", 2) == 18)
      files[line.substr(19)] = line.substr(2, 16);
  return files;
}

} // namespace

Content exportContent(const Model &model, const MotionText &motion, const std::set<std::string> &needs) {
  auto has = [&](const std::string &f) { return std::count(motion.functions.begin(), motion.functions.end(), f) > 0; };
  const bool constrained = std::any_of(model.functions.begin(), model.functions.end(), [](const ModelFunction &f) {
    return f.role == Role::Holonomic || f.role == Role::Nonholonomic;
  });
  if (constrained || !has("acceleration") || (needs.count("linearise") && !has("jacobian"))) return Content::Model;
  return Content::Motion;
}

ExportFiles readCarried(const std::vector<std::string> &paths, std::string &why) {
  ExportFiles files;
  for (const std::string &path : paths) {
    std::error_code none;
    std::ifstream in(path);
    if (!in || fs::is_directory(path, none)) return why = path + " cannot be read", ExportFiles{};
    files.push_back({fs::path(path).filename().string(), readAll(path)});
  }
  return files;
}

ExportFiles exportFiles(const Program &program, const Model &model, const MotionText &motion, const EmittedModel &text, Content content,
                        const std::string &real, const ExportFiles &carried, std::string &why) {
  if (!motion.any()) return why = "the model has no motion functions; --need and --size say which there are to be", ExportFiles{};
  if (content == Content::Model && text.sizes.empty())
    return why = "the memory of the model depends on its parameters; --size says what they are", ExportFiles{};
  if (const Rule *rule = undefinedRule(program, carried))
    return why = "the function '" + rule->function + "' has no C here; --carry names the file that defines its rule " + rule->taylor,
           ExportFiles{};
  if (model.name == "example") return why = "the example program has this name too; --model gives the model another", ExportFiles{};
  const Example example(model, motion, text, content);
  const std::string source = model.name + "_tl.c", header = model.name + "_tl.h";
  ExportFiles files = {{"main.c", example.text()},
                       {"example.h", exampleHeader(example.needs())},
                       {source, text.source},
                       {header, text.header},
                       {"CMakeLists.txt", cmakeFor(model.name, carried)}};
  std::vector<std::string> texts = {example.text(), text.source, text.header};
  for (const auto &file : carried) texts.push_back(file.second);
  for (const LibraryFile &file : neededFiles(texts))
    files.push_back({file.path, file.path == "include/taylor/config.h" ? configFor(file.text, real) : file.text});
  for (const LibraryFile &file : libraryFiles())
    if (file.path.compare(0, 8, "include/") && file.path.compare(0, 4, "src/")) files.push_back({file.path, file.text});
  for (const auto &file : carried) {
    const bool taken = file.first == manifestName ||
                       std::any_of(files.begin(), files.end(), [&](const auto &other) { return other.first == file.first; });
    if (taken) return why = "--carry: there is already a file of the name " + file.first, ExportFiles{};
    files.push_back(file);
  }
  std::string needs, list;
  for (const std::string &need : example.needs()) needs += " " + need;
  for (const auto &[path, content_of] : files) list += "  " + hashOf(content_of) + " " + path + "\n";
  const std::string compile = "cc -std=c11 -O2 -fno-math-errno -DNDEBUG -DEXAMPLE_PRINT -I. -Iinclude *.c src/*.c -lm -o example";
  files.push_back({manifestName, manifestTitle + "\"" + model.name + "\"\nnumbers: " + (real == "float" ? "float" : "double") +
                                     "\nneeds:" + needs + "\ncompile: " + compile + "\n\nfiles\n" + list +
                                     "\nfootprint\n  not measured yet: python3 footprint.py does, and writes it here\n"});
  return files;
}

bool canExport(const std::string &folder, const ExportFiles &files, std::vector<std::string> &stale, std::string &why) {
  std::error_code none;
  if (!fs::exists(folder, none)) return true;
  if (!fs::is_directory(folder, none)) return why = folder + " is no folder", false;
  const std::map<std::string, std::string> earlier = earlierFiles(folder);
  std::set<std::string> now;
  for (const auto &file : files) now.insert(file.first);
  for (const auto &[path, hash] : earlier)
    if (!now.count(path) && fs::exists(fs::path(folder) / path, none)) stale.push_back(path);
  std::set<std::string> touched = now;
  touched.insert(stale.begin(), stale.end());
  for (const std::string &path : touched) {
    const fs::path at = fs::path(folder) / path;
    if (!fs::exists(at, none)) continue;
    auto known = earlier.find(path);
    if (known == earlier.end()) return why = at.string() + " is not from an export; nothing was changed", false;
    if (!known->second.empty() && known->second != hashOf(readAll(at)))
      return why = at.string() + " was changed since it was exported; nothing was changed", false;
  }
  return true;
}

bool makeFolders(const std::string &folder, const ExportFiles &files, std::vector<std::string> &made) {
  std::set<std::string> wanted = {folder};
  for (const auto &file : files)
    if (file.first.find('/') != std::string::npos)
      for (fs::path p = fs::path(file.first).parent_path(); !p.empty(); p = p.parent_path())
        wanted.insert((fs::path(folder) / p).string());
  for (const std::string &path : wanted) {
    std::error_code error;
    if (fs::create_directory(path, error)) made.push_back(path);
    if (error) return errno = error.value(), false;
  }
  return true;
}

} // namespace tlgen
