// Expressions of the calls emitter: C text of values, addresses of jets, and jets computed into a place.
//
// A destination is written by the last operation of an expression only, so it may be one of the operands.
#include "EmitFunction.h"
#include "MathFunctions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tlgen {

static bool isNumber(const std::string &s) {
  return !s.empty() && s.size() < 10 && s.find_first_not_of("0123456789") == std::string::npos;
}

std::string Address::offset() const {
  std::string sum;
  bool several = terms.size() > 1;
  long constant = 0;
  for (const auto &t : terms) {
    bool one = t.second.s == "1";
    if (isNumber(t.first.s) && (isNumber(t.second.s) || t.first.s == "0")) {
      constant += t.first.s == "0" ? 0 : std::stol(t.first.s) * std::stol(t.second.s);
      continue;
    }
    std::string text = operand(t.first, several && one ? Sum : Product) + (one ? "" : "*" + operand(t.second, Prefix));
    sum += (sum.empty() ? "" : " + ") + text;
  }
  if (sum.empty()) return constant == 0 ? "" : constant == 1 ? "nc" : std::to_string(constant) + "*nc";
  if (constant) sum += " + " + std::to_string(constant);
  return (sum.find(' ') != std::string::npos ? "(" + sum + ")" : sum) + "*nc";
}

std::string Address::pointer() const { return terms.empty() || offset().empty() ? base : base + " + " + offset(); }

std::string Address::value() const {
  std::string pointer = base.find(' ') == std::string::npos ? base : "(" + base + ")";
  return pointer + "[" + (offset().empty() ? "0" : offset()) + "]";
}

bool FunctionEmitter::activeObject(const Expr *e) const {
  if (e->type->kind != Type::Real && e->type->kind != Type::Struct) return false;
  Place *p = v_.place(e);
  return p && p->active;
}

// An active number or struct that stands in storage of its own.
bool FunctionEmitter::isObject(const Expr *e) const {
  bool named = e->kind == Expr::Ref || e->kind == Expr::Index || e->kind == Expr::Deref || e->kind == Expr::Member;
  return named && (activeObject(e) || (e->kind == Expr::Member && v_.varied(e)));
}

// An integer in a struct of jets, where it is the value of a jet.
bool FunctionEmitter::activeInteger(const Expr *e) const {
  if (e->type->kind != Type::Integer) return false;
  if (e->kind == Expr::Member) return e->arrow ? v_.pointsToActive(e->args[0]) : v_.varied(e->args[0]);
  Place *p = e->kind == Expr::Index || e->kind == Expr::Deref ? v_.place(e) : nullptr;
  return p && p->active;
}

bool FunctionEmitter::activePointer(const Expr *e) const { return e->type->kind == Type::Pointer && v_.pointsToActive(e); }

// True where evaluating the expression twice would differ from once.
bool FunctionEmitter::hasEffect(const Expr *e) {
  if (e->kind == Expr::Assign || e->kind == Expr::Step || e->kind == Expr::Call) return true;
  return std::any_of(e->args.begin(), e->args.end(), [](const Expr *arg) { return arg && hasEffect(arg); });
}

// True where the value of e needs jets to be computed first, in statements of their own.
bool FunctionEmitter::needsStatements(const Expr *e) const {
  if ((e->kind == Expr::Assign || e->kind == Expr::Step) && (activeObject(e->args[0]) || activeInteger(e->args[0]))) return true;
  if (e->kind == Expr::Call && v_.callees.at(e)->active()) {
    if (find(v_.callees.at(e)->result)->active) return true;
    for (size_t i = 0; i < e->args.size(); ++i)
      if (e->args[i]->type->kind != Type::Pointer && v_.callees.at(e)->activeParam(i)) return true;
  }
  if (e->kind == Expr::InitList && v_.varied(e)) return true;
  return std::any_of(e->args.begin(), e->args.end(), [&](const Expr *arg) { return arg && needsStatements(arg); });
}

// ---- addresses and pointers

// How many jets an object takes: a number, or for an array of variable length a product.
Text FunctionEmitter::jetCount(const Type *type) {
  if (!variableLength(type)) return {std::to_string(elements(type)), Primary};
  Text length = type->length ? value(type->length) : Text{std::to_string(type->count), Primary};
  Text inner = jetCount(type->element);
  return inner.s == "1" ? length : binaryText("*", length, inner);
}

void FunctionEmitter::offset(Address &a, long jets) { a.terms.push_back({{std::to_string(jets), Primary}, {"1", Primary}}); }

void FunctionEmitter::term(Address &a, const Expr *index, const Type *element) {
  Text t = value(index);
  bool isUnsigned = index->type->name.compare(0, 8, "unsigned") == 0 && index->kind != Expr::Literal;
  if (isUnsigned) t = {"(ptrdiff_t)" + operand(t, Prefix), Prefix};
  if (index->kind == Expr::Literal)
    t.s.erase(std::find_if(t.s.begin(), t.s.end(), [](char ch) { return ch == 'u' || ch == 'l'; }), t.s.end());
  a.terms.push_back({t, jetCount(element)});
}

Address FunctionEmitter::place(const Expr *e) {
  switch (e->kind) {
  case Expr::Ref:
    return {nameOf(e->var), {}};
  case Expr::Member: {
    const Expr *base = e->args[0];
    Address a = e->arrow                                                      ? Address{operand(pointer(base), Postfix), {}}
                : base->kind == Expr::Call || base->kind == Expr::Conditional ? Address{jet(base), {}}
                                                                              : place(base);
    const Type *record = e->arrow ? base->type->element : base->type;
    offset(a, fieldOffset(record->record, e->text));
    return a;
  }
  case Expr::Index: {
    Address a = e->args[0]->kind == Expr::Decay ? place(e->args[0]->args[0]) : Address{operand(pointer(e->args[0]), Postfix), {}};
    term(a, e->args[1], e->type);
    return a;
  }
  case Expr::Deref: {
    if (e->args[0]->kind == Expr::AddressOf || e->args[0]->kind == Expr::Decay) return place(e->args[0]->args[0]);
    return {operand(pointer(e->args[0]), Postfix), {}};
  }
  case Expr::Assign:
    return {operand(assign(e), Postfix), {}}; // done before, as a statement
  case Expr::Step:
    return {operand(step(e), Postfix), {}};
  case Expr::InitList: {
    std::string literal = fresh("literal");
    line("tl_real *const " + literal + " = " + slot(slots_) + ";");
    slots_ += elements(e->type);
    initObject(literal, e->type, e);
    return {literal, {}};
  }
  default:
    std::abort(); // no other expression is an active object
  }
}

std::string FunctionEmitter::address(const Expr *e) { return place(e).pointer(); }

// An address that may be written down more than once: what has an effect stands in a variable.
Text FunctionEmitter::fixedAddress(const Expr *lvalue) {
  Address a = place(lvalue);
  bool again = lvalue->kind == Expr::Assign || lvalue->kind == Expr::Step; // fixed already
  if (again || !hasEffect(lvalue)) return {a.pointer(), a.offset().empty() ? Postfix : Sum};
  std::string fixed = fresh("place");
  line(std::string(lvalue->type->isConst ? "const " : "") + "tl_real *const " + fixed + " = " + a.pointer() + ";");
  return {fixed, Primary};
}

// True for a cast after which what a pointer points to may be written.
static bool dropsConst(const Expr *cast) {
  const Type *from = cast->args[0]->type->element, *to = cast->type->element;
  while (from->kind == Type::Array) from = from->element;
  while (to->kind == Type::Array) to = to->element;
  return from->isConst && !to->isConst;
}

// A pointer to active numbers.
Text FunctionEmitter::pointer(const Expr *e) {
  auto sum = [](const Address &a) { return Text{a.pointer(), a.offset().empty() ? Postfix : Sum}; };
  if (!holdsNumbers(e->type->element)) return pointerValue(e);
  const Type *element = e->type->element;
  Address one{"", {{{"1", Primary}, jetCount(element)}}};
  std::string jets = one.offset();
  switch (e->kind) {
  case Expr::Literal:
    return {e->text, Primary}; // NULL
  case Expr::Ref:
    return {nameOf(e->var), Primary};
  case Expr::Index: {
    const std::string index = value(e->args[1]).s;
    return {operand(pointer(e->args[0]), Postfix) + "[" + index + "]", Postfix};
  }
  case Expr::Deref:
    return unaryText("*", pointer(e->args[0]));
  case Expr::Decay:
  case Expr::AddressOf:
    return sum(place(e->args[0]));
  case Expr::Cast:
    if (e->args[0]->type->kind == Type::Pointer && dropsConst(e)) return {"(tl_real *)" + operand(pointer(e->args[0]), Prefix), Prefix};
    return pointer(e->args[0]);
  case Expr::Binary: {
    bool first = e->args[0]->type->kind == Type::Pointer;
    Address offset{"", {}};
    term(offset, e->args[first ? 1 : 0], element);
    std::string o = offset.offset();
    if (o.empty()) return pointer(e->args[first ? 0 : 1]);
    return {operand(pointer(e->args[first ? 0 : 1]), Sum) + " " + e->text + " " + o, Sum};
  }
  case Expr::Step: {
    std::string move = pointer(e->args[0]).s + (e->text == "++" ? " += " : " -= ") + jets;
    if (e->prefix) return {move, Assignment};
    return {"(" + move + (e->text == "++" ? ") - " : ") + ") + jets, Sum};
  }
  case Expr::Assign: {
    if (e->text == "=") {
      const Text right = pointer(e->args[1]);
      return {pointer(e->args[0]).s + " = " + operand(right, Assignment), Assignment};
    }
    Address offset{"", {}};
    term(offset, e->args[1], element);
    return {pointer(e->args[0]).s + " " + e->text + " " + (offset.offset().empty() ? "0" : offset.offset()), Assignment};
  }
  case Expr::Conditional:
    return conditionalValue(e);
  case Expr::InitList:
    return {"(" + jetDeclaration(e->type, "") + "){" + (e->args.empty() ? "NULL" : pointer(e->args[0]).s) + "}", Primary};
  case Expr::Comma:
    if (needsStatements(e)) return evaluate(e->args[0]), pointer(e->args[1]);
    return {operand(value(e->args[0]), Assignment) + ", " + operand(pointer(e->args[1]), Assignment), Sequence};
  default:
    std::abort(); // no other expression points to active numbers
  }
}

// A pointer to pointers to active numbers: plain C, whatever it is made of.
Text FunctionEmitter::pointerValue(const Expr *e) {
  switch (e->kind) {
  case Expr::Ref:
    return {nameOf(e->var), Primary};
  case Expr::Decay:
    return pointerValue(e->args[0]);
  case Expr::AddressOf:
    return unaryText("&", pointer(e->args[0]));
  case Expr::Index: {
    const std::string index = value(e->args[1]).s;
    return {operand(pointerValue(e->args[0]), Postfix) + "[" + index + "]", Postfix};
  }
  case Expr::Deref:
    return unaryText("*", pointerValue(e->args[0]));
  case Expr::Cast:
    return pointerValue(e->args[0]);
  case Expr::Literal:
    return {e->text, Primary}; // NULL
  case Expr::InitList:
    return {"(" + jetDeclaration(e->type, "") + ")" + pointerList(e), Primary};
  case Expr::Binary: {
    bool first = e->args[0]->type->kind == Type::Pointer;
    const Text right = first ? value(e->args[1]) : pointerValue(e->args[1]);
    return binaryText(e->text, first ? pointerValue(e->args[0]) : value(e->args[0]), right);
  }
  case Expr::Step:
    return e->prefix ? unaryText(e->text, pointerValue(e->args[0]))
                     : Text{operand(pointerValue(e->args[0]), Postfix) + e->text, Postfix};
  case Expr::Assign: {
    const Text right = e->text == "=" ? pointerValue(e->args[1]) : value(e->args[1]);
    return binaryText(e->text, pointerValue(e->args[0]), right);
  }
  case Expr::Conditional:
    return {operand(value(e->args[0]), Or) + " ? " + operand(pointerValue(e->args[1]), Choice) + " : " +
                operand(pointerValue(e->args[2]), Choice),
            Choice};
  default:
    std::abort(); // no other expression has such a type
  }
}

// ---- values

// What makes a decimal literal one of that type; null where only a cast does.
static const char *integerSuffix(const std::string &type) {
  static const std::pair<const char *, const char *> table[] = {
      {"int", ""}, {"unsigned int", "u"}, {"long", "l"}, {"unsigned long", "ul"}, {"long long", "ll"}, {"unsigned long long", "ull"}};
  for (const auto &entry : table)
    if (type == entry.first) return entry.second;
  return nullptr;
}

Text FunctionEmitter::value(const Expr *e) {
  if (activePointer(e)) return pointer(e);
  if (e->kind == Expr::Step && !e->prefix && activeObject(e)) { // the old value
    std::string x = fixedAddress(e->args[0]).s, old = fresh("old");
    line("const tl_real " + old + " = *" + (x.find(' ') == std::string::npos ? x : "(" + x + ")") + ";");
    stepAt(x, e);
    return {old, Primary};
  }
  if (isObject(e) || ((e->kind == Expr::Assign || e->kind == Expr::Step) && activeObject(e)))
    return isSingle(e->type) ? Text{"(float)" + place(e).value(), Prefix} : Text{place(e).value(), Postfix};
  if (activeInteger(e)) return integerAt(e->type, place(e).value());
  if ((e->kind == Expr::Assign || e->kind == Expr::Step) && activeInteger(e->args[0])) return changeInteger(e);
  switch (e->kind) {
  case Expr::Literal:
    return literalText(e);
  case Expr::Ref:
    return {nameOf(e->var), Primary};
  case Expr::Index: {
    const std::string index = value(e->args[1]).s;
    return {operand(value(e->args[0]), Postfix) + "[" + index + "]", Postfix};
  }
  case Expr::Member:
    return {operand(value(e->args[0]), Postfix) + (e->arrow ? "->" : ".") + e->text, Postfix};
  case Expr::Deref:
    return unaryText("*", value(e->args[0]));
  case Expr::AddressOf:
    return unaryText("&", value(e->args[0]));
  case Expr::Decay:
    return value(e->args[0]);
  case Expr::Unary:
    if (e->text == "!" && e->args[0]->type->kind == Type::Real) return {operand(value(e->args[0]), Shift) + " == 0", Equality};
    return unaryText(e->text, value(e->args[0]));
  case Expr::Binary: {
    if (e->text == "&&" || e->text == "||") return logicalValue(e);
    bool difference = e->text == "-" && activePointer(e->args[0]) && activePointer(e->args[1]);
    const Text right = value(e->args[1]);
    if (!difference) return binaryText(e->text, value(e->args[0]), right);
    std::string distance = "(" + pointer(e->args[0]).s + " - " + operand(right, Product) + ")";
    if (!holdsNumbers(e->args[0]->type->element)) return {distance, Primary};
    Address one{"", {{{"1", Primary}, jetCount(e->args[0]->type->element)}}};
    return {distance + "/" + (one.offset() == "nc" ? "nc" : "(" + one.offset() + ")"), Product};
  }
  case Expr::Conditional:
    return conditionalValue(e);
  case Expr::Call:
    return callValue(e);
  case Expr::MathCall: {
    std::string list;
    std::vector<Text> args;
    for (const Expr *arg : e->args) {
      args.push_back(value(arg));
      list += (list.empty() ? "" : ", ") + operand(args.back(), Assignment);
    }
    if (e->text == "abs" || e->text == "labs" || e->text == "llabs") emitted_.absolutes.insert(e->text);
    return e->rule ? externalText(e->text, args) : mathText(e->text, list);
  }
  case Expr::Cast: {
    const Expr *inner = e->args[0];
    bool plainInteger = inner->kind == Expr::Literal && inner->type->kind == Type::Integer &&
                        inner->text.find_first_not_of("0123456789") == std::string::npos;
    if (plainInteger && e->type->kind == Type::Real)
      return {isSingle(e->type) ? inner->text + ".0f" : realConstant(inner->text + ".0"), Primary};
    if (plainInteger && e->type->kind == Type::Integer && integerSuffix(e->type->name))
      return {inner->text + integerSuffix(e->type->name), Primary};
    if (e->type->kind == Type::Pointer && inner->type->kind == Type::Pointer && !dropsConst(e)) return value(inner);
    return {"(" + tlgen::declaration(e->type, "") + ")" + operand(value(inner), Prefix), Prefix};
  }
  case Expr::Assign: {
    const Text right = value(e->args[1]);
    return binaryText(e->text, value(e->args[0]), right);
  }
  case Expr::Step:
    return e->prefix ? unaryText(e->text, value(e->args[0])) : Text{operand(value(e->args[0]), Postfix) + e->text, Postfix};
  case Expr::Comma:
    if (!needsStatements(e)) return binaryText(",", value(e->args[0]), value(e->args[1]));
    evaluate(e->args[0]);
    return value(e->args[1]);
  case Expr::InitList: {
    std::string items;
    for (size_t i = 0; i < e->args.size(); ++i)
      items += (i ? ", " : "") + (e->args[i] ? operand(value(e->args[i]), Assignment) : zeroItem(e->type, i));
    std::string type = e->text == "compound" ? "(" + tlgen::declaration(e->type, "") + ")" : "";
    return {type + "{" + (items.empty() ? "0" : items) + "}", Primary};
  }
  }
  std::abort();
}

// The integer that stands at a place in a jet.
Text FunctionEmitter::integerAt(const Type *type, const std::string &place) {
  Type plain = *type;
  plain.isConst = false;
  return {"(" + tlgen::declaration(&plain, "") + ")" +
              (type->name == "unsigned long" || type->name == "unsigned long long" ? "(long long)" : "") + place,
          Prefix};
}

// n = x, n += x, n++ for such an integer; what its value is then.
Text FunctionEmitter::changeInteger(const Expr *e) {
  quote(e->loc);
  const Expr *lhs = e->args[0];
  std::string x = fixedAddress(lhs).s, kept;
  Text now = integerAt(lhs->type, "*" + (x.find(' ') == std::string::npos ? x : "(" + x + ")"));
  Text next = now;
  if (e->kind == Expr::Step && !e->prefix) {
    kept = fresh("old");
    Type plain = *lhs->type;
    plain.isConst = false;
    line("const " + tlgen::declaration(&plain, kept) + " = " + now.s + ";");
  }
  if (e->kind == Expr::Step)
    next = binaryText(e->text == "++" ? "+" : "-", now, {"1", Primary});
  else if (e->text == "=")
    next = value(e->args[1]);
  else
    next = binaryText(e->text.substr(0, e->text.size() - 1), now, value(e->args[1]));
  if (e->text != "=") next = integerAt(lhs->type, operand(next, Prefix));
  constants(x, lhs->type, next);
  return kept.empty() ? now : Text{kept, Primary};
}

// A condition as 0 or 1; a comparison is that already.
static std::string truth(const Text &t) {
  bool already = t.precedence == Relation || t.precedence == Equality || t.precedence == And || t.precedence == Or || t.s[0] == '!';
  return already ? t.s : operand(t, Shift) + " != 0";
}

// A value where C asks for zero or not: compilers warn of a floating-point number there, and of an integer that was computed.
Text FunctionEmitter::condition(const Expr *e) {
  Text t = value(e);
  bool computed = e->type->kind == Type::Integer && (t.precedence == Product || t.precedence == Shift || t.precedence == Choice);
  return e->type->kind == Type::Real || (computed && truth(t) != t.s) ? Text{operand(t, Shift) + " != 0", Equality} : t;
}

// a && b and a || b evaluate b only where they must, also where b needs statements.
Text FunctionEmitter::logicalValue(const Expr *e) {
  if (!needsStatements(e->args[1])) return binaryText(e->text, condition(e->args[0]), condition(e->args[1]));
  std::string test = fresh("test");
  line("int " + test + " = " + truth(condition(e->args[0])) + ";");
  line("if (" + std::string(e->text == "&&" ? "" : "!") + test + ") {");
  ++indent_;
  line(test + " = " + truth(condition(e->args[1])) + ";");
  --indent_;
  line("}");
  return {test, Primary};
}

Text FunctionEmitter::conditionalValue(const Expr *e) {
  if (!needsStatements(e->args[1]) && !needsStatements(e->args[2]))
    return {operand(condition(e->args[0]), Or) + " ? " + operand(value(e->args[1]), Choice) + " : " +
                operand(value(e->args[2]), Choice),
            Choice};
  std::string choice = fresh("choice");
  Type plain = *e->type;
  plain.isConst = false;
  line((activePointer(e) ? jetDeclaration(&plain, choice) : tlgen::declaration(&plain, choice)) + ";");
  line("if (" + condition(e->args[0]).s + ") {");
  ++indent_;
  line(choice + " = " + operand(value(e->args[1]), Assignment) + ";");
  --indent_;
  line("} else {");
  ++indent_;
  line(choice + " = " + operand(value(e->args[2]), Assignment) + ";");
  --indent_;
  line("}");
  return {choice, Primary};
}

Text FunctionEmitter::callValue(const Expr *e) {
  if (!find(v_.callees.at(e)->result)->active) return {callText(e, ""), Postfix};
  return {jet(e) + "[0]", Postfix};
}

std::string FunctionEmitter::callText(const Expr *e, const std::string &dest) {
  const Variant *callee = v_.callees.at(e);
  frame_.calls.push_back({e, callee});
  lineLost_ |= callee->active();
  std::string args = callee->active() ? "cx" : "";
  auto add = [&](const std::string &a) { args += (args.empty() ? "" : ", ") + a; };
  if (!dest.empty()) add(dest);
  for (size_t i = 0; i < e->args.size(); ++i) {
    bool number = e->args[i]->type->kind != Type::Pointer && callee->activeParam(i);
    add(number ? jet(e->args[i]) : operand(value(e->args[i]), Assignment));
  }
  return emitted_.names.at(callee) + "(" + args + ")";
}

// ---- jets

// The address of a jet with the value of e: an object itself, or a temporary.
std::string FunctionEmitter::jet(const Expr *e) {
  if (e->kind == Expr::Cast && !narrows(e)) return jet(e->args[0]);
  if (e->kind == Expr::Unary && e->text == "+") return jet(e->args[0]);
  if (isObject(e)) return address(e);
  std::string dest = temporary(e->type);
  into(dest, e);
  return dest;
}

void FunctionEmitter::into(const std::string &dest, const Expr *e) {
  if (!isJet(e)) {
    Text text = value(e);
    if (e->type->kind == Type::Struct && hasEffect(e)) { // its members are read one by one
      std::string copy = fresh("copy");
      line("const " + tlgen::declaration(e->type, copy) + " = " + operand(text, Assignment) + ";");
      text = {copy, Primary};
    }
    return constants(dest, e->type, text);
  }
  switch (e->kind) {
  case Expr::Cast:
    into(dest, e->args[0]);
    return narrows(e) ? round(dest) : void();
  case Expr::Unary:
    if (e->text == "-") return operation("neg", dest + ", " + jet(e->args[0]));
    return into(dest, e->args[0]);
  case Expr::Binary:
  case Expr::MathCall:
    e->kind == Expr::Binary ? binaryInto(dest, e) : mathInto(dest, e);
    return isSingle(e->type) ? round(dest) : void();
  case Expr::Call:
    return line(callText(e, dest) + ";");
  case Expr::Comma:
    evaluate(e->args[0]);
    return into(dest, e->args[1]);
  case Expr::Conditional:
    line("if (" + condition(e->args[0]).s + ") {");
    ++indent_;
    into(dest, e->args[1]);
    --indent_;
    line("} else {");
    ++indent_;
    into(dest, e->args[2]);
    --indent_;
    return line("}");
  case Expr::Step:
    if (!e->prefix) { // the old value
      std::string x = fixedAddress(e->args[0]).s;
      operation("copy", dest + ", " + x);
      return stepAt(x, e);
    }
    return operation("copy", dest + ", " + address(e));
  case Expr::InitList: { // the destination may stand in the list
    std::string list = temporary(e->type);
    initObject(list, e->type, e);
    return copyObject(dest, list, e->type);
  }
  default:
    return copyObject(dest, fixedAddress(e).s, e->type);
  }
}

// Single precision is double precision, rounded to float after each operation.
void FunctionEmitter::round(const std::string &x) { operation("float", x + ", " + x); }

bool FunctionEmitter::narrows(const Expr *cast) const { return isSingle(cast->type) && !isSingle(cast->args[0]->type); }

void FunctionEmitter::binaryInto(const std::string &dest, const Expr *e) {
  const Expr *a = e->args[0], *b = e->args[1];
  char op = e->text[0];
  if (isJet(a) && isJet(b)) {
    std::string x = jet(a), y = jet(b);
    const char *name = op == '+' ? "add" : op == '-' ? "sub" : op == '*' ? "mul" : "div";
    return operation(name, dest + ", " + x + ", " + y);
  }
  const Expr *active = isJet(a) ? a : b, *passive = isJet(a) ? b : a;
  std::string x = jet(active);
  Text k = value(passive);
  std::string factor = operand(k, Assignment);
  if (op == '+') return operation("shift", dest + ", " + x + ", " + factor);
  if (op == '*') return operation("scale", dest + ", " + x + ", " + factor);
  if (op == '-')
    return active == a ? operation("shift", dest + ", " + x + ", " + unaryText("-", k).s)
                       : operation("rsub", dest + ", " + factor + ", " + x);
  return active == a ? operation("divc", dest + ", " + x + ", " + factor) : operation("rdiv", dest + ", " + factor + ", " + x);
}

// The integer that a literal exponent is, such as 2, 2.0 or -3.
static bool integerExponent(const Expr *e, long &n) {
  if (e->kind == Expr::Cast) return integerExponent(e->args[0], n);
  if (e->kind == Expr::Unary && e->text == "-" && integerExponent(e->args[0], n)) return n = -n, true;
  if (e->kind != Expr::Literal) return false;
  double x = std::strtod(e->text.c_str(), nullptr);
  if (std::floor(x) != x || std::fabs(x) > 1000) return false;
  return n = static_cast<long>(x), true;
}

void FunctionEmitter::mathInto(const std::string &dest, const Expr *e) {
  const std::string name = e->rule ? "" : findMath(e->text)->operation;
  if (name == "pow" && !isJet(e->args[1])) {
    long n = 0;
    std::string x = jet(e->args[0]);
    if (integerExponent(e->args[1], n)) return operation("powi", dest + ", " + x + ", " + std::to_string(n));
    return operation("powc", dest + ", " + x + ", " + operand(value(e->args[1]), Assignment));
  }
  if (name == "pow" && !isJet(e->args[0])) {
    std::string y = jet(e->args[1]);
    return operation("rpow", dest + ", " + operand(value(e->args[0]), Assignment) + ", " + y);
  }
  if (e->rule) return ruleInto(dest, e);
  std::string args;
  for (const Expr *arg : e->args) args += ", " + (arg->type->kind == Type::Real ? jet(arg) : operand(value(arg), Assignment));
  operation(name, dest + args);
}

// An external function by its Taylor coefficients.
void FunctionEmitter::ruleInto(const std::string &dest, const Expr *e) {
  if (e->args.size() == 1) return operation("apply", dest + ", " + jet(e->args[0]) + ", " + e->rule->taylor + ", NULL");
  std::string args, list = fresh("args");
  for (const Expr *arg : e->args) args += (args.empty() ? "" : ", ") + jet(arg);
  line("const tl_real *const " + list + "[] = {" + args + "};");
  operation("apply_n", dest + ", " + std::to_string(e->args.size()) + ", " + list + ", " + e->rule->taylor + ", NULL");
}

} // namespace tlgen
