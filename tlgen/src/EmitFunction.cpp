// One function as calls on jets: signature, frame, names and places. Statements are in EmitStatement.cpp, expressions in
// EmitExpression.cpp.
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
  for (auto it = frame_.constants.begin(); it != frame_.constants.end();)
    it = assigned_.count(it->first) ? frame_.constants.erase(it) : std::next(it);
  for (const Variable *param : v_.function->params) hoistedNames_.insert(param->name);
  copyParameters();
  for (const Variable *param : v_.function->params)
    if (!read_.count(param)) line("(void)" + param->name + ";");
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
  if (frame)
    head = "  tl_real *const frame = tl_push(cx, " + std::to_string(frame) + ");\n  if (!frame) return" + nothing() + ";\n" + head;
  if (marked) head = "  tl_real *const mark = cx->top;\n" + head;
  if (mentions(head + out_, "nc")) head = "  const ptrdiff_t nc = cx->shape->ncoef;\n" + head;
  if (v_.active() && !mentions(head + out_, "cx")) head = "  (void)cx;\n";
  return signature() + "\n{\n" + head + out_ + "}\n";
}

// What a function returns where there is no room for its jets.
std::string FunctionEmitter::nothing() const {
  const Type *type = v_.function->result;
  if (type->kind == Type::Void || find(v_.result)->active) return "";
  return type->kind == Type::Struct ? " (" + declaration(type, "") + ")" + zeroValue(type) : " 0";
}

// The place of a jet in the frame.
std::string FunctionEmitter::slot(long number) {
  return number == 0 ? "frame" : number == 1 ? "frame + nc" : "frame + " + std::to_string(number) + "*nc";
}

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
    if (v_.activeParam(i))
      copyObject(name, in, type);
    else
      constants(name, type, {in, Primary});
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
  if (s->kind == Stmt::Goto) targets_.insert(s->label);
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
  if (e->kind == Expr::Ref && read) read_.insert(e->var);
  for (size_t i = 0; i < e->args.size(); ++i) {
    if (!e->args[i]) continue;
    const Expr *arg = e->args[i];
    while (arg->kind == Expr::Member && !arg->arrow) arg = arg->args[0];
    bool written = (writes && i == 0) || e->kind == Expr::AddressOf;
    if (e->kind == Expr::AddressOf && arg->kind == Expr::Ref) addressTaken_.insert(arg->var);
    if (written && arg->kind == Expr::Ref)
      assigned_.insert(arg->var);
    else if (written)
      writesThroughPointer_ = true;
    survey(e->args[i], !(writes && i == 0 && arg->kind == Expr::Ref) || read);
    bool pointerArgument = e->kind == Expr::Call && arg->type->kind == Type::Pointer && !arg->type->element->isConst;
    if (pointerArgument) writesThroughPointer_ = true;
  }
}

void FunctionEmitter::line(const std::string &text) { out_ += std::string(static_cast<size_t>(2 * indent_), ' ') + text + "\n"; }

void FunctionEmitter::operation(const std::string &name, const std::string &args) {
  if (lineLost_ && quoted_.file >= 0) tellLine(quoted_);
  line("tl_" + name + "(cx, " + args + ");");
}

// The place for the status; a function that is called tells its own.
void FunctionEmitter::tellLine(const Loc &loc) {
  line("cx->line = " + std::to_string(loc.line) + ";");
  if (emitted_.severalFiles) line("cx->file = \"" + program_.files[static_cast<size_t>(loc.file)] + "\";");
  quoted_ = loc;
  lineLost_ = false;
}

// The source line as a comment, once for consecutive statements of the same line, and the line number for the status.
void FunctionEmitter::quote(const Loc &loc) {
  if (loc.file < 0 || (loc.file == quoted_.file && loc.line == quoted_.line && !lineLost_)) return;
  const auto &lines = program_.sources[static_cast<size_t>(loc.file)];
  std::string text = loc.line <= lines.size() ? commentText(lines[loc.line - 1]) : "";
  line("/* " + program_.files[static_cast<size_t>(loc.file)] + ":" + std::to_string(loc.line) + ": " + text + " */");
  tellLine(loc);
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
  case Stmt::Declare:
    declare(s);
    break;
  case Stmt::Evaluate:
    evaluate(s->expr);
    break;
  case Stmt::If:
    branch(s);
    break;
  case Stmt::While:
  case Stmt::DoWhile:
  case Stmt::For:
    loop(s);
    break;
  case Stmt::Switch:
    choose(s);
    break;
  case Stmt::Case:
    choice(s, nullptr);
    break;
  case Stmt::Label:
    if (!targets_.count(s->label)) break;
    out_ += nameOf(s) + ":;\n";
    quoted_ = {};
    break;
  case Stmt::Goto:
    line("goto " + nameOf(s) + ";");
    break;
  case Stmt::Break:
    leave(false);
    line("break;");
    break;
  case Stmt::Continue:
    leave(true);
    line("continue;");
    break;
  case Stmt::Return:
    returns(s);
    break;
  }
}

} // namespace tlgen
