// C text: declarators, expressions, initialisers.
#include "PrintC.h"
#include "MathFunctions.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

namespace tlgen {

std::string operand(const Text &t, int least) { return t.precedence >= least ? t.s : "(" + t.s + ")"; }

int precedenceOf(const std::string &op) {
  static const std::map<std::string, int> table = {
      {"*", Product},  {"/", Product},  {"%", Product},   {"+", Sum},       {"-", Sum},       {"<<", Shift},    {">>", Shift},
      {"<", Relation}, {">", Relation}, {"<=", Relation}, {">=", Relation}, {"==", Equality}, {"!=", Equality}, {"&", BitAnd},
      {"^", BitXor},   {"|", BitOr},    {"&&", And},      {"||", Or},       {",", Sequence}};
  auto it = table.find(op);
  return it == table.end() ? Assignment : it->second;
}

Text binaryText(const std::string &op, const Text &a, const Text &b) {
  int p = precedenceOf(op);
  if (p == Assignment) return {operand(a, Prefix) + " " + op + " " + operand(b, Assignment), p};
  // Compilers warn where && stands in ||, and where arithmetic or comparisons stand bare in shifts, bit operations and comparisons.
  bool arithmetic = p == Product || p == Sum;
  int least = p;
  if (!arithmetic && p != And && p != Or) least = p == Relation || p == Equality ? Sum : Prefix;
  if (p == Or) least = Equality;
  int right = arithmetic ? p + 1 : least;
  if (op == ",") return {operand(a, Sequence) + ", " + operand(b, Assignment), p};
  if ((p == Relation || p == Equality) && (a.s[0] == '!')) return binaryText(op, {"(" + a.s + ")", Primary}, b);
  std::string left = operand(a, p == And && a.precedence == And ? And : p == Or && a.precedence == Or ? Or : p == And ? BitOr : least);
  std::string r = operand(b, p == And ? BitOr : right);
  return {left + " " + op + " " + r, p};
}

Text unaryText(const std::string &op, const Text &a) {
  std::string s = operand(a, Prefix);
  bool glued = !s.empty() && (s[0] == op[0]); // - -x, not --x
  return {op + (glued ? " " : "") + s, Prefix};
}

std::string decimal(double value) {
  char text[32];
  for (int digits = 1; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  std::string s = text;
  return s.find_first_of(".en") == std::string::npos ? s + ".0" : s;
}

std::string realConstant(const std::string &decimal) {
  const bool negative = decimal[0] == '-';
  return (negative ? "-TL_C(" : "TL_C(") + decimal.substr(negative) + ")";
}

std::string realConstant(double value) { return realConstant(decimal(value)); }

Text literalText(const Expr *e) {
  const bool real = e->type->kind == Type::Real && !isSingle(e->type) && e->text != "0";
  return {real ? realConstant(e->text) : e->text, e->text[0] == '-' ? Prefix : Primary};
}

Text mathText(const std::string &name, const std::string &args) {
  const MathFunction *f = findMath(name);
  const bool ofDoubles = f && f->name == name && f->kind != MathFunction::Test;
  return {(ofDoubles ? "TL_LIBM(" + name + ")" : name) + "(" + args + ")", Postfix};
}

size_t readLength(const std::string &text) {
  size_t length = text.size();
  for (const std::string mark : {"TL_C(", "TL_LIBM("})
    for (size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += mark.size()) length -= mark.size() + 1;
  return length;
}

Text externalText(const std::string &name, const std::vector<Text> &args) {
  std::string list;
  for (const Text &arg : args) list += (list.empty() ? "(double)" : ", (double)") + operand(arg, Prefix);
  return {"(tl_real)" + name + "(" + list + ")", Prefix};
}

std::string declaration(const Type *type, const std::string &name) {
  switch (type->kind) {
  case Type::Array:
    return declaration(type->element, name + "[" + std::to_string(type->count) + "]");
  case Type::Pointer: {
    std::string inner = std::string("*") + (type->isConst ? "const " : "") + name;
    return declaration(type->element, type->element->kind == Type::Array ? "(" + inner + ")" : inner);
  }
  default: {
    const bool real = type->kind == Type::Real && !isSingle(type);
    std::string base = type->kind == Type::Void     ? "void"
                       : type->kind == Type::Struct ? type->record->spelling
                       : real                       ? "tl_real"
                                                    : type->name;
    return std::string(type->isConst ? "const " : "") + base + (name.empty() || name[0] == '[' ? "" : " ") + name;
  }
  }
}

// Keywords of C that C++ has under the names of a standard header's macros.
struct SharedName {
  const char *keyword, *name, *header;
};
static const SharedName sharedNames[] = {{"_Bool", "bool", "stdbool.h"}, {"_Alignas", "alignas", "stdalign.h"}};

static const SharedName *sharedName(const Type *type) {
  while (type->kind == Type::Array || type->kind == Type::Pointer) type = type->element;
  for (const SharedName &shared : sharedNames)
    if (type->kind == Type::Integer && type->name.compare(0, strlen(shared.keyword), shared.keyword) == 0) return &shared;
  return nullptr;
}

std::string includesOf(const std::vector<const Record *> &records) {
  std::set<std::string> headers;
  for (const Record *record : records)
    for (const Field &field : record->fields)
      if (const SharedName *shared = sharedName(field.type)) headers.insert(shared->header);
  std::string s;
  for (const std::string &header : headers) s += "#include <" + header + ">\n";
  return s;
}

static std::string memberDeclaration(const Field &field) {
  std::string s = declaration(field.type, field.name);
  if (const SharedName *shared = sharedName(field.type)) s.replace(s.find(shared->keyword), strlen(shared->keyword), shared->name);
  return s;
}

std::string definition(const Record *record) {
  if (record->fields.empty()) return record->spelling + ";\n";
  bool anonymous = record->tag.empty();
  std::string s = anonymous ? "typedef struct {\n" : "struct " + record->tag + " {\n";
  for (const Field &field : record->fields) s += "  " + memberDeclaration(field) + ";\n";
  return s + (anonymous ? "} " + record->spelling : "}") + ";\n";
}

std::string zeroValue(const Type *type) {
  if (type->kind == Type::Array) return "{" + zeroValue(type->element) + "}";
  if (type->kind != Type::Struct) return "0";
  std::string s;
  for (const Field &field : type->record->fields) s += (s.empty() ? "" : ", ") + zeroValue(field.type);
  return "{" + s + "}";
}

std::string zeroItem(const Type *type, size_t i) {
  return zeroValue(type->kind == Type::Array ? type->element : type->kind == Type::Struct ? type->record->fields[i].type : type);
}

std::string initializer(const Expr *e) {
  if (!e) return "0";
  switch (e->kind) {
  case Expr::InitList: {
    std::string s = "{";
    for (size_t i = 0; i < e->args.size(); ++i) s += (i ? ", " : "") + (e->args[i] ? initializer(e->args[i]) : zeroItem(e->type, i));
    return s + (e->args.empty() ? "0}" : "}");
  }
  case Expr::Literal:
    return literalText(e).s;
  case Expr::Unary:
    return unaryText(e->text, {initializer(e->args[0]), e->args[0]->kind == Expr::Literal ? Primary : Sequence}).s;
  case Expr::Binary:
    return "(" + initializer(e->args[0]) + " " + e->text + " " + initializer(e->args[1]) + ")";
  case Expr::Cast:
    return "(" + declaration(e->type, "") + ")" +
           operand({initializer(e->args[0]), e->args[0]->kind == Expr::Literal ? Primary : Sequence}, Prefix);
  case Expr::Conditional:
    return "(" + initializer(e->args[0]) + " ? " + initializer(e->args[1]) + " : " + initializer(e->args[2]) + ")";
  case Expr::MathCall: {
    std::string args;
    for (size_t i = 0; i < e->args.size(); ++i) args += (i ? ", " : "") + initializer(e->args[i]);
    return mathText(e->text, args).s;
  }
  case Expr::Ref:
    return e->var->name;
  case Expr::Index:
    return initializer(e->args[0]) + "[" + initializer(e->args[1]) + "]";
  case Expr::Decay:
    return initializer(e->args[0]);
  case Expr::AddressOf:
    return "&" + initializer(e->args[0]);
  case Expr::Member:
    return initializer(e->args[0]) + "." + e->text;
  default:
    std::abort(); // Subset lets no other kind into a constant
  }
}

long elements(const Type *type) {
  if (type->kind == Type::Array) return type->count * elements(type->element);
  if (type->kind != Type::Struct) return 1;
  long n = 0;
  for (const Field &field : type->record->fields) n += elements(field.type);
  return n;
}

bool variableLength(const Type *type) { return type->kind == Type::Array && (type->length || variableLength(type->element)); }

bool holdsNumbers(const Type *type) {
  while (type->kind == Type::Array) type = type->element;
  return type->kind != Type::Pointer;
}

long fieldOffset(const Record *record, const std::string &name) {
  long n = 0;
  for (const Field &field : record->fields) {
    if (field.name == name) break;
    n += elements(field.type);
  }
  return n;
}

bool allNumbers(const Type *type) {
  if (type->kind == Type::Array) return allNumbers(type->element);
  if (type->kind != Type::Struct) return type->kind == Type::Real || type->kind == Type::Integer;
  return std::all_of(type->record->fields.begin(), type->record->fields.end(), [](const Field &f) { return allNumbers(f.type); });
}

std::string commentText(std::string text) {
  text = text.substr(0, std::min(text.find("/*"), text.find("//"))); // the source's own comment
  size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r\\");
  text = first == std::string::npos || last == std::string::npos ? "" : text.substr(first, last - first + 1);
  for (size_t at; (at = text.find("*/")) != std::string::npos;) text.replace(at, 2, "* /");
  for (char &ch : text)
    if (ch == '\t') ch = ' ';
  return text;
}

} // namespace tlgen
