// The table of parameters: one row per member that holds numbers, in the order of memory.
#include "EmitDescription.h"

#include "MemoryCheck.h"

#include <sstream>

namespace tlgen {
namespace {

// The comment that begins behind the member's declaration on the same line, in one line and without the marks of documentation tools.
std::string commentBeside(const Program &program, const Loc &loc) {
  if (loc.line == 0) return "";
  const std::vector<std::string> &lines = program.sources[static_cast<size_t>(loc.file)];
  size_t row = loc.line - 1, end = lines[row].find(';', loc.column - 1);
  if (end == std::string::npos) return "";
  size_t mark = lines[row].find_first_not_of(" \t", end + 1);
  if (mark == std::string::npos) return "";
  const std::string opening = lines[row].substr(mark, 2);
  if (opening != "/*" && opening != "//") return "";
  std::string text = lines[row].substr(mark + 2), words;
  if (opening == "/*") {
    while (text.find("*/") == std::string::npos && ++row < lines.size()) text += " " + lines[row];
    text = text.substr(0, text.find("*/"));
  }
  text.erase(0, text.find_first_not_of("*!/<"));
  std::istringstream split(text);
  for (std::string word; split >> word;)
    if (word != "*") words += (words.empty() ? "" : " ") + word;
  return words;
}

// A C string, or NULL where it is empty. Bytes above 127 stay: comments are UTF-8.
std::string literal(const std::string &text) {
  if (text.empty()) return "NULL";
  std::string s = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\' || c == '?') s += '\\'; // ?: no trigraphs
    s += c;
  }
  return s + "\"";
}

class ParameterTable {
public:
  ParameterTable(const Program &program, const Model &model) : program_(program), model_(model) {}

  std::string rows() {
    members(model_.params, "", {});
    return text_;
  }
  size_t count() const { return count_; }

private:
  void members(const Record *record, const std::string &prefix, const Loc &outer) {
    for (const Field &f : record->fields) member(f.type, prefix + f.name, f.loc.line ? f.loc : outer);
  }

  // Structs, and all dimensions of an array but the last, are taken apart.
  void member(const Type *type, const std::string &name, const Loc &loc) {
    if (type->kind == Type::Struct) return members(type->record, name + ".", loc);
    const Type *element = type->kind == Type::Array ? type->element : type;
    if (type->kind == Type::Array && (element->kind == Type::Array || element->kind == Type::Struct)) {
      for (long i = 0; i < type->count; ++i) member(element, name + "[" + std::to_string(i) + "]", loc);
      return;
    }
    const std::string kind = number(element), comment = literal(commentBeside(program_, loc)),
                      at = model_.params->spelling + ", " + name;
    if (kind == "NONE")
      text_ += "  EOM_MEMBER_NONE(" + at + ", " + comment + "),\n";
    else if (type->kind == Type::Array)
      text_ += "  EOM_MEMBER_ARRAY(" + at + ", " + std::to_string(type->count) + ", " + kind + ", " + comment + "),\n";
    else if (const long most = type->kind == Type::Integer && kind != "BOOL" ? largestSize(program_, model_, name) : 0; most > 0)
      text_ += "  EOM_MEMBER_UP_TO(" + at + ", " + std::to_string(most) + ", " + kind + ", " + comment + "),\n";
    else
      text_ += "  EOM_MEMBER(" + at + ", " + kind + ", " + comment + "),\n";
    ++count_;
  }

  static std::string number(const Type *type) {
    if (type->kind == Type::Real) return "REAL";
    if (type->kind != Type::Integer || type->name.compare(0, 9, "_Alignas(") == 0) return "NONE"; // room that nobody may touch
    if (type->name == "_Bool") return "BOOL";
    return type->name.compare(0, 8, "unsigned") == 0 ? "UNSIGNED" : "INTEGER";
  }

  const Program &program_;
  const Model &model_;
  std::string text_;
  size_t count_ = 0;
};

// The names of coordinates or velocities that are arguments of the Lagrangian one by one; empty where it takes an array.
std::string namesOf(const Model &model, ArgRole role) {
  std::vector<std::string> names;
  for (const ModelFunction &f : model.functions)
    for (size_t k = 0; f.role == Role::Lagrangian && k < f.args.size(); ++k) {
      const Arg &arg = f.args[k];
      if (arg.role != role || arg.index < 0) continue;
      if (names.size() <= static_cast<size_t>(arg.index)) names.resize(static_cast<size_t>(arg.index) + 1);
      names[static_cast<size_t>(arg.index)] = f.function->params[k]->name;
    }
  if (!model.dof.member.empty() || names.size() != static_cast<size_t>(model.dof.value)) return "";
  std::string s;
  for (const std::string &name : names) {
    if (name.empty()) return "";
    s += (s.empty() ? "\"" : ", \"") + name + "\"";
  }
  return s;
}

} // namespace

std::string emitDescription(const Program &program, const Model &model, bool motion) {
  std::string s, parameters = "NULL", count = "0", names;
  if (model.params) {
    ParameterTable table(program, model);
    const std::string rows = table.rows();
    if (table.count() > 0) {
      parameters = model.name + "_member";
      count = std::to_string(table.count());
      s += "\nstatic const eom_parameter " + parameters + "[] = {\n" + rows + "};\n";
    }
  }
  for (const ArgRole role : {ArgRole::Q, ArgRole::Qd}) {
    const std::string list = namesOf(model, role), array = model.name + (role == ArgRole::Q ? "_coordinate" : "_velocity");
    names += list.empty() ? ", NULL" : ", " + array;
    if (!list.empty()) s += "\nstatic const char *const " + array + "[] = {" + list + "};\n";
  }
  return s + "\nconst eom_description " + model.name + "_description = {EOM_DESCRIPTION_VERSION, sizeof(eom_model), " +
         (motion ? "sizeof(eom_motion)" : "0") + ", &" + model.name + "_model, " + parameters + ", " + count + names +
         "};\n\n"
         "#ifdef EOM_SHARED_MODEL /* the model of a shared object */\n"
         "const eom_description *eom_shared_model(void)\n{\n  return &" +
         model.name + "_description;\n}\n#endif\n";
}

} // namespace tlgen
