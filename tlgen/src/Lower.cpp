// Turns Clang's tree into the intermediate program. Whatever Subset accepts has a case here, and nothing else.
#include "Lower.h"
#include "CopyLoop.h"
#include "PrintC.h"

#include "clang/AST/ASTContext.h"
#include "clang/AST/Expr.h"
#include "clang/Basic/SourceManager.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace tlgen {
namespace {

namespace c = clang;

// What makes an integer literal one of its type.
std::string suffix(c::QualType type) {
  std::string s = type->isSignedIntegerType() ? "" : "u";
  if (type->isSpecificBuiltinType(c::BuiltinType::Long) || type->isSpecificBuiltinType(c::BuiltinType::ULong)) return s + "l";
  if (type->isSpecificBuiltinType(c::BuiltinType::LongLong) || type->isSpecificBuiltinType(c::BuiltinType::ULongLong)) return s + "ll";
  return s;
}

class Lowering {
public:
  Lowering(const Source &source, const Match &match, Program &program) : source_(source), match_(match), program_(program) {}

  Function *declare(const Instance &instance) {
    const c::FunctionDecl *decl = instance.function;
    Function *f = program_.make(Function{});
    f->name = instanceName(instance);
    context_ = &decl->getASTContext();
    f->result = type(decl->getReturnType());
    f->loc = loc(decl->getLocation());
    for (const c::ParmVarDecl *param : decl->parameters())
      if (!holdsFunction(param->getType())) f->params.push_back(variable(param, Variable::Parameter));
    functions_[instance] = f;
    program_.functions.push_back(f);
    return f;
  }

  void define(const Instance &instance) {
    const c::FunctionDecl *decl = instance.function;
    context_ = &decl->getASTContext();
    Function *f = functions_[instance];
    size_t next = 0;
    for (const c::ParmVarDecl *param : decl->parameters()) // several instances have the same declarations
      if (!holdsFunction(param->getType())) variables_[param] = const_cast<Variable *>(f->params[next++]);
    Calls calls(source_, match_, instance);
    calls_ = &calls;
    f->body = stmt(decl->getBody());
    calls_ = nullptr;
  }

  Function *functionOf(const Instance &instance) { return functions_.at(instance); }
  const Record *record(const c::RecordDecl *decl);

private:
  const Type *type(c::QualType qt);
  Loc loc(c::SourceLocation at);
  const Record *sameName(const Record &r) const;
  static bool sameFields(const Record &a, const Record &b);
  int fileIndex(c::FileID id, const std::string &name);
  Variable *variable(const c::VarDecl *decl, Variable::Scope scope);
  const Variable *reference(const c::VarDecl *decl);
  Stmt *stmt(const c::Stmt *s);
  Stmt *declaration(const c::DeclStmt *s);
  void append(Stmt *block, const c::Stmt *s);
  Expr *expr(const c::Expr *e);
  Expr *castOf(const c::CastExpr *e);
  Expr *unary(const c::UnaryOperator *e);
  Expr *callOf(const c::CallExpr *e);
  Expr *settledCall(const c::CallExpr *e, const Reach &reach, const std::vector<Expr *> &args);
  Expr *chosenCall(const c::CallExpr *e, const Reach &reach, const std::vector<Expr *> &args);
  Expr *externalCall(const c::CallExpr *e, const Reach &reach, std::vector<Expr *> args);
  Stmt *copyOf(const c::CallExpr *e, const BulkCopy &copy);
  Stmt *evaluation(const c::Stmt *s, Expr *value);
  static bool holdsFunction(c::QualType type);
  Expr *initList(const c::InitListExpr *e);
  Expr *characterOf(const c::CharacterLiteral *e);
  Expr *compound(const c::CompoundAssignOperator *e);
  static std::string nameOf(const c::FieldDecl *field);
  const Type *room(const c::FieldDecl *field);
  Expr *characters(const c::StringLiteral *e);
  Expr *sizeOf(const c::UnaryExprOrTypeTraitExpr *e, c::QualType of);
  Expr *node(Expr::Kind kind, const c::Expr *e, std::vector<Expr *> args, const std::string &text = "");
  Stmt *node(Stmt::Kind kind, const c::Stmt *s) {
    Stmt n;
    n.kind = kind;
    n.loc = loc(s->getBeginLoc());
    return program_.make(std::move(n));
  }

  const Source &source_;
  const Match &match_;
  Program &program_;
  const c::ASTContext *context_ = nullptr;
  const Calls *calls_ = nullptr; // of the function whose body is being lowered
  std::map<Instance, Function *> functions_;
  std::map<const c::VarDecl *, Variable *> variables_;
  std::map<const c::RecordDecl *, const Record *> records_;
  std::map<std::string, int> files_;
};

const Type *Lowering::type(c::QualType qt) {
  Type t;
  t.isConst = qt.isConstQualified();
  c::QualType canonical = qt.getCanonicalType().getUnqualifiedType();
  if (const auto *array = context_->getAsConstantArrayType(qt)) {
    t.kind = Type::Array;
    t.count = static_cast<long>(array->getSize().getZExtValue());
    t.element = type(array->getElementType());
    t.isConst = t.element->isConst;
  } else if (const auto *variable = context_->getAsVariableArrayType(qt)) {
    t.kind = Type::Array;
    if (variable->getSizeExpr()) t.length = expr(variable->getSizeExpr()); // none for [*], where nobody asks
    t.element = type(variable->getElementType());
    t.isConst = t.element->isConst;
  } else if (canonical->isPointerType()) {
    t.kind = Type::Pointer; // to a function: a member that keeps its room in a struct, and no more
    t.element = type(Calls::isFunctionPointer(canonical) ? context_->VoidTy : qt->getPointeeType());
  } else if (const auto *rec = canonical->getAs<c::RecordType>()) {
    t.kind = Type::Struct;
    t.record = record(rec->getDecl());
  } else if (canonical->isVoidType()) {
    t.kind = Type::Void;
  } else if (canonical->isRealFloatingType()) {
    t.kind = Type::Real;
    t.name = canonical->isSpecificBuiltinType(c::BuiltinType::Float) ? "float" : "double";
  } else {
    t.kind = Type::Integer;
    if (const auto *e = canonical->getAs<c::EnumType>()) canonical = e->getDecl()->getIntegerType().getCanonicalType();
    t.name =
        canonical->isBooleanType() ? "_Bool" : canonical.getUnqualifiedType().getAsString(c::PrintingPolicy(context_->getLangOpts()));
  }
  return program_.make(std::move(t));
}

const Record *Lowering::record(const c::RecordDecl *decl) {
  if (const c::RecordDecl *def = decl->getDefinition()) decl = def;
  std::string spelling = context_ ? context_->getRecordType(decl).getAsString(c::PrintingPolicy(context_->getLangOpts())) : "";
  if (!context_) {
    context_ = &decl->getASTContext();
    spelling = context_->getRecordType(decl).getAsString(c::PrintingPolicy(context_->getLangOpts()));
  }
  const c::TypedefNameDecl *name = decl->getTypedefNameForAnonDecl();
  std::string tag = decl->getNameAsString();
  if (name) spelling = name->getNameAsString();
  if (!name && tag.empty()) { // it needs a name of its own to be declared by
    std::string file = program_.files[static_cast<size_t>(loc(decl->getLocation()).file)];
    for (char &ch : file)
      if (!isalnum(static_cast<unsigned char>(ch))) ch = '_';
    tag = "unnamed_" + file + "_" + std::to_string(context_->getSourceManager().getPresumedLoc(decl->getLocation()).getLine());
    spelling = "struct " + tag;
  }
  auto found = records_.find(decl);
  if (found != records_.end()) return found->second;
  Record *r = program_.make(Record{});
  records_[decl] = r;
  r->spelling = spelling;
  r->tag = tag;
  r->loc = loc(decl->getLocation());
  if (decl->isCompleteDefinition())
    for (const c::FieldDecl *field : decl->fields())
      r->fields.push_back({nameOf(field), refusedMember(field) ? room(field) : type(field->getType()), loc(field->getLocation())});
  for (int n = 2; const Record *other = sameName(*r); ++n) {
    if (sameFields(*r, *other)) return records_[decl] = other; // of another translation unit
    std::string end = "_" + std::to_string(n);                 // of another scope
    r->tag = tag.empty() ? "" : tag + end;
    r->spelling = r->tag.empty() ? spelling + end : "struct " + r->tag;
  }
  program_.records.push_back(r); // after the records that its fields need
  return r;
}

// A member that nobody may touch: what keeps its place.
const Type *Lowering::room(const c::FieldDecl *field) {
  Type t, element;
  t.kind = field->getType()->isPointerType() ? Type::Pointer : Type::Array;
  element.kind = t.kind == Type::Pointer ? Type::Void : Type::Integer;
  element.name = "_Alignas(" + std::to_string(context_->getTypeAlignInChars(field->getType()).getQuantity()) + ") unsigned char";
  t.count = static_cast<long>(context_->getTypeSizeInChars(field->getType()).getQuantity());
  t.element = program_.make(std::move(element));
  return program_.make(std::move(t));
}

// A member without a name stands for the struct that it is.
std::string Lowering::nameOf(const c::FieldDecl *field) {
  std::string name = field->getNameAsString();
  if (!name.empty()) return name;
  name = "unnamed" + std::to_string(field->getFieldIndex());
  const auto &fields = field->getParent()->fields();
  while (std::any_of(fields.begin(), fields.end(), [&](const c::FieldDecl *f) { return f->getNameAsString() == name; })) name += "_";
  return name;
}

const Record *Lowering::sameName(const Record &r) const {
  for (const Record *other : program_.records)
    if (other->spelling == r.spelling) return other;
  return nullptr;
}

bool Lowering::sameFields(const Record &a, const Record &b) {
  return std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), b.fields.end(), [](const Field &x, const Field &y) {
    return x.name == y.name && tlgen::declaration(x.type, "") == tlgen::declaration(y.type, "");
  });
}

int Lowering::fileIndex(c::FileID id, const std::string &path) {
  auto found = files_.find(path);
  if (found != files_.end()) return found->second;
  size_t slash = path.find_last_of('/');
  program_.paths.push_back(path);
  program_.files.push_back(slash == std::string::npos ? path : path.substr(slash + 1));
  std::vector<std::string> lines;
  std::istringstream text(context_->getSourceManager().getBufferData(id).str());
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  program_.sources.push_back(std::move(lines));
  return files_[path] = static_cast<int>(program_.files.size()) - 1;
}

Loc Lowering::loc(c::SourceLocation at) {
  const c::SourceManager &sm = context_->getSourceManager();
  c::SourceLocation place = sm.getExpansionLoc(at);
  c::PresumedLoc p = sm.getPresumedLoc(place, false);
  if (p.isInvalid()) return {};
  return {fileIndex(sm.getFileID(place), pathOf(sm, p)), p.getLine(), p.getColumn()};
}

Variable *Lowering::variable(const c::VarDecl *decl, Variable::Scope scope) {
  Variable v;
  v.scope = scope;
  v.name = decl->getNameAsString();
  v.type = type(decl->getType());
  v.loc = loc(decl->getLocation());
  v.isStatic = decl->isStaticLocal();
  Variable *made = program_.make(std::move(v));
  variables_[decl] = made;
  if ((scope == Variable::Global || made->isStatic) && decl->getInit()) made->init = expr(decl->getInit());
  return made;
}

const Variable *Lowering::reference(const c::VarDecl *decl) {
  if (const c::VarDecl *init = decl->hasGlobalStorage() ? source_.definition(decl) : nullptr) decl = init;
  auto found = variables_.find(decl);
  if (found != variables_.end()) return found->second;
  const c::ASTContext *here = context_;
  context_ = &decl->getASTContext(); // it may be another file's
  Variable *global = variable(decl, Variable::Global);
  context_ = here;
  program_.globals.push_back(global);
  return global;
}

Stmt *Lowering::declaration(const c::DeclStmt *s) {
  Stmt *block = node(Stmt::Block, s);
  for (const c::Decl *d : s->decls()) {
    const auto *decl = llvm::dyn_cast<c::VarDecl>(d);
    if (!decl || holdsFunction(decl->getType())) continue; // a local type, or a function that calls are settled with
    Stmt *one = node(Stmt::Declare, s);
    one->var = variable(decl, Variable::Local);
    if (decl->getInit() && !one->var->isStatic) one->expr = expr(decl->getInit());
    block->body.push_back(one);
  }
  return block;
}

// A statement into a block: declarations one by one, cases and labels as statements of their own.
void Lowering::append(Stmt *block, const c::Stmt *s) {
  if (const auto *hinted = llvm::dyn_cast<c::AttributedStmt>(s)) return append(block, hinted->getSubStmt());
  if (const auto *decl = llvm::dyn_cast<c::DeclStmt>(s)) {
    Stmt *several = declaration(decl);
    block->body.insert(block->body.end(), several->body.begin(), several->body.end());
  } else if (const auto *choice = llvm::dyn_cast<c::SwitchCase>(s)) {
    Stmt *n = node(Stmt::Case, s);
    if (const auto *value = llvm::dyn_cast<c::CaseStmt>(choice)) n->expr = expr(value->getLHS());
    block->body.push_back(n);
    append(block, choice->getSubStmt());
  } else if (const auto *label = llvm::dyn_cast<c::LabelStmt>(s)) {
    Stmt *n = node(Stmt::Label, s);
    n->label = label->getDecl()->getNameAsString();
    block->body.push_back(n);
    append(block, label->getSubStmt());
  } else if (!llvm::isa<c::NullStmt>(s)) {
    block->body.push_back(stmt(s));
  }
}

Stmt *Lowering::stmt(const c::Stmt *s) {
  if (!s || llvm::isa<c::NullStmt>(s)) {
    Stmt empty;
    if (s) empty.loc = loc(s->getBeginLoc());
    return program_.make(std::move(empty));
  }
  if (const auto *hinted = llvm::dyn_cast<c::AttributedStmt>(s)) return stmt(hinted->getSubStmt());
  if (const auto *block = llvm::dyn_cast<c::CompoundStmt>(s)) {
    Stmt *n = node(Stmt::Block, s);
    for (const c::Stmt *part : block->body()) append(n, part);
    return n;
  }
  if (llvm::isa<c::LabelStmt>(s) || llvm::isa<c::SwitchCase>(s)) { // as the only statement of a branch or loop
    Stmt *n = node(Stmt::Block, s);
    append(n, s);
    return n;
  }
  if (const auto *choice = llvm::dyn_cast<c::SwitchStmt>(s)) {
    Stmt *n = node(Stmt::Switch, s);
    n->expr = expr(choice->getCond());
    n->then = stmt(choice->getBody());
    return n;
  }
  if (const auto *jump = llvm::dyn_cast<c::GotoStmt>(s)) {
    Stmt *n = node(Stmt::Goto, s);
    n->label = jump->getLabel()->getNameAsString();
    return n;
  }
  if (const auto *decl = llvm::dyn_cast<c::DeclStmt>(s)) return declaration(decl);
  if (const auto *branch = llvm::dyn_cast<c::IfStmt>(s)) {
    Stmt *n = node(Stmt::If, s);
    n->expr = expr(branch->getCond());
    n->then = stmt(branch->getThen());
    if (branch->getElse()) n->otherwise = stmt(branch->getElse());
    return n;
  }
  if (const auto *loop = llvm::dyn_cast<c::ForStmt>(s)) {
    Stmt *n = node(Stmt::For, s);
    if (loop->getInit()) n->init = stmt(loop->getInit());
    if (loop->getCond()) n->expr = expr(loop->getCond());
    if (loop->getInc()) n->step = expr(loop->getInc());
    n->then = stmt(loop->getBody());
    return n;
  }
  if (const auto *loop = llvm::dyn_cast<c::WhileStmt>(s)) {
    Stmt *n = node(Stmt::While, s);
    n->expr = expr(loop->getCond());
    n->then = stmt(loop->getBody());
    return n;
  }
  if (const auto *loop = llvm::dyn_cast<c::DoStmt>(s)) {
    Stmt *n = node(Stmt::DoWhile, s);
    n->then = stmt(loop->getBody());
    n->expr = expr(loop->getCond());
    return n;
  }
  if (llvm::isa<c::BreakStmt>(s)) return node(Stmt::Break, s);
  if (llvm::isa<c::ContinueStmt>(s)) return node(Stmt::Continue, s);
  if (const auto *ret = llvm::dyn_cast<c::ReturnStmt>(s)) {
    Stmt *n = node(Stmt::Return, s);
    if (ret->getRetValue()) n->expr = expr(ret->getRetValue());
    return n;
  }
  const auto *e = llvm::cast<c::Expr>(s)->IgnoreParens();
  if (const auto *cast = llvm::dyn_cast<c::CStyleCastExpr>(e))
    if (cast->getType()->isVoidType()) e = cast->getSubExpr()->IgnoreParens();
  if (const auto *call = llvm::dyn_cast<c::CallExpr>(e)) {
    Reach reach = calls_->reach(call);
    if (reach.kind == Reach::Copy) return copyOf(call, *reach.copy);
    if (reach.kind == Reach::Nothing) return node(Stmt::Block, s);
  }
  if (llvm::isa<c::UnaryExprOrTypeTraitExpr>(e)) return node(Stmt::Block, s); // an assertion
  return evaluation(s, expr(llvm::cast<c::Expr>(s)));
}

// An expression for its effects: a choice between two of them is a branch.
Stmt *Lowering::evaluation(const c::Stmt *s, Expr *value) {
  bool choice = value->kind == Expr::Conditional, flag = value->kind == Expr::Step && value->type->name == "_Bool";
  if (flag) { // b++ is 1, b-- the opposite: compilers warn of arithmetic on truth values
    Expr *b = value->args[0], *next = program_.make(Expr{*b});
    next->kind = value->text == "++" ? Expr::Literal : Expr::Unary;
    next->text = value->text == "++" ? "1" : "!";
    next->args.clear();
    if (value->text != "++") next->args = {b};
    value->kind = Expr::Assign;
    value->text = "=";
    value->args = {b, next};
  }
  Stmt *n = node(choice ? Stmt::If : Stmt::Evaluate, s);
  n->expr = choice ? value->args[0] : value;
  if (choice) n->then = evaluation(s, value->args[1]), n->otherwise = evaluation(s, value->args[2]);
  return n;
}

Stmt *Lowering::copyOf(const c::CallExpr *call, const BulkCopy &copy) {
  const c::Expr *bytes = call->getArg(2); // of the type size_t
  Expr *count = node(Expr::Literal, bytes, {}, std::to_string(copy.number) + suffix(bytes->getType()));
  if (copy.bytes)
    count = node(Expr::Binary, bytes,
                 {expr(copy.factor), node(Expr::Literal, bytes, {}, std::to_string(copy.bytes) + suffix(bytes->getType()))}, "/");
  if (copy.factor && !copy.bytes) count = node(Expr::Binary, bytes, {node(Expr::Cast, bytes, {expr(copy.factor)}), count}, "*");
  Expr *from = copy.from ? expr(copy.from) : nullptr;
  return copyLoop(program_, loc(call->getExprLoc()), expr(copy.to), from, count, copy.overlap);
}

Expr *Lowering::node(Expr::Kind kind, const c::Expr *e, std::vector<Expr *> args, const std::string &text) {
  Expr n;
  n.kind = kind;
  n.type = type(e->getType());
  n.loc = loc(e->getExprLoc());
  n.text = text;
  n.args = std::move(args);
  return program_.make(std::move(n));
}

Expr *Lowering::castOf(const c::CastExpr *e) {
  if (Calls::isNull(e, *context_)) return node(Expr::Literal, e, {}, "NULL");
  if (const auto *text = llvm::dyn_cast<c::StringLiteral>(e->getSubExpr()->IgnoreParens()))
    if (e->getCastKind() == c::CK_ArrayToPointerDecay) {
      std::string quoted;
      llvm::raw_string_ostream out(quoted);
      text->outputString(out);
      return node(Expr::Literal, e, {}, out.str());
    }
  Expr *inner = expr(e->getSubExpr());
  switch (e->getCastKind()) {
  case c::CK_NoOp:
    if (e->getType()->isPointerType() && inner->type->kind == Type::Pointer && inner->type->element->isConst) break;
    return inner;
  case c::CK_LValueToRValue:
    return inner;
  case c::CK_PointerToBoolean: {
    Expr *null = node(Expr::Literal, e->getSubExpr(), {}, "NULL");
    return node(Expr::Binary, e, {inner, null}, "!=");
  }
  case c::CK_ArrayToPointerDecay:
    return node(Expr::Decay, e, {inner});
  default:
    break;
  }
  return node(Expr::Cast, e, {inner});
}

Expr *Lowering::unary(const c::UnaryOperator *e) {
  Expr *inner = expr(e->getSubExpr());
  switch (e->getOpcode()) {
  case c::UO_Deref:
    return node(Expr::Deref, e, {inner});
  case c::UO_AddrOf:
    return node(Expr::AddressOf, e, {inner});
  case c::UO_PreInc:
  case c::UO_PreDec:
  case c::UO_PostInc:
  case c::UO_PostDec: {
    Expr *n = node(Expr::Step, e, {inner}, e->isIncrementOp() ? "++" : "--");
    n->prefix = e->isPrefix();
    return n;
  }
  default:
    return node(Expr::Unary, e, {inner}, c::UnaryOperator::getOpcodeStr(e->getOpcode()).str());
  }
}

bool Lowering::holdsFunction(c::QualType type) {
  while (const auto *array = type->getAsArrayTypeUnsafe()) type = array->getElementType();
  return Calls::isFunctionPointer(type);
}

Expr *Lowering::callOf(const c::CallExpr *e) {
  Reach reach = calls_->reach(e);
  std::vector<Expr *> args;
  for (const c::Expr *arg : e->arguments())
    if (!holdsFunction(arg->getType())) args.push_back(expr(arg));
  return reach.kind == Reach::Same ? args[0] : reach.kind == Reach::Choice ? chosenCall(e, reach, args) : settledCall(e, reach, args);
}

Expr *Lowering::settledCall(const c::CallExpr *e, const Reach &reach, const std::vector<Expr *> &args) {
  if (reach.kind == Reach::Rule) return externalCall(e, reach, args);
  if (reach.kind == Reach::Math) return node(Expr::MathCall, e, args, mathName(reach.callee->getNameAsString()));
  Expr *call = node(Expr::Call, e, args);
  call->callee = functions_.at(reach.instance);
  return call;
}

// A choice between calls: the condition's, or by comparing the index; past the last but one it is the last.
Expr *Lowering::chosenCall(const c::CallExpr *e, const Reach &reach, const std::vector<Expr *> &args) {
  Expr *chain = settledCall(e, reach.options.back(), args);
  for (size_t i = reach.options.size() - 1; i-- > 0;) {
    Expr *test = expr(reach.choice);
    if (!reach.choiceIsCondition) {
      Expr *number = node(Expr::Literal, reach.choice, {}, std::to_string(i) + suffix(reach.choice->getType()));
      test = node(Expr::Binary, reach.choice, {test, number}, "==");
    }
    chain = node(Expr::Conditional, e, {test, settledCall(e, reach.options[i], args), chain});
  }
  return chain;
}

Expr *Lowering::externalCall(const c::CallExpr *e, const Reach &reach, std::vector<Expr *> args) {
  std::string name = reach.callee->getNameAsString();
  Expr *n = node(Expr::MathCall, e, std::move(args), name);
  n->rule = &program_.rules.emplace(name, Rule{name, reach.rule, n->args.size()}).first->second;
  return n;
}

Expr *Lowering::initList(const c::InitListExpr *e) {
  if (const c::InitListExpr *semantic = e->getSemanticForm()) e = semantic;
  std::vector<Expr *> items;
  for (const c::Expr *item : e->inits()) {
    bool left = !item || llvm::isa<c::ImplicitValueInitExpr>(item) || holdsFunction(item->getType());
    items.push_back(left ? nullptr : expr(item));
  }
  return node(Expr::InitList, e, std::move(items));
}

// In bytes; of an array of variable length its length times that of an element.
Expr *Lowering::sizeOf(const c::UnaryExprOrTypeTraitExpr *e, c::QualType of) {
  if (const auto *array = context_->getAsVariableArrayType(of)) {
    Expr *length = node(Expr::Cast, e, {expr(array->getSizeExpr())});
    return node(Expr::Binary, e, {length, sizeOf(e, array->getElementType())}, "*");
  }
  c::CharUnits size = e->getKind() == c::UETT_SizeOf ? context_->getTypeSizeInChars(of) : context_->getTypeAlignInChars(of);
  return node(Expr::Literal, e, {}, std::to_string(size.getQuantity()) + suffix(e->getType()));
}

// The list of characters that a string is as an initialiser: as many as the array has.
Expr *Lowering::characters(const c::StringLiteral *e) {
  Expr *list = node(Expr::InitList, e, {});
  c::QualType type = e->getType()->getAsArrayTypeUnsafe()->getElementType();
  const uint64_t bits = context_->getTypeSize(type), sign = uint64_t(1) << (bits - 1);
  for (long i = 0; i < list->type->count; ++i) {
    uint64_t unit = i < static_cast<long>(e->getLength()) ? e->getCodeUnit(static_cast<unsigned>(i)) : 0;
    long long value =
        static_cast<long long>(unit) - (type->isSignedIntegerType() && (unit & sign) ? static_cast<long long>(2 * sign) : 0);
    Expr *item = node(Expr::Literal, e, {}, std::to_string(value) + (type->isSignedIntegerType() ? "" : "u"));
    item->type = list->type->element;
    list->args.push_back(item);
  }
  return list;
}

Expr *Lowering::characterOf(const c::CharacterLiteral *e) {
  bool isSigned = e->getType()->isSignedIntegerType();
  long long value = isSigned ? static_cast<int32_t>(e->getValue()) : static_cast<long long>(e->getValue());
  return node(Expr::Literal, e, {}, std::to_string(value) + suffix(e->getType()));
}

// x op= y. Where C computes in another type than x has, x = (type of x)((that type)x op y), or compilers warn.
Expr *Lowering::compound(const c::CompoundAssignOperator *e) {
  std::string op = c::BinaryOperator::getOpcodeStr(c::BinaryOperator::getOpForCompoundAssignment(e->getOpcode())).str();
  c::QualType own = e->getLHS()->getType().getUnqualifiedType(), wide = e->getComputationLHSType();
  bool same = context_->hasSameUnqualifiedType(own, wide) && context_->hasSameUnqualifiedType(own, e->getComputationResultType());
  Expr *lhs = expr(e->getLHS()), *rhs = expr(e->getRHS());
  if (same || own->isPointerType() || e->getLHS()->HasSideEffects(*context_)) return node(Expr::Assign, e, {lhs, rhs}, op + "=");
  Expr *widened = node(Expr::Cast, e, {expr(e->getLHS())}), *result = node(Expr::Binary, e, {widened, rhs}, op);
  widened->type = type(wide);
  result->type = type(e->getComputationResultType());
  return node(Expr::Assign, e, {lhs, node(Expr::Cast, e, {result})}, "=");
}

Expr *Lowering::expr(const c::Expr *e) {
  e = e->IgnoreParens();
  if (const auto *constant = llvm::dyn_cast<c::ConstantExpr>(e)) return expr(constant->getSubExpr());
  if (const auto *lit = llvm::dyn_cast<c::IntegerLiteral>(e)) {
    llvm::SmallString<24> text;
    bool isSigned = e->getType()->isSignedIntegerType();
    lit->getValue().toString(text, 10, isSigned);
    return node(Expr::Literal, e, {}, text.str().str() + suffix(e->getType()));
  }
  if (const auto *lit = llvm::dyn_cast<c::CharacterLiteral>(e)) return characterOf(lit);
  if (const auto *text = llvm::dyn_cast<c::StringLiteral>(e)) return characters(text);
  if (const auto *lit = llvm::dyn_cast<c::FloatingLiteral>(e)) {
    bool isFloat = e->getType()->isSpecificBuiltinType(c::BuiltinType::Float);
    double value = isFloat ? static_cast<double>(lit->getValue().convertToFloat()) : lit->getValue().convertToDouble();
    return node(Expr::Literal, e, {}, decimal(value) + (isFloat ? "f" : ""));
  }
  if (const auto *size = llvm::dyn_cast<c::UnaryExprOrTypeTraitExpr>(e)) return sizeOf(size, size->getTypeOfArgument());
  if (const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(e)) {
    if (const auto *constant = llvm::dyn_cast<c::EnumConstantDecl>(ref->getDecl())) {
      llvm::SmallString<24> text;
      constant->getInitVal().toString(text, 10);
      return node(Expr::Literal, e, {}, text.str().str());
    }
    Expr *n = node(Expr::Ref, e, {});
    n->var = reference(llvm::cast<c::VarDecl>(ref->getDecl()));
    return n;
  }
  if (const auto *sub = llvm::dyn_cast<c::ArraySubscriptExpr>(e))
    return node(Expr::Index, e, {expr(sub->getBase()), expr(sub->getIdx())});
  if (const auto *member = llvm::dyn_cast<c::MemberExpr>(e)) {
    Expr *n = node(Expr::Member, e, {expr(member->getBase())}, nameOf(llvm::cast<c::FieldDecl>(member->getMemberDecl())));
    n->arrow = member->isArrow();
    return n;
  }
  if (const auto *cast = llvm::dyn_cast<c::CastExpr>(e)) return castOf(cast);
  if (const auto *op = llvm::dyn_cast<c::UnaryOperator>(e)) return unary(op);
  if (const auto *op = llvm::dyn_cast<c::CompoundAssignOperator>(e)) return compound(op);
  if (const auto *op = llvm::dyn_cast<c::BinaryOperator>(e)) {
    Expr::Kind kind = op->isAssignmentOp() ? Expr::Assign : op->getOpcode() == c::BO_Comma ? Expr::Comma : Expr::Binary;
    return node(kind, e, {expr(op->getLHS()), expr(op->getRHS())}, op->getOpcodeStr().str());
  }
  if (const auto *cond = llvm::dyn_cast<c::ConditionalOperator>(e))
    return node(Expr::Conditional, e, {expr(cond->getCond()), expr(cond->getTrueExpr()), expr(cond->getFalseExpr())});
  if (const auto *call = llvm::dyn_cast<c::CallExpr>(e)) return callOf(call);
  if (const auto *list = llvm::dyn_cast<c::InitListExpr>(e)) {
    bool braced = list->getNumInits() == 1 && !list->getType()->isArrayType() && !list->getType()->isRecordType(); // double x = {1}
    return braced ? expr(list->getInit(0)) : initList(list);
  }
  if (const auto *compound = llvm::dyn_cast<c::CompoundLiteralExpr>(e)) {
    Expr *list = initList(llvm::cast<c::InitListExpr>(compound->getInitializer()));
    list->text = "compound";
    return list;
  }
  if (llvm::isa<c::ImplicitValueInitExpr>(e)) return node(Expr::Literal, e, {}, "0");
  llvm_unreachable("an expression that Subset accepts and Lower does not know");
}

} // namespace

void lower(const Source &source, const Match &match, const std::vector<Instance> &functions, const std::string &modelName,
           Program &program, Model &model) {
  Lowering lowering(source, match, program);
  for (const Instance &f : functions) lowering.declare(f);
  for (const Instance &f : functions) lowering.define(f);
  model.name = modelName;
  model.dof = match.dof;
  if (match.params) model.params = lowering.record(match.params);
  for (const auto &r : match.recursion)
    for (const Instance &f : functions)
      if (f.function == r.first) model.recursion[lowering.functionOf(f)] = r.second;
  for (const Matched &m : match.functions)
    model.functions.push_back({m.role, lowering.functionOf(plainInstance(m.function)), m.args, m.rows});
}

} // namespace tlgen
