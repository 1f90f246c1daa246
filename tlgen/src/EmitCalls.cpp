// The calls emitter: tables, structs and functions in order, and the constant that describes the model to the runtime.
#include "EmitCalls.h"
#include "EmitDescription.h"
#include "FrameBound.h"
#include "Names.h"

#include <algorithm>
#include <functional>
#include <set>

namespace tlgen {
namespace {

class ModelEmitter {
public:
  ModelEmitter(const Program &program, const Model &model, const Activity &activity, const MotionText &motion, Diagnostics &diags,
               Content content)
      : program_(program), model_(model), activity_(activity), motion_(motion), diags_(diags), content_(content), needed_(needed()) {}

  EmittedModel run(const std::string &headerName) {
    nameVariants();
    std::set<int> files;
    for (const Variant *v : activity_.variants()) files.insert(v->function->loc.file);
    emitted_.severalFiles = files.size() > 1;
    std::string functions, prototypes;
    for (const Variant *v : activity_.variants()) {
      std::string text = FunctionEmitter(program_, *v, emitted_).run();
      if (!model_.recursion.empty()) prototypes += text.substr(0, text.find("\n{")) + ";\n";
      functions += banner(*v) + text + "\n";
    }
    if (!prototypes.empty()) functions = prototypes + "\n" + functions;
    EmittedModel out;
    out.header = header();
    out.source = title(".") + (userHeaders().empty() ? "" : "#define " + ownMark() + "\n") + "#include \"" + headerName + "\"\n";
    if (content_ == Content::Motion) {
      out.source += (program_.rules.empty() ? "" : "\n#include \"taylor/rule.h\"\n") + kernels() + "\n" + sourceRecords() +
                    externals() + tables() + motion_.source;
      return out;
    }
    out.source += "\n#include \"taylor/taylor.h\"\n" + kernels() + "\n" + sourceRecords() + externals() + tables() + functions +
                  adapters() + motion_.source + description();
    if (content_ == Content::Whole) out.source += emitDescription(program_, model_, motion_.any());
    out.sizes = sizes();
    return out;
  }

private:
  std::string title(const std::string &ending) const {
    std::string from;
    for (const ModelFunction &f : model_.functions) {
      const std::string &file = program_.files[static_cast<size_t>(f.function->loc.file)];
      if (from.find(file) == std::string::npos) from += (from.empty() ? "" : ", ") + file;
    }
    return "/* Model \"" + model_.name + "\" on truncated Taylor series, printed by tlgen from " + from + ending + " Do not edit. */\n";
  }

  // The headers that motion functions call.
  std::string kernels() const {
    if (!motion_.any()) return "";
    auto calls = [&](const char *name) { return motion_.source.find(name) != std::string::npos; };
    return std::string("\n#include \"eom/motion.h\"\n") + (calls("tl_series_") ? "#include \"taylor/convolve.h\"\n" : "") +
           "#include \"taylor/finite.h\"\n#include \"taylor/ldl.h\"\n" + (calls("tl_power") ? "#include \"taylor/power.h\"\n" : "") +
           (calls("tl_row") ? "#include \"taylor/row.h\"\n" : "") + "#include \"taylor/sincos_array.h\"\n" +
           (calls("tl_lanes") ? "#include \"taylor/ldl_lanes.h\"\n#include \"taylor/sincos_lanes.h\"\n" : "") +
           "\n"
           "#ifdef __clang__\n#pragma clang diagnostic ignored \"-Wpass-failed\" /* a loop that is not worth a vector */\n#endif\n";
  }

  // A struct that stands in a .c file can be had from nowhere else, so the header defines it; one from a header is the user's to
  // include, but not that of an export, which has all it needs.
  bool inHeader(const Record *r) const {
    if (content_ != Content::Whole) return true;
    return isSource(program_.files[static_cast<size_t>(r->loc.file)]);
  }

  // The header's own structs and those that they consist of.
  std::set<const Record *> needed() const {
    std::set<const Record *> all;
    std::function<void(const Record *)> take = [&](const Record *r) {
      if (!all.insert(r).second) return;
      for (const Field &field : r->fields) {
        const Type *t = field.type;
        while (t->kind == Type::Array) t = t->element;
        if (t->kind == Type::Struct) take(t->record);
      }
    };
    for (const Record *r : program_.records)
      if (inHeader(r)) take(r);
    return all;
  }

  // Several models may be made of one file, and their headers included together.
  static std::string guarded(const Record *r) {
    std::string guard = "TLGEN_STRUCT_" + (r->tag.empty() ? r->spelling : r->tag);
    return "#ifndef " + guard + "\n#define " + guard + "\n" + definition(r) + "#endif\n\n";
  }

  // The user's headers with structs that the header needs: whoever includes it may include them too.
  std::string userHeaders() const {
    std::vector<std::string> names;
    for (const Record *r : program_.records)
      if (needed_.count(r) && !inHeader(r)) {
        const std::string &name = program_.files[static_cast<size_t>(r->loc.file)];
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    std::string s;
    for (const std::string &name : names) s += "#include \"" + name + "\"\n";
    return s;
  }

  std::string definitions(const std::set<const Record *> &of, bool guard) const {
    std::string s;
    for (const Record *r : program_.records)
      if (of.count(r)) s += guard ? guarded(r) : definition(r) + "\n";
    return s;
  }

  // All structs for the functions; for others the header's own, behind the headers of the rest. Those have doubles: in a build with
  // other numbers nobody can share them, and all structs are the header's own.
  std::string headerRecords() const {
    std::set<const Record *> own, foreign;
    for (const Record *r : needed_) (inHeader(r) ? own : foreign).insert(r);
    std::string before;
    if (!foreign.empty())
      before = "#if defined " + ownMark() + " || TL_REAL != TL_DOUBLE\n" + definitions(foreign, false) + "#else\n" + userHeaders() +
               "#endif\n\n";
    return before + definitions(own, true);
  }

  std::string sourceRecords() const {
    std::set<const Record *> rest(program_.records.begin(), program_.records.end());
    for (const Record *r : needed_) rest.erase(r);
    return definitions(rest, false);
  }

  // Defined where the header is read by the model's own functions.
  std::string ownMark() const { return "TLGEN_" + model_.name + "_FUNCTIONS"; }

  std::string header() const {
    std::string guard = model_.name + "_TL_H";
    std::transform(guard.begin(), guard.end(), guard.begin(), [](unsigned char ch) { return static_cast<char>(toupper(ch)); });
    const bool lanes = motion_.header.find("tl_lanes") != std::string::npos;
    const std::string includes = content_ == Content::Whole ? "description.h" : content_ == Content::Model ? "model.h" : "motion.h";
    std::string declared;
    if (content_ != Content::Motion) declared += "extern const eom_model " + model_.name + "_model;\n";
    if (content_ == Content::Whole) declared += "extern const eom_description " + model_.name + "_description;\n";
    return title(".") + "#ifndef " + guard + "\n#define " + guard + "\n\n" + includesOf(program_.records) + "#include \"eom/" +
           includes + "\"\n" + (lanes ? "#include \"taylor/lanes.h\"\n\n" : "\n") + headerRecords() +
           "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n" + declared + motion_.header + "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
  }

  // Functions from elsewhere. Of stdlib.h only those that are called, since its other names may be the user's.
  std::string externals() const {
    std::string s;
    for (const std::string &name : emitted_.absolutes) {
      std::string type = name == "abs" ? "int" : name == "labs" ? "long" : "long long";
      s += type + " " + name + "(" + type + ");\n";
    }
    for (const auto &rule : program_.rules) {
      std::string args = "double";
      for (size_t i = 1; i < rule.second.arity; ++i) args += ", double";
      s += "double " + rule.second.function + "(" + args + ");\n";
      s += std::string(rule.second.arity == 1 ? "tl_rule " : "tl_rule_n ") + rule.second.taylor + ";\n";
    }
    return s.empty() ? s : s + "\n";
  }

  std::string tables() const {
    std::string s;
    for (const Variable *v : program_.globals) s += "static " + declaration(v->type, v->name) + " = " + initializer(v->init) + ";\n";
    return s.empty() ? s : s + "\n";
  }

  // The user's name for a function that stays plain C, with _tl behind it for one on jets, and with a number where there are several.
  void nameVariants() {
    std::set<std::string> used;
    for (const Variant *v : activity_.variants()) {
      const std::string &own = v->function->name;
      std::string stem = own + (v->active() ? "_tl" : "");
      if (reservedFunctionName(stem, model_.name)) stem = model_.name + "_" + stem;
      std::string name = stem;
      auto free = [&] {
        return (name == own || !program_.names.count(name)) && !reservedFunctionName(name, model_.name) && used.insert(name).second;
      };
      for (int n = 2; !free(); ++n) name = stem + std::to_string(n);
      emitted_.names[v] = name;
    }
  }

  std::string banner(const Variant &v) const {
    const Loc &loc = v.function->loc;
    return "/* " + v.function->name + ", " + program_.files[static_cast<size_t>(loc.file)] + ":" + std::to_string(loc.line) + ". */\n";
  }

  std::string adapterName(size_t i) const {
    static const char *const roles[] = {"lagrangian", "force", "dissipation", "holonomic", "nonholonomic"};
    Role role = model_.functions[i].role;
    std::string name = roles[static_cast<int>(role)];
    long n = 0;
    for (size_t k = 0; k < i; ++k) n += model_.functions[k].role == role;
    bool several = role == Role::Holonomic || role == Role::Nonholonomic;
    return model_.name + "_" + name + (several ? std::to_string(n + 1) : "") + "_jet";
  }

  std::string adapters() const {
    std::string s;
    for (size_t i = 0; i < model_.functions.size(); ++i) s += adapter(i);
    return s;
  }

  // From the runtime's signature to the user's order of arguments.
  std::string adapter(size_t i) const {
    const ModelFunction &f = model_.functions[i];
    const Variant *v = activity_.roots()[i];
    std::string args = "cx", unused;
    if (find(v->result)->active) args += ", out";
    bool used[5] = {}, several = false;
    for (size_t k = 0; k < f.args.size(); ++k) {
      static const char *const names[] = {"q", "qd", "t", "params", "out"};
      const Variable *param = f.function->params[k];
      Arg arg = f.args[k];
      bool array = (arg.role == ArgRole::Q || arg.role == ArgRole::Qd) && arg.index < 0;
      bool changeable = param->type->kind == Type::Pointer && !param->type->element->isConst;
      std::string cast = array && changeable                         ? "(tl_real *)"
                         : arg.role == ArgRole::Params && changeable ? "(" + model_.params->spelling + " *)"
                                                                     : "";
      args += ", " + cast + names[static_cast<int>(arg.role)];
      if (arg.index > 0) args += arg.index == 1 ? " + nc" : " + " + std::to_string(arg.index) + "*nc";
      several |= arg.index > 0;
      used[static_cast<int>(arg.role)] = true;
    }
    if (several) unused = "  const ptrdiff_t nc = cx->shape->ncoef;\n";
    if (!used[0]) unused += "  (void)q;\n";
    if (!used[1]) unused += "  (void)qd;\n";
    if (!used[2]) unused += "  (void)t;\n";
    if (!used[3]) unused += "  (void)params;\n";
    std::string body;
    if (!v->active())
      body = "  tl_const(cx, out, " + emitted_.names.at(v) + "(" + args.substr(std::min(args.size(), size_t(4))) + "));\n";
    else if (f.function->result->kind == Type::Real && !find(v->result)->active)
      body = "  tl_const(cx, out, " + emitted_.names.at(v) + "(" + args + "));\n";
    else
      body = "  " + emitted_.names.at(v) + "(" + args + ");\n";
    return "static void " + adapterName(i) +
           "(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params)\n{\n" + unused +
           body + "}\n\n";
  }

  std::string countFunction(const std::string &name, const Count &count) const {
    std::string value = std::to_string(count.value), unused = "  (void)params;\n";
    if (!count.member.empty()) value = "(int)((const " + model_.params->spelling + " *)params)->" + count.member, unused = "";
    return "static int " + name + "(const void *params)\n{\n" + unused + "  return " + value + ";\n}\n\n";
  }

  std::string frameFunction(size_t i) const {
    Bound bound = FrameBound(emitted_, program_, model_, diags_).of(activity_.roots()[i], model_.functions[i].args);
    std::string start = bound.usesParams() ? "  const " + model_.params->spelling + " *const p = params;\n" : "  (void)params;\n";
    return "static size_t " + stem(i) + "_frame(const void *params)\n{\n" + start + "  return " + bound.text() + ";\n}\n\n";
  }

  std::string stem(size_t i) const { return adapterName(i).substr(0, adapterName(i).size() - 4); }

  // One eom_function as an initialiser.
  std::string entry(size_t i, const std::string &rows) const {
    const ModelFunction &f = model_.functions[i];
    std::string place = program_.files[static_cast<size_t>(f.function->loc.file)] + ":" + std::to_string(f.function->loc.line);
    return "{\"" + f.function->name + "\", \"" + place + "\", " + adapterName(i) + ", " + rows + ", " + stem(i) + "_frame}";
  }

  std::string description() const {
    std::string s, lists;
    if (motion_.any()) s = "static const eom_motion *const " + model_.name + "_motions[] = {&" + model_.name + "_motion};\n\n";
    s += countFunction(model_.name + "_dof", model_.dof);
    std::string lagrangian = "{0}", force = "{0}", dissipation, constraints[2];
    int counts[2] = {};
    for (size_t i = 0; i < model_.functions.size(); ++i) {
      const ModelFunction &f = model_.functions[i];
      s += frameFunction(i);
      std::string rows = f.role == Role::Force ? model_.name + "_dof" : stem(i) + "_rows";
      if (f.role != Role::Force) s += countFunction(rows, f.rows);
      if (f.role == Role::Lagrangian)
        lagrangian = entry(i, rows);
      else if (f.role == Role::Force)
        force = entry(i, rows);
      else if (f.role == Role::Dissipation)
        dissipation = ",\n  .dissipation = " + entry(i, rows);
      else {
        int kind = f.role == Role::Nonholonomic;
        constraints[kind] += "  " + entry(i, rows) + ",\n";
        ++counts[kind];
      }
    }
    static const char *const kinds[] = {"holonomic", "nonholonomic"};
    std::string pointers[2];
    for (int k = 0; k < 2; ++k) {
      pointers[k] = counts[k] ? model_.name + "_" + kinds[k] : "NULL";
      if (counts[k]) lists += "static const eom_function " + pointers[k] + "[] = {\n" + constraints[k] + "};\n\n";
    }
    std::string size = model_.params ? "sizeof(" + model_.params->spelling + ")" : "0";
    return s + lists + "const eom_model " + model_.name + "_model = {\n  .name = \"" + model_.name + "\",\n  .dof = " + model_.name +
           "_dof,\n  .params_size = " + size + ",\n  .lagrangian = " + lagrangian + ",\n  .force = " + force + dissipation +
           ",\n  .holonomic = " + pointers[0] + ",\n  .nholonomic = " + std::to_string(counts[0]) +
           ",\n  .nonholonomic = " + pointers[1] + ",\n  .nnonholonomic = " + std::to_string(counts[1]) +
           (motion_.any() ? ",\n  .motion = " + model_.name + "_motions,\n  .nmotion = 1" : "") + ",\n};\n";
  }

  // n, m1, m2, work, constant mass, and the most rows and the largest frame of holonomic, nonholonomic and all functions.
  std::string sizes() const {
    long rows[3] = {}, frames[3] = {};
    for (size_t i = 0; i < model_.functions.size(); ++i) {
      const ModelFunction &f = model_.functions[i];
      Diagnostics said;
      const Bound bound = FrameBound(emitted_, program_, model_, said).of(activity_.roots()[i], f.args);
      auto size = motion_.sizes.find(f.rows.member);
      const bool known = f.rows.member.empty() || size != motion_.sizes.end();
      if (!bound.terms.empty() || !known || !motion_.any()) return "";
      const long count = f.role == Role::Force ? motion_.n : f.rows.member.empty() ? f.rows.value : size->second;
      const int kind = f.role == Role::Holonomic ? 0 : f.role == Role::Nonholonomic ? 1 : 2;
      for (int k : {kind, 2}) rows[k] = std::max(rows[k], count), frames[k] = std::max(frames[k], bound.fixed);
    }
    std::string s;
    for (long number : {motion_.n, motion_.m1, motion_.m2, motion_.work, long(motion_.constantMass)})
      s += std::to_string(number) + ", ";
    for (int k = 0; k < 3; ++k) s += std::to_string(rows[k]) + ", " + std::to_string(frames[k]) + (k < 2 ? ", " : "");
    return s;
  }

  const Program &program_;
  const Model &model_;
  const Activity &activity_;
  const MotionText &motion_;
  Diagnostics &diags_;
  const Content content_;
  const std::set<const Record *> needed_;
  Emitted emitted_;
};

} // namespace

EmittedModel emitCalls(const Program &program, const Model &model, const Activity &activity, const MotionText &motion,
                       Diagnostics &diags, const std::string &headerName, Content content) {
  return ModelEmitter(program, model, activity, motion, diags, content).run(headerName);
}

} // namespace tlgen
