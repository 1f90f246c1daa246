// Statements of the calls emitter: declarations, assignments, branches and loops.
#include "EmitFunction.h"

#include <algorithm>

namespace tlgen {

void FunctionEmitter::statements(const std::vector<Stmt *> &list) {
  for (size_t i = 0; i < list.size(); ++i) {
    if (i + 1 < list.size() && sincosPair(list[i], list[i + 1]))
      ++i;
    else
      statement(list[i]);
  }
}

// The statements of a block, or the one statement, a level deeper.
void FunctionEmitter::body(const Stmt *s) {
  ++indent_;
  quoted_ = {};
  bool marks = s && std::any_of(s->body.begin(), s->body.end(), [&](const Stmt *part) {
                 return part->kind == Stmt::Declare && v_.active(part->var) && variableLength(part->var->type);
               });
  std::string mark = marks ? fresh("mark") : "";
  if (marks) line("tl_real *const " + mark + " = cx->top;");
  scopes_.push_back({Scope::Plain, mark});
  if (s && s->kind == Stmt::Block)
    statements(s->body);
  else if (s)
    statement(s);
  scopes_.pop_back();
  if (marks) line("cx->top = " + mark + ";");
  --indent_;
  quoted_ = {};
}

// Before a break or continue: gives back the arrays of variable length of the blocks that it leaves.
void FunctionEmitter::leave(bool loopOnly) {
  std::string outermost;
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    if (!scope->mark.empty()) outermost = scope->mark;
    if (scope->kind == Scope::Loop || (scope->kind == Scope::Switch && !loopOnly)) break;
  }
  if (!outermost.empty()) line("cx->top = " + outermost + ";");
}

std::string FunctionEmitter::nameOf(const Stmt *label) { return label->label + "_label"; }

void FunctionEmitter::choose(const Stmt *s) {
  Text selector = value(s->expr);
  bool truth =
      selector.precedence == Relation || selector.precedence == Equality || selector.precedence == And || selector.precedence == Or;
  line("switch (" + (truth ? "(int)" + operand(selector, Prefix) : selector.s) + ") {");
  scopes_.push_back({Scope::Switch, ""});
  const Stmt *before = nullptr;
  for (const Stmt *part : s->then->body) {
    bool reached = before || part->kind == Stmt::Case || part->kind == Stmt::Declare;
    if (!reached) continue; // no case leads there
    if (part->kind == Stmt::Case) {
      choice(part, before);
    } else {
      ++indent_;
      statement(part);
      --indent_;
    }
    before = part;
  }
  scopes_.pop_back();
  line("}");
  quoted_ = {};
}

// A case; where the statement before it runs on into it, compilers want to be told that this is meant.
void FunctionEmitter::choice(const Stmt *s, const Stmt *before) {
  const Stmt *last = before;
  while (last && last->kind == Stmt::Block && !last->body.empty()) last = last->body.back();
  bool ends = !last || last->kind == Stmt::Case || last->kind == Stmt::Break || last->kind == Stmt::Return ||
              last->kind == Stmt::Goto || last->kind == Stmt::Continue;
  if (!ends) line("/* fall through */");
  line(s->expr ? "case " + value(s->expr).s + ":" : "default:");
  quoted_ = {};
}

void FunctionEmitter::declare(const Stmt *s) {
  const Variable *var = s->var;
  std::string name = nameOf(var);
  bool unread = !read_.count(var);
  if (var->isStatic) {
    line("static " + declaration(var->type, name) + " = " + initializer(var->init) + ";");
    return unread ? line("(void)" + name + ";") : void();
  }
  if (!v_.active(var)) {
    std::string init;
    if (s->expr && s->expr->kind == Expr::InitList)
      init = " = " + value(s->expr).s;
    else if (s->expr)
      init = " = " + operand(value(s->expr), Assignment);
    else if (var->type->kind == Type::Integer)
      init = " = 0"; // no wild index where a callee ends early for want of space
    line(passiveDeclaration(var->type, name) + init + ";");
  } else if (!holdsNumbers(var->type)) {
    std::string init;
    if (s->expr && s->expr->kind == Expr::InitList)
      init = " = " + pointerList(s->expr);
    else if (s->expr)
      init = " = " + operand(pointer(s->expr), Assignment);
    line(jetDeclaration(var->type, name) + init + ";");
  } else {
    if (s->expr) quote(s->loc);
    if (variableLength(var->type))
      variableArray(var);
    else
      placeLocal(var);
    name = nameOf(var); // settled when it was placed
    if (s->expr) initObject(name, var->type, s->expr);
  }
  if (unread) line("(void)" + name + ";");
}

std::string FunctionEmitter::passiveDeclaration(const Type *type, std::string name) {
  if (!variableLength(type)) return declaration(type, name);
  for (; type->kind == Type::Array; type = type->element)
    name += "[" + (type->length ? value(type->length).s : std::to_string(type->count)) + "]";
  return declaration(type, name);
}

std::string FunctionEmitter::pointerList(const Expr *list) {
  std::string items;
  for (const Expr *item : list->args)
    items += (items.empty() ? "" : ", ") + (!item                          ? std::string("NULL")
                                            : item->kind == Expr::InitList ? pointerList(item)
                                                                           : operand(pointer(item), Assignment));
  return "{" + items + "}";
}

// A local of fixed size gets its jets in the frame; where jumps could pass the declaration, at the top of the function.
void FunctionEmitter::placeLocal(const Variable *var) {
  std::string name = nameOf(var);
  if (!hoist_)
    line("tl_real *const " + name + " = " + slot(slots_) + ";");
  else {
    std::string unique = name;
    for (int n = 2; !hoistedNames_.insert(unique).second; ++n) unique = name + std::to_string(n);
    renamed_[var] = unique;
    hoisted_ += "  tl_real *const " + unique + " = " + slot(slots_) + ";\n";
  }
  slots_ += elements(var->type);
}

// An array of variable length takes its jets from the stack where it is declared.
void FunctionEmitter::variableArray(const Variable *var) {
  std::string name = nameOf(var);
  frame_.arrays.push_back(var);
  line("tl_real *const " + name + " = tl_push(cx, (size_t)" + operand(jetCount(var->type), Prefix) + ");");
  line("if (!" + name + ") {");
  line("  cx->top = mark;");
  line("  return" + nothing() + ";");
  line("}");
}

// The place a number of jets behind another.
static std::string at(const std::string &base, long jets) {
  return jets == 0 ? base : base + " + " + (jets == 1 ? "" : std::to_string(jets) + "*") + "nc";
}

// Number by number; what a list leaves out is zero. A null e is all zeros.
void FunctionEmitter::initObject(const std::string &base, const Type *type, const Expr *e) {
  if (e && e->kind != Expr::InitList) return into(base, e);
  auto part = [&](long offset) { return at(base, offset); };
  auto item = [&](size_t i) { return e && i < e->args.size() ? e->args[i] : nullptr; };
  if (type->kind == Type::Array)
    for (long i = 0; i < type->count; ++i) initObject(part(i * elements(type->element)), type->element, item(static_cast<size_t>(i)));
  else if (type->kind == Type::Struct)
    for (size_t i = 0; i < type->record->fields.size(); ++i) {
      const Field &field = type->record->fields[i];
      initObject(part(fieldOffset(type->record, field.name)), field.type, item(i));
    }
  else if (item(0))
    into(base, item(0)); // a number in braces
  else
    operation("const", base + ", 0");
}

// A passive object into jets: text names it in C.
void FunctionEmitter::constants(const std::string &base, const Type *type, const Text &text) {
  auto part = [&](long offset) { return at(base, offset); };
  if (type->kind == Type::Array)
    for (long i = 0; i < type->count; ++i)
      constants(part(i * elements(type->element)), type->element, {operand(text, Postfix) + "[" + std::to_string(i) + "]", Postfix});
  else if (type->kind == Type::Struct)
    for (const Field &field : type->record->fields)
      constants(part(fieldOffset(type->record, field.name)), field.type, {operand(text, Postfix) + "." + field.name, Postfix});
  else if (type->kind == Type::Integer)
    operation("integer", base + ", " + (type->name == "int" ? operand(text, Assignment) : "(long long)" + operand(text, Prefix)));
  else
    operation("const", base + ", " + operand(text, Assignment));
}

void FunctionEmitter::copyObject(const std::string &dest, const std::string &source, const Type *type) {
  if (type->kind == Type::Real) return operation("copy", dest + ", " + source);
  operation("move", dest + ", " + source + ", " + std::to_string(elements(type))); // C may copy what has no value yet
}

void FunctionEmitter::evaluate(const Expr *e) {
  if (e->kind == Expr::Cast && e->type->kind == Type::Void) e = e->args[0]; // (void)x
  if (e->kind == Expr::Comma) {
    evaluate(e->args[0]);
    return evaluate(e->args[1]);
  }
  if (e->kind == Expr::Assign && activeObject(e->args[0])) {
    assign(e);
    return;
  }
  if (e->kind == Expr::Step && activeObject(e->args[0])) {
    step(e);
    return;
  }
  if ((e->kind == Expr::Assign || e->kind == Expr::Step) && activeInteger(e->args[0])) {
    Expr prefix = *e; // nobody takes the value
    prefix.prefix = true;
    changeInteger(&prefix);
    return;
  }
  if (e->kind == Expr::Call && v_.callees.at(e)->active()) {
    quote(e->loc);
    return line(callText(e, find(v_.callees.at(e)->result)->active ? temporary(e->type) : "") + ";");
  }
  line(effect(e) + ";");
}

// An expression whose value nobody takes.
std::string FunctionEmitter::effect(const Expr *e) {
  if (e->kind == Expr::Step && activePointer(e->args[0])) { // the value of p++ would be p - 1
    Expr prefix = *e;
    prefix.prefix = true;
    return pointer(&prefix).s;
  }
  bool effect = e->kind == Expr::Assign || e->kind == Expr::Step || e->kind == Expr::Call;
  return (effect ? "" : "(void)") + operand(value(e), effect ? Assignment : Prefix);
}

// x++ and the like; the address of x.
Text FunctionEmitter::step(const Expr *e) {
  quote(e->loc);
  Text x = fixedAddress(e->args[0]);
  stepAt(x.s, e);
  return x;
}

void FunctionEmitter::stepAt(const std::string &x, const Expr *e) {
  operation("shift", x + ", " + x + ", " + (e->text == "++" ? "1" : "-1"));
  if (isSingle(e->type)) round(x);
}

// lhs op= rhs; the address of lhs.
Text FunctionEmitter::assign(const Expr *e) {
  quote(e->loc);
  Text at = fixedAddress(e->args[0]);
  if (e->wholesale && isObject(e->args[1]))
    return operation("move", at.s + ", " + fixedAddress(e->args[1]).s + ", " + std::to_string(elements(e->type))), at;
  if (e->text == "=") return into(at.s, e->args[1]), at;
  update(at.s, e);
  if (isSingle(e->args[0]->type)) round(at.s);
  return at;
}

void FunctionEmitter::update(const std::string &x, const Expr *e) {
  const Expr *lhs = e->args[0], *rhs = e->args[1];
  std::string op = e->text.substr(0, 1);
  if (!isJet(rhs)) {
    Text k = value(rhs);
    const char *name = op == "+" || op == "-" ? "shift" : op == "*" ? "scale" : "divc";
    return operation(name, x + ", " + x + ", " + (op == "-" ? unaryText("-", k).s : operand(k, Assignment)));
  }
  bool scaledTerm = rhs->kind == Expr::Binary && rhs->text == "*" && isJet(rhs->args[0]) != isJet(rhs->args[1]) && !isSingle(rhs->type);
  if (scaledTerm && (op == "+" || op == "-")) {
    const Expr *factor = rhs->args[isJet(rhs->args[0]) ? 1 : 0], *term = rhs->args[isJet(rhs->args[0]) ? 0 : 1];
    Text k = value(factor);
    std::string y = jet(term);
    return operation("axpy", x + ", " + (op == "-" ? unaryText("-", k).s : operand(k, Assignment)) + ", " + y);
  }
  if (rhs->kind == Expr::Binary && rhs->text == "*" && op == "+" && isAlone(lhs, rhs->args[0]) && isAlone(lhs, rhs->args[1]) &&
      !isSingle(rhs->type)) {
    std::string a = jet(rhs->args[0]), b = jet(rhs->args[1]);
    return operation("muladd", x + ", " + a + ", " + b);
  }
  std::string y = jet(rhs);
  const char *name = op == "+" ? "add" : op == "-" ? "sub" : op == "*" ? "mul" : "div";
  return operation(name, x + ", " + x + ", " + y);
}

// True where lhs is a local number that the factor, if it is an object itself, cannot be.
bool FunctionEmitter::isAlone(const Expr *lhs, const Expr *factor) const {
  if (lhs->kind != Expr::Ref || lhs->var->scope == Variable::Global || addressTaken_.count(lhs->var)) return false;
  while (factor->kind == Expr::Cast) factor = factor->args[0];
  return !(factor->kind == Expr::Ref && factor->var == lhs->var) && factor->kind != Expr::Assign && factor->kind != Expr::Step;
}

void FunctionEmitter::branch(const Stmt *s) {
  if (needsStatements(s->expr)) quote(s->loc);
  line("if (" + condition(s->expr).s + ") {");
  body(s->then);
  // A chain of else if stays one, where the next condition can stand there.
  for (; s->otherwise && s->otherwise->kind == Stmt::If && !needsStatements(s->otherwise->expr); s = s->otherwise) {
    line("} else if (" + condition(s->otherwise->expr).s + ") {");
    body(s->otherwise->then);
  }
  if (s->otherwise) {
    line("} else {");
    body(s->otherwise);
  }
  line("}");
}

void FunctionEmitter::loop(const Stmt *s) {
  scopes_.push_back({Scope::Loop, ""});
  emitLoop(s);
  scopes_.pop_back();
}

void FunctionEmitter::emitLoop(const Stmt *s) {
  bool activeStep = s->step && (needsStatements(s->step) || (s->step->kind == Expr::Comma));
  bool activeInit = s->init && s->init->kind == Stmt::Block &&
                    std::any_of(s->init->body.begin(), s->init->body.end(), [&](const Stmt *d) { return v_.active(d->var); });
  if (s->init && s->init->kind == Stmt::Evaluate) activeInit = needsStatements(s->init->expr) || s->init->expr->kind == Expr::Comma;
  if (activeStep || activeInit || (s->init && s->init->kind == Stmt::Block && s->init->body.size() > 1) ||
      (s->expr && needsStatements(s->expr)))
    return generalLoop(s);
  if (s->kind == Stmt::DoWhile) {
    line("do {");
    body(s->then);
    return line("} while (" + condition(s->expr).s + ");");
  }
  std::string cond = s->expr ? condition(s->expr).s : "";
  if (s->kind == Stmt::While)
    line("while (" + cond + ") {");
  else {
    std::string init;
    if (s->init && s->init->kind == Stmt::Evaluate)
      init = value(s->init->expr).s;
    else if (s->init && !s->init->body.empty()) {
      const Stmt *d = s->init->body[0];
      init = declaration(d->var->type, nameOf(d->var)) + (d->expr ? " = " + operand(value(d->expr), Assignment) : "");
    }
    line("for (" + init + "; " + cond + "; " + (s->step ? effect(s->step) : "") + ") {");
  }
  body(s->then);
  line("}");
}

// A loop whose head computes with jets: the step stands first in the body, so that continue reaches it.
void FunctionEmitter::generalLoop(const Stmt *s) {
  line("{");
  ++indent_;
  quoted_ = {};
  if (s->init && s->init->kind == Stmt::Block)
    for (const Stmt *d : s->init->body) statement(d);
  else if (s->init)
    statement(s->init);
  bool flag = s->step || s->kind == Stmt::DoWhile;
  std::string again = flag ? fresh("again") : "";
  line(flag ? "for (int " + again + " = 0;; " + again + " = 1) {" : "for (;;) {");
  ++indent_;
  quoted_ = {};
  auto test = [&] {
    if (!s->expr) return;
    temporariesUsed_ = 0;
    if (needsStatements(s->expr)) quote(s->loc);
    line("if (!" + operand(condition(s->expr), Prefix) + ") break;");
  };
  if (s->kind == Stmt::DoWhile) {
    line("if (" + again + ") {");
    ++indent_;
    test();
    --indent_;
    line("}");
  } else {
    if (s->step) {
      line("if (" + again + ") {");
      ++indent_;
      temporariesUsed_ = 0;
      evaluate(s->step);
      --indent_;
      quoted_ = {};
      line("}");
    }
    test();
  }
  --indent_;
  body(s->then);
  line("}");
  --indent_;
  line("}");
  quoted_ = {};
}

void FunctionEmitter::returns(const Stmt *s) {
  bool jetResult = find(v_.result)->active;
  if (jetResult) {
    quote(s->loc);
    into("result", s->expr);
    line("tl_pop(cx, @FRAME@);");
    return line("return;");
  }
  if (s->expr && s->expr->type->kind == Type::Void) evaluate(s->expr);
  if (!s->expr || s->expr->type->kind == Type::Void) {
    line("tl_pop(cx, @FRAME@);");
    return line("return;");
  }
  if (!v_.active()) return line("return " + value(s->expr).s + ";");
  std::string keep = fresh("keep");
  line("const " + declaration(v_.function->result, keep) + " = " + operand(value(s->expr), Assignment) + ";");
  line("tl_pop(cx, @FRAME@);");
  line("return " + keep + ";");
}

// s = sin(x); c = cos(x); as one call, where x is a plain active variable or element that neither assignment changes.
bool FunctionEmitter::sincosPair(const Stmt *first, const Stmt *second) {
  struct Half {
    const Variable *var = nullptr;
    const Expr *call = nullptr;
    bool declares = false;
  };
  auto half = [&](const Stmt *s) {
    Half h;
    if (s->kind == Stmt::Declare && s->expr && s->var->type->kind == Type::Real) h = {s->var, s->expr, true};
    if (s->kind == Stmt::Evaluate && s->expr->kind == Expr::Assign && s->expr->text == "=" && s->expr->args[0]->kind == Expr::Ref)
      h = {s->expr->args[0]->var, s->expr->args[1], false};
    bool trig = h.call && h.call->kind == Expr::MathCall && (h.call->text == "sin" || h.call->text == "cos") && v_.varied(h.call);
    return trig && v_.active(h.var) ? h : Half{};
  };
  Half a = half(first), b = half(second);
  if (!a.call || !b.call || a.call->text == b.call->text || a.var == b.var) return false;
  const Expr *x = a.call->args[0], *y = b.call->args[0];
  bool simple = (x->kind == Expr::Ref || x->kind == Expr::Index) && x->kind == y->kind && !hasEffect(x) && !hasEffect(y);
  if (!simple) return false;
  std::string place = address(x);
  if (place != address(y)) return false;
  if (x->kind == Expr::Ref && (x->var == a.var || x->var == b.var)) return false;
  if (x->kind == Expr::Index && !a.declares && addressTaken_.count(a.var)) return false; // the element may be that variable
  quote(first->loc);
  for (const Half &h : {a, b})
    if (h.declares) placeLocal(h.var);
  const Half &sine = a.call->text == "sin" ? a : b, &cosine = a.call->text == "sin" ? b : a;
  operation("sincos", nameOf(sine.var) + ", " + nameOf(cosine.var) + ", " + place);
  for (const Half &h : {a, b})
    if (h.declares && !read_.count(h.var)) line("(void)" + nameOf(h.var) + ";");
  return true;
}

} // namespace tlgen
