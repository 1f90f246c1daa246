// Prints the test program of a model: the user's sources between macros that make them quad precision, and tables for
// <tlgen/selftest.h>.
//
// What stands behind the user's text is subject to his macros, so its own names begin with the model's or with tlgen_.
#include "Selftest.h"
#include "PrintC.h"

namespace tlgen {
namespace {

bool isNumber(const Type *type) { return type->kind == Type::Real || type->kind == Type::Integer; }

class SelftestPrinter {
public:
  SelftestPrinter(const Source &source, const Match &match, const Options &options, const Program &program, const Model &model,
                  bool single, Diagnostics &diags)
      : source_(source), match_(match), options_(options), program_(program), model_(model), single_(single), diags_(diags) {}

  std::vector<std::pair<std::string, std::string>> run() {
    std::vector<std::pair<std::string, std::string>> files;
    for (size_t k = 0; k < options_.sources.size(); ++k)
      files.push_back({options_.selftestFile(k), title(k) + (k == 0 ? program() : "") + quadSource(k) + params(k) + functions(k)});
    return files;
  }

private:
  std::string baseName(size_t k) const { return options_.sources[k].substr(options_.sources[k].find_last_of('/') + 1); }
  std::string quadName(size_t i) const { return model_.name + "_quad_" + std::to_string(i + 1); }
  size_t unitOf(size_t i) const { return source_.unitOf(match_.functions[i].function); }

  std::string title(size_t k) const {
    std::string s = "/* Test of the model \"" + model_.name + "\": its derivatives against differences of " + baseName(k) +
                    " in quad precision, printed by tlgen. Do not edit.\n *\n";
    s += k == 0 ? " * Compile it as the source is compiled, with the folder of the source among the include paths, and link the "
                  "generated model, "
                  "tlgen_selftest,\n * eom, taylor, quadmath and m. --help of the program says how to name points. */\n"
                : " * Link it with " + nameOf(options_.selftestFile(0)) + ". */\n";
    return s + "#include <tlgen/selftest.h>\n\n";
  }

  static std::string nameOf(const std::string &path) { return path.substr(path.find_last_of('/') + 1); }

  bool takesTime() const {
    for (const ModelFunction &f : model_.functions)
      for (const Arg &arg : f.args)
        if (arg.role == ArgRole::T) return true;
    return false;
  }

  std::string program() const {
    std::string declared, listed, params = model_.name + "_params";
    for (size_t i = 0; i < model_.functions.size(); ++i) {
      declared += (i ? ", " : "") + quadName(i);
      listed += (i ? ", " : "") + quadName(i);
    }
    return "extern const eom_model " + model_.name + "_model;\n" + "tlgen_quad_fn " + declared + ";\n" +
           (model_.params ? "extern const tlgen_params " + params + ";\n" : "") +
           "\nint main(int argc, char **argv)\n{\n  static tlgen_quad_fn *const functions[] = {" + listed + "};\n" +
           "  const tlgen_selftest test = {&" + model_.name + "_model, functions, " + (model_.params ? "&" + params : "NULL") + ", " +
           (takesTime() ? "1" : "0") + (single_ ? ", 1" : ", 0") + "};\n  return tlgen_selftest_main(argc, argv, &test);\n}\n\n";
  }

  std::string quadSource(size_t k) const {
    std::string s;
    for (const std::string &name : source_.systemHeaders(k)) s += "#include <" + name + ">\n";
    return s + (single_ ? "#define TLGEN_QUAD_SINGLE\n" : "") + "#include <tlgen/quad.h>\n#define main tlgen_user_main\n#include \"" +
           baseName(k) + "\"\n";
  }

  // The parameter struct in double and its members, in the file whose source has the first function that takes it.
  std::string params(size_t k) {
    if (!model_.params || k != paramsUnit()) return "";
    std::string s = "\n/* The parameter struct in double. */\nstruct " + model_.name + "_double {\n";
    for (const Field &field : model_.params->fields) s += "  " + member(field.type, field.name) + ";\n";
    s += "};\n\nstatic const tlgen_member " + model_.name + "_members[] = {\n";
    for (const Field &field : model_.params->fields) s += rows(field.type, field.name);
    std::string name = model_.name + "_members", declared = k ? "extern const tlgen_params " + model_.name + "_params;\n" : "";
    return s + "};\n" + declared + "const tlgen_params " + model_.name + "_params = {sizeof(struct " + model_.name +
           "_double), sizeof(" + model_.params->spelling + "), sizeof " + name + " / sizeof *" + name + ", " + name + "};\n";
  }

  size_t paramsUnit() const {
    for (size_t i = 0; i < model_.functions.size(); ++i)
      for (const Arg &arg : model_.functions[i].args)
        if (arg.role == ArgRole::Params) return unitOf(i);
    return 0;
  }

  // A number's type, whatever quad.h makes of its name.
  static std::string ours(const Type *number) {
    return number->name == "double" ? "tlgen_double" : number->name == "float" ? "tlgen_single" : number->name;
  }

  // A member's declaration, structs written out.
  static std::string member(const Type *type, const std::string &name) {
    switch (type->kind) {
    case Type::Array:
      return member(type->element, name + "[" + std::to_string(type->count) + "]");
    case Type::Pointer:
      return "const void *" + name;
    case Type::Struct: {
      std::string s = "struct {";
      for (const Field &field : type->record->fields) s += " " + member(field.type, field.name) + ";";
      return s + " } " + name;
    }
    default:
      return ours(type) + " " + name;
    }
  }

  // Rows of the table of members: one for a number or an array of numbers, and so for each element and member of others.
  std::string rows(const Type *type, const std::string &path) {
    if (type->kind == Type::Pointer && isNumber(type->element)) return row(type->element, path, "0");
    const Type *element = type;
    long count = 1;
    for (; element->kind == Type::Array; element = element->element) count *= element->count;
    if (count > 0 && isNumber(element)) return row(element, path, std::to_string(count));
    std::string s;
    if (type->kind == Type::Array && type->count > 0) {
      for (long i = 0; i < type->count; ++i) s += rows(type->element, path + "[" + std::to_string(i) + "]");
    } else if (type->kind == Type::Struct) {
      for (const Field &field : type->record->fields) s += rows(field.type, path + "." + field.name);
    } else {
      diags_.add("selftest-member", program_, model_.params->loc, "member '" + path + "'");
    }
    return s;
  }

  std::string row(const Type *number, const std::string &path, const std::string &count) const {
    bool real = number->kind == Type::Real, isUnsigned = number->name.compare(0, 8, "unsigned") == 0 || number->name == "_Bool";
    std::string kind = real         ? (number->name == "double" ? "TLGEN_DOUBLE" : "TLGEN_FLOAT")
                       : isUnsigned ? "TLGEN_UNSIGNED"
                                    : "TLGEN_SIGNED";
    return "  TLGEN_MEMBER(struct " + model_.name + "_double, " + model_.params->spelling + ", " + kind + ", " + ours(number) + ", " +
           number->name + ", " + count + ", " + path + "),\n";
  }

  std::string functions(size_t k) const {
    std::string s;
    for (size_t i = 0; i < model_.functions.size(); ++i)
      if (unitOf(i) == k) s += adapter(i);
    return s;
  }

  // From the test's signature to the user's order of arguments.
  std::string adapter(size_t i) const {
    static const char *const names[] = {"tlgen_q", "tlgen_qd", "tlgen_t", "tlgen_params", "tlgen_out"};
    const ModelFunction &f = model_.functions[i];
    bool used[5] = {}, returns = f.function->result->kind == Type::Real;
    std::string args, unused;
    for (const Arg &arg : f.args) {
      int role = static_cast<int>(arg.role);
      args += (args.empty() ? "" : ", ") + std::string(names[role]) + (arg.index >= 0 ? "[" + std::to_string(arg.index) + "]" : "");
      used[role] = true;
    }
    used[static_cast<int>(ArgRole::Out)] |= returns;
    for (int role = 0; role < 5; ++role)
      if (!used[role]) unused += std::string("  (void)") + names[role] + ";\n";
    std::string declared = unitOf(i) ? "tlgen_quad_fn " + quadName(i) + ";\n" : "";
    return "\n" + declared + "void " + quadName(i) +
           "(__float128 *tlgen_out, __float128 *tlgen_q, __float128 *tlgen_qd, __float128 tlgen_t, void *tlgen_params)\n{\n" + unused +
           "  " + (returns ? "tlgen_out[0] = " : "") + f.function->name + "(" + args + ");\n}\n";
  }

  const Source &source_;
  const Match &match_;
  const Options &options_;
  const Program &program_;
  const Model &model_;
  bool single_;
  Diagnostics &diags_;
};

} // namespace

std::vector<std::pair<std::string, std::string>> selftestFiles(const Source &source, const Match &match, const Options &options,
                                                               const Program &program, const Model &model, bool single,
                                                               Diagnostics &diags) {
  return SelftestPrinter(source, match, options, program, model, single, diags).run();
}

} // namespace tlgen
