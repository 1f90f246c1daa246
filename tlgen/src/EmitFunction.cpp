// One function as calls on jets: signature, frame and statements. The expressions are in EmitExpression.cpp.
#include "EmitFunction.h"

#include <algorithm>

namespace tlgen {

FunctionEmitter::FunctionEmitter(const Program &program, const Variant &variant, Emitted &emitted)
    : program_(program), v_(variant), emitted_(emitted) {}

// True where the identifier stands in the text as a word.
static bool mentions(const std::string &text, const std::string &word) {
  auto inWord = [](char ch) { return isalnum(static_cast<unsigned char>(ch)) || ch == '_'; };
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    bool starts = at == 0 || !inWord(text[at - 1]), ends = at + word.size() == text.size() || !inWord(text[at + word.size()]);
    if (starts && ends) return true;
  }
  return false;
}

// All lines that give back a frame, once its size is known.
static void setFrame(std::string &text, bool marked, long frame) {
  const std::string mark = "tl_pop(cx, @FRAME@);";
  for (size_t at; (at = text.find(mark)) != std::string::npos;) {
    if (marked) {
      text.replace(at, mark.size(), "cx->top = mark;");
      continue;
    }
    if (frame) {
      text.replace(at, mark.size(), "tl_pop(cx, " + std::to_string(frame) + ");");
      continue;
    }
    size_t start = text.rfind('\n', at) + 1;
    text.erase(start, text.find('\n', at) + 1 - start);
  }
}

std::string FunctionEmitter::run() {
  survey(v_.function->body);
  for (auto it = frame_.constants.begin(); it != frame_.constants.end();) it = assigned_.count(it->first) ? frame_.constants.erase(it) : std::next(it);
  copyParameters();
  for (const Variable *param : v_.function->params)
    if (!referenced_.count(param)) line("(void)" + param->name + ";");
  statements(v_.function->body->body);
  const std::string end = "  return;\n"; // at the end of a function it goes without saying
  if (out_.size() >= end.size() && out_.compare(out_.size() - end.size(), end.size(), end) == 0) out_.erase(out_.size() - end.size());
  bool open = v_.function->body->body.empty() || v_.function->body->body.back()->kind != Stmt::Return;
  if (open && v_.active()) line("tl_pop(cx, @FRAME@);");
  long frame = slots_ + temporaries_;
  bool marked = !frame_.arrays.empty();
  setFrame(out_, marked, frame);
  frame_.fixed = frame;
  emitted_.frames[&v_] = frame_;

  std::string head = hoisted_;
  for (int i = 0; i < temporaries_; ++i) head += "  tl_real *const tmp" + std::to_string(i) + " = " + slot(slots_ + i) + ";\n";
  std::string fallback = v_.function->result->kind == Type::Void || find(v_.result)->active ? "" : " 0";
  if (frame && marked) fallback = ""; // nothing to give back yet
  if (frame) head = "  tl_real *const frame = tl_push(cx, " + std::to_string(frame) + ");\n  if (!frame) return" + fallback + ";\n" + head;
  if (marked) head = "  tl_real *const mark = cx->top;\n" + head;
  if (mentions(head + out_, "nc")) head = "  const ptrdiff_t nc = cx->shape->ncoef;\n" + head;
  if (v_.active() && !mentions(head + out_, "cx")) head = "  (void)cx;\n";
  return signature() + "\n{\n" + head + out_ + "}\n";
}

// The place of a jet in the frame.
std::string FunctionEmitter::slot(long number) { return number == 0 ? "frame" : number == 1 ? "frame + nc" : "frame + " + std::to_string(number) + "*nc"; }

std::string FunctionEmitter::signature() {
  bool active = v_.active(), jetResult = find(v_.result)->active;
  std::string params;
  auto add = [&](const std::string &p) { params += (params.empty() ? "" : ", ") + p; };
  if (active) add("tl_ctx *cx");
  if (jetResult) add("tl_real *result");
  for (size_t i = 0; i < v_.function->params.size(); ++i) add(parameter(i));
  std::string name = emitted_.names.at(&v_) + "(" + (params.empty() ? "void" : params) + ")";
  return "static " + (jetResult ? "void " + name : declaration(v_.function->result, name));
}

std::string FunctionEmitter::parameter(size_t i) {
  const Variable *param = v_.function->params[i];
  std::string name = param->name;
  bool byValue = param->type->kind == Type::Real || param->type->kind == Type::Struct;
  if (!byValue) return v_.active(param) ? jetDeclaration(param->type, name) : declaration(param->type, name);
  if (v_.activeParam(i)) return "const tl_real *" + (needsCopy(i) ? inputName(param) : name);
  return declaration(param->type, v_.active(param) ? inputName(param) : name);
}

// C passes numbers by value: a parameter that the body changes, or that it could change through a pointer, is copied first.
bool FunctionEmitter::needsCopy(size_t i) const {
  const Variable *param = v_.function->params[i];
  bool byValue = param->type->kind == Type::Real || param->type->kind == Type::Struct;
  if (!byValue || !v_.active(param)) return false;
  return !v_.activeParam(i) || assigned_.count(param) || writesThroughPointer_;
}

void FunctionEmitter::copyParameters() {
  for (size_t i = 0; i < v_.function->params.size(); ++i) {
    if (!needsCopy(i)) continue;
    const Type *type = v_.function->params[i]->type;
    std::string name = v_.function->params[i]->name, in = inputName(v_.function->params[i]);
    line("tl_real *const " + name + " = " + slot(slots_) + ";");
    slots_ += elements(type);
    if (v_.activeParam(i)) copyObject(name, in, type);
    else constants(name, type, {in, Primary});
  }
}

// The declaration of a pointer to active numbers, or of pointers to such pointers: numbers, arrays and structs of them are flat.
std::string FunctionEmitter::jetDeclaration(const Type *type, const std::string &name) const {
  if (type->kind == Type::Array) return jetDeclaration(type->element, name + "[" + std::to_string(type->count) + "]");
  std::string inner = std::string("*") + (type->isConst ? "const " : "") + name;
  const Type *target = type->element;
  if (!holdsNumbers(target)) return jetDeclaration(target, target->kind == Type::Array ? "(" + inner + ")" : inner);
  while (target->kind == Type::Array) target = target->element;
  return std::string(target->isConst ? "const " : "") + "tl_real " + inner;
}

// Which variables are assigned, and which are ever read: a value that nobody reads would make compilers warn.
void FunctionEmitter::survey(const Stmt *s) {
  if (!s) return;
  for (const Stmt *part : s->body) survey(part);
  survey(s->init);
  hoist_ |= s->kind == Stmt::Switch || s->kind == Stmt::Goto;
  if (s->kind == Stmt::Declare && s->expr) frame_.constants[s->var] = s->expr;
  if (s->kind == Stmt::Declare) surveyLengths(s->var->type);
  if (s->expr) survey(s->expr, s->kind != Stmt::Evaluate);
  if (s->step) survey(s->step, false);
  survey(s->then);
  survey(s->otherwise);
}

void FunctionEmitter::surveyLengths(const Type *type) {
  for (; type && type->kind != Type::Struct; type = type->element)
    if (type->length) survey(type->length, true);
}

void FunctionEmitter::survey(const Expr *e, bool read) {
  bool writes = e->kind == Expr::Assign || e->kind == Expr::Step;
  if (e->kind == Expr::Ref) {
    referenced_.insert(e->var);
    if (read) read_.insert(e->var);
  }
  for (size_t i = 0; i < e->args.size(); ++i) {
    if (!e->args[i]) continue;
    const Expr *arg = e->args[i];
    while (arg->kind == Expr::Member && !arg->arrow) arg = arg->args[0];
    bool written = (writes && i == 0) || e->kind == Expr::AddressOf;
    if (e->kind == Expr::AddressOf && arg->kind == Expr::Ref) addressTaken_.insert(arg->var);
    if (written && arg->kind == Expr::Ref) assigned_.insert(arg->var);
    else if (written) writesThroughPointer_ = true;
    survey(e->args[i], !(writes && i == 0 && arg->kind == Expr::Ref) || read);
    bool pointerArgument = e->kind == Expr::Call && arg->type->kind == Type::Pointer && !arg->type->element->isConst;
    if (pointerArgument) writesThroughPointer_ = true;
  }
}

void FunctionEmitter::line(const std::string &text) { out_ += std::string(static_cast<size_t>(2 * indent_), ' ') + text + "\n"; }

void FunctionEmitter::operation(const std::string &name, const std::string &args) { line("tl_" + name + "(cx, " + args + ");"); }

// The source line as a comment, once for consecutive statements of the same line, and the line number for the status.
void FunctionEmitter::quote(const Loc &loc) {
  if (loc.file < 0 || (loc.file == quoted_.file && loc.line == quoted_.line)) return;
  const auto &lines = program_.sources[static_cast<size_t>(loc.file)];
  std::string text = loc.line <= lines.size() ? commentText(lines[loc.line - 1]) : "";
  line("/* " + program_.files[static_cast<size_t>(loc.file)] + ":" + std::to_string(loc.line) + ": " + text + " */");
  line("cx->line = " + std::to_string(loc.line) + ";");
  quoted_ = loc;
}

std::string FunctionEmitter::temporary() {
  int n = temporariesUsed_++;
  temporaries_ = std::max(temporaries_, temporariesUsed_);
  return "tmp" + std::to_string(n);
}

// Room for a whole object. Structs are rare, so theirs is not used again.
std::string FunctionEmitter::temporary(const Type *type) {
  if (elements(type) == 1) return temporary();
  std::string place = slot(slots_);
  slots_ += elements(type);
  return place;
}

std::string FunctionEmitter::fresh(const std::string &stem) {
  std::string name;
  do name = stem + std::to_string(freshNames_++) + "_";
  while (program_.names.count(name));
  return name;
}

// A by-value parameter as it comes in, where the body works on a copy.
std::string FunctionEmitter::inputName(const Variable *param) const {
  std::string name = param->name + "_in";
  while (program_.names.count(name)) name += "_";
  return name;
}

// The name in the output: the source's, but for locals that were placed at the top together with others of that name.
std::string FunctionEmitter::nameOf(const Variable *v) const {
  auto renamed = renamed_.find(v);
  return renamed == renamed_.end() ? v->name : renamed->second;
}

void FunctionEmitter::statement(const Stmt *s) {
  temporariesUsed_ = 0;
  switch (s->kind) {
  case Stmt::Block:
    line("{");
    body(s);
    line("}");
    break;
  case Stmt::Declare: declare(s); break;
  case Stmt::Evaluate: evaluate(s->expr); break;
  case Stmt::If: branch(s); break;
  case Stmt::While:
  case Stmt::DoWhile:
  case Stmt::For: loop(s); break;
  case Stmt::Switch: choose(s); break;
  case Stmt::Case: choice(s, nullptr); break;
  case Stmt::Label: out_ += nameOf(s) + ":;\n"; quoted_ = {}; break;
  case Stmt::Goto: line("goto " + nameOf(s) + ";"); break;
  case Stmt::Break: leave(false); line("break;"); break;
  case Stmt::Continue: leave(true); line("continue;"); break;
  case Stmt::Return: returns(s); break;
  }
}

void FunctionEmitter::statements(const std::vector<Stmt *> &list) {
  for (size_t i = 0; i < list.size(); ++i) {
    if (i + 1 < list.size() && sincosPair(list[i], list[i + 1])) ++i;
    else statement(list[i]);
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
  if (s && s->kind == Stmt::Block) statements(s->body);
  else if (s) statement(s);
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
    if (scope->kind == Scope::Loop || (scope->kind == Scope::Choice && !loopOnly)) break;
  }
  if (!outermost.empty()) line("cx->top = " + outermost + ";");
}

std::string FunctionEmitter::nameOf(const Stmt *label) { return label->label + "_label"; }

void FunctionEmitter::choose(const Stmt *s) {
  line("switch (" + value(s->expr).s + ") {");
  scopes_.push_back({Scope::Choice, ""});
  const Stmt *before = nullptr;
  for (const Stmt *part : s->then->body) {
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
  bool ends = !last || last->kind == Stmt::Case || last->kind == Stmt::Break || last->kind == Stmt::Return || last->kind == Stmt::Goto || last->kind == Stmt::Continue;
  if (!ends) line("/* fall through */");
  line(s->expr ? "case " + value(s->expr).s + ":" : "default:");
  quoted_ = {};
}

void FunctionEmitter::declare(const Stmt *s) {
  const Variable *var = s->var;
  std::string name = nameOf(var);
  if (var->isStatic) return line("static " + declaration(var->type, name) + " = " + initializer(var->init) + ";");
  bool unread = !read_.count(var);
  if (!v_.active(var)) {
    std::string init;
    if (s->expr && s->expr->kind == Expr::InitList) init = " = " + value(s->expr).s;
    else if (s->expr) init = " = " + operand(value(s->expr), Assignment);
    line(passiveDeclaration(var->type, name) + init + ";");
  } else if (!holdsNumbers(var->type)) {
    std::string init;
    if (s->expr && s->expr->kind == Expr::InitList) init = " = " + pointerList(s->expr);
    else if (s->expr) init = " = " + operand(pointer(s->expr), Assignment);
    line(jetDeclaration(var->type, name) + init + ";");
  } else {
    if (s->expr) quote(s->loc);
    if (variableLength(var->type)) variableArray(var);
    else placeLocal(var);
    name = nameOf(var); // settled when it was placed
    if (s->expr) initObject(name, var->type, s->expr);
  }
  if (unread) line("(void)" + name + ";");
}

std::string FunctionEmitter::passiveDeclaration(const Type *type, std::string name) {
  if (!variableLength(type)) return declaration(type, name);
  for (; type->kind == Type::Array; type = type->element) name += "[" + (type->length ? value(type->length).s : std::to_string(type->count)) + "]";
  return declaration(type, name);
}

std::string FunctionEmitter::pointerList(const Expr *list) {
  std::string items;
  for (const Expr *item : list->args)
    items += (items.empty() ? "" : ", ") + (!item ? std::string("NULL") : item->kind == Expr::InitList ? pointerList(item) : operand(pointer(item), Assignment));
  return "{" + items + "}";
}

// A local of fixed size gets its jets in the frame; where jumps could pass the declaration, at the top of the function.
void FunctionEmitter::placeLocal(const Variable *var) {
  std::string name = nameOf(var);
  if (!hoist_) line("tl_real *const " + name + " = " + slot(slots_) + ";");
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
  std::string fallback = v_.function->result->kind == Type::Void || find(v_.result)->active ? "" : " 0";
  line("if (!" + name + ") {");
  line("  cx->top = mark;");
  line("  return" + fallback + ";");
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
  else if (item(0)) into(base, item(0)); // a number in braces
  else operation("const", base + ", 0");
}

// A passive object into jets: text names it in C.
void FunctionEmitter::constants(const std::string &base, const Type *type, const Text &text) {
  auto part = [&](long offset) { return at(base, offset); };
  if (type->kind == Type::Array)
    for (long i = 0; i < type->count; ++i) constants(part(i * elements(type->element)), type->element, {operand(text, Postfix) + "[" + std::to_string(i) + "]", Postfix});
  else if (type->kind == Type::Struct)
    for (const Field &field : type->record->fields) constants(part(fieldOffset(type->record, field.name)), field.type, {operand(text, Postfix) + "." + field.name, Postfix});
  else operation("const", base + ", " + operand(text, Assignment));
}

void FunctionEmitter::copyObject(const std::string &dest, const std::string &source, const Type *type) {
  long count = elements(type);
  if (count == 1) return operation("copy", dest + ", " + source);
  std::string k = fresh("k");
  line("for (ptrdiff_t " + k + " = 0; " + k + " < " + std::to_string(count) + "*nc; " + k + " += nc) tl_copy(cx, " + dest + " + " + k + ", " +
       source + " + " + k + ");");
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

void FunctionEmitter::stepAt(const std::string &x, const Expr *e) { operation("shift", x + ", " + x + ", " + (e->text == "++" ? "1" : "-1")); }

// lhs op= rhs; the address of lhs.
Text FunctionEmitter::assign(const Expr *e) {
  quote(e->loc);
  const Expr *lhs = e->args[0], *rhs = e->args[1];
  Text at = fixedAddress(lhs);
  const std::string &x = at.s;
  if (e->text == "=") return into(x, rhs), at;
  std::string op = e->text.substr(0, 1);
  if (!isJet(rhs)) {
    Text k = value(rhs);
    const char *name = op == "+" || op == "-" ? "shift" : op == "*" ? "scale" : "divc";
    return operation(name, x + ", " + x + ", " + (op == "-" ? unaryText("-", k).s : operand(k, Assignment))), at;
  }
  bool scaledTerm = rhs->kind == Expr::Binary && rhs->text == "*" && isJet(rhs->args[0]) != isJet(rhs->args[1]);
  if (scaledTerm && (op == "+" || op == "-")) {
    const Expr *factor = rhs->args[isJet(rhs->args[0]) ? 1 : 0], *term = rhs->args[isJet(rhs->args[0]) ? 0 : 1];
    Text k = value(factor);
    std::string y = jet(term);
    return operation("axpy", x + ", " + (op == "-" ? unaryText("-", k).s : operand(k, Assignment)) + ", " + y), at;
  }
  if (rhs->kind == Expr::Binary && rhs->text == "*" && op == "+" && isAlone(lhs, rhs->args[0]) && isAlone(lhs, rhs->args[1])) {
    std::string a = jet(rhs->args[0]), b = jet(rhs->args[1]);
    return operation("muladd", x + ", " + a + ", " + b), at;
  }
  std::string y = jet(rhs);
  const char *name = op == "+" ? "add" : op == "-" ? "sub" : op == "*" ? "mul" : "div";
  return operation(name, x + ", " + x + ", " + y), at;
}

// True where lhs is a local number that the factor, if it is an object itself, cannot be.
bool FunctionEmitter::isAlone(const Expr *lhs, const Expr *factor) const {
  if (lhs->kind != Expr::Ref || lhs->var->scope == Variable::Global || addressTaken_.count(lhs->var)) return false;
  while (factor->kind == Expr::Cast) factor = factor->args[0];
  return !(factor->kind == Expr::Ref && factor->var == lhs->var) && factor->kind != Expr::Assign && factor->kind != Expr::Step;
}

void FunctionEmitter::branch(const Stmt *s) {
  bool statements = needsStatements(s->expr);
  if (statements) quote(s->loc);
  line("if (" + condition(s->expr).s + ") {");
  body(s->then);
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
  bool activeInit = s->init && s->init->kind == Stmt::Block && std::any_of(s->init->body.begin(), s->init->body.end(), [&](const Stmt *d) { return v_.active(d->var); });
  if (s->init && s->init->kind == Stmt::Evaluate) activeInit = needsStatements(s->init->expr) || s->init->expr->kind == Expr::Comma;
  if (activeStep || activeInit || (s->init && s->init->kind == Stmt::Block && s->init->body.size() > 1) || (s->expr && needsStatements(s->expr))) return generalLoop(s);
  if (s->kind == Stmt::DoWhile) {
    line("do {");
    body(s->then);
    return line("} while (" + condition(s->expr).s + ");");
  }
  std::string cond = s->expr ? condition(s->expr).s : "";
  if (s->kind == Stmt::While) line("while (" + cond + ") {");
  else {
    std::string init;
    if (s->init && s->init->kind == Stmt::Evaluate) init = value(s->init->expr).s;
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
  else if (s->init) statement(s->init);
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
  if (!s->expr) {
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
