// What a call in the source reaches.
#include "Calls.h"

#include "clang/AST/ASTContext.h"
#include "clang/AST/Attr.h"

#include <algorithm>

namespace tlgen {
namespace {

namespace c = clang;

// The variables that a function assigns or whose address it takes, and how many it has of each name. By hand: what Clang's
// RecursiveASTVisitor brings along takes compilers longer than the rest of this file.
class Changes {
public:
  Changes(std::set<const c::VarDecl *> &changed, std::map<std::string, int> &names) : changed_(changed), names_(names) {}

  void declare(const c::VarDecl *v) {
    ++names_[v->getNameAsString()];
    walkLengths(v->getType());
  }

  void walk(const c::Stmt *s) {
    if (const auto *declaration = llvm::dyn_cast<c::DeclStmt>(s))
      for (const c::Decl *d : declaration->decls())
        if (const auto *v = llvm::dyn_cast<c::VarDecl>(d)) declare(v);
    if (const auto *op = llvm::dyn_cast<c::BinaryOperator>(s))
      if (op->isAssignmentOp()) note(op->getLHS());
    if (const auto *op = llvm::dyn_cast<c::UnaryOperator>(s))
      if (op->isIncrementDecrementOp() || op->getOpcode() == c::UO_AddrOf) note(op->getSubExpr());
    if (const auto *cast = llvm::dyn_cast<c::ExplicitCastExpr>(s)) walkLengths(cast->getTypeAsWritten());
    if (const auto *size = llvm::dyn_cast<c::UnaryExprOrTypeTraitExpr>(s)) walkLengths(size->getTypeOfArgument());
    for (const c::Stmt *part : s->children())
      if (part) walk(part);
  }

private:
  // What a type computes: the lengths of arrays.
  void walkLengths(c::QualType type) {
    while (type->isPointerType() || type->getAsArrayTypeUnsafe()) {
      const c::ArrayType *array = type->getAsArrayTypeUnsafe();
      const auto *variable = llvm::dyn_cast_or_null<c::VariableArrayType>(array);
      if (variable && variable->getSizeExpr()) walk(variable->getSizeExpr());
      type = array ? array->getElementType() : type->getPointeeType();
    }
  }

  void note(const c::Expr *e) {
    if (const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(e->IgnoreParens()))
      if (const auto *v = llvm::dyn_cast<c::VarDecl>(ref->getDecl())) changed_.insert(v);
  }

  std::set<const c::VarDecl *> &changed_;
  std::map<std::string, int> &names_;
};

const c::Expr *bare(const c::Expr *e) {
  for (;;) {
    e = e->IgnoreParens();
    if (const auto *constant = llvm::dyn_cast<c::ConstantExpr>(e)) {
      e = constant->getSubExpr();
      continue;
    }
    const auto *cast = llvm::dyn_cast<c::CastExpr>(e);
    bool same = cast && (cast->getCastKind() == c::CK_LValueToRValue || cast->getCastKind() == c::CK_NoOp ||
                         cast->getCastKind() == c::CK_FunctionToPointerDecay || cast->getCastKind() == c::CK_ArrayToPointerDecay ||
                         cast->getCastKind() == c::CK_BuiltinFnToFnPtr);
    if (!same) return e;
    e = cast->getSubExpr();
  }
}

// The item of an initialiser list, null where it is left out.
const c::Expr *item(const c::Expr *list, unsigned i) {
  const auto *items = llvm::dyn_cast<c::InitListExpr>(bare(list));
  if (!items) return nullptr;
  if (const c::InitListExpr *meaning = items->getSemanticForm()) items = meaning;
  return i < items->getNumInits() && !llvm::isa<c::ImplicitValueInitExpr>(items->getInit(i)) ? items->getInit(i) : nullptr;
}

// The type of the numbers or structs that an object or array of them consists of.
c::QualType numbersOf(c::QualType type) {
  while (const auto *array = type->getAsArrayTypeUnsafe()) type = array->getElementType();
  return type.getCanonicalType().getUnqualifiedType();
}

// What stands behind a pointer before it became a void pointer.
const c::Expr *withoutVoid(const c::Expr *pointer) {
  while (const auto *cast = llvm::dyn_cast<c::CastExpr>(pointer->IgnoreParens())) {
    bool toVoid = cast->getCastKind() == c::CK_BitCast && cast->getType()->isVoidPointerType();
    if (!toVoid && cast->getCastKind() != c::CK_NoOp) break;
    pointer = cast->getSubExpr();
  }
  return pointer->IgnoreParens();
}

// bytes = number * factor * size of an element; false where it is nothing of the kind.
bool countElements(const c::Expr *bytes, const c::ASTContext &context, int64_t size, BulkCopy &copy) {
  bytes = bytes->IgnoreParenImpCasts();
  c::Expr::EvalResult value;
  if (bytes->EvaluateAsInt(value, context)) {
    int64_t n = value.Val.getInt().getExtValue();
    copy.number = static_cast<long>(n / size);
    return n >= 0 && n % size == 0;
  }
  if (const auto *whole = llvm::dyn_cast<c::UnaryExprOrTypeTraitExpr>(bytes)) {
    copy.factor = bytes;
    copy.number = 1;
    copy.bytes = static_cast<long>(size);
    return whole->getKind() == c::UETT_SizeOf;
  }
  const auto *product = llvm::dyn_cast<c::BinaryOperator>(bytes);
  if (!product || product->getOpcode() != c::BO_Mul) return false;
  for (const c::Expr *side : {product->getLHS(), product->getRHS()})
    if (side->EvaluateAsInt(value, context) && value.Val.getInt().getExtValue() > 0 && value.Val.getInt().getExtValue() % size == 0) {
      copy.number = static_cast<long>(value.Val.getInt().getExtValue() / size);
      copy.factor = side == product->getLHS() ? product->getRHS() : product->getLHS();
      return true;
    }
  return false;
}

std::optional<BulkCopy> bulkCopy(const c::CallExpr *call, const std::string &name) {
  const c::ASTContext &context = call->getDirectCallee()->getASTContext();
  BulkCopy copy;
  copy.overlap = name == "memmove";
  copy.to = withoutVoid(call->getArg(0));
  if (!copy.to->getType()->isPointerType()) return {};
  copy.element = numbersOf(copy.to->getType()->getPointeeType());
  if (name == "memset") {
    c::Expr::EvalResult value;
    if (!call->getArg(1)->EvaluateAsInt(value, context) || value.Val.getInt() != 0) return {};
  } else {
    copy.from = withoutVoid(call->getArg(1));
    if (!copy.from->getType()->isPointerType() || numbersOf(copy.from->getType()->getPointeeType()) != copy.element) return {};
  }
  bool whole = copy.element->isArithmeticType() || copy.element->isStructureType();
  if (!whole || copy.element->isIncompleteType() || copy.element->isAnyCharacterType()) return {};
  if (!countElements(call->getArg(2), context, context.getTypeSizeInChars(copy.element).getQuantity(), copy)) return {};
  return copy;
}

// True where the declaration is the one that the name stands for: the types of math.h, and no other name behind it.
bool isOwn(const c::FunctionDecl *callee, const MathFunction &math) {
  std::string name = callee->getNameAsString();
  if (callee->hasAttr<c::AsmLabelAttr>()) return false;
  if (name != mathName(name)) return true; // a builtin
  bool single = name != math.name,
       integers = math.name == std::string("abs") || math.name == std::string("labs") || math.name == std::string("llabs");
  auto fits = [&](c::QualType type) {
    return type->isSpecificBuiltinType(single ? c::BuiltinType::Float : c::BuiltinType::Double) || (integers && type->isIntegerType());
  };
  if (callee->getNumParams() != static_cast<unsigned>(math.arity) || callee->isVariadic()) return false;
  for (unsigned i = 0; i < callee->getNumParams(); ++i) {
    bool exponent = i == 1 && math.operation && math.operation == std::string("scalbn");
    c::QualType type = callee->getParamDecl(i)->getType();
    if (exponent ? !type->isSpecificBuiltinType(c::BuiltinType::Int) : !fits(type)) return false;
  }
  return fits(callee->getReturnType()) || (math.kind != MathFunction::Smooth && callee->getReturnType()->isIntegerType());
}

// True where a declaration has the types of the definition, by their spelling since they may be of two translation units.
bool sameTypes(const c::FunctionDecl *declared, const c::FunctionDecl *definition) {
  auto spelling = [](c::QualType type) { return type.getCanonicalType().getUnqualifiedType().getAsString(); };
  if (&declared->getASTContext() == &definition->getASTContext()) return true; // Clang has seen to it
  bool same = declared->getNumParams() == definition->getNumParams() && declared->isVariadic() == definition->isVariadic() &&
              spelling(declared->getReturnType()) == spelling(definition->getReturnType());
  for (unsigned i = 0; same && i < declared->getNumParams(); ++i)
    same = spelling(declared->getParamDecl(i)->getType()) == spelling(definition->getParamDecl(i)->getType());
  return same;
}

// A name among a few, with or without the mark of a builtin.
bool isOne(const std::string &name, std::initializer_list<const char *> names) {
  return std::any_of(names.begin(), names.end(), [&](const char *n) { return mathName(name) == n; });
}

} // namespace

std::string instanceName(const Instance &instance) {
  std::string name = instance.function->getNameAsString();
  for (const c::FunctionDecl *bound : instance.bound)
    if (bound) name += "_" + bound->getNameAsString();
  return name;
}

Calls::Calls(const Source &source, const Match &match, const Instance &caller) : source_(source), match_(match), caller_(caller) {
  Changes changes(changed_, names_);
  for (c::ParmVarDecl *param : caller.function->parameters()) changes.declare(param);
  if (caller.function->hasBody()) changes.walk(caller.function->getBody());
}

bool Calls::isNull(const c::Expr *e, const c::ASTContext &context) {
  if (!e->getType()->isPointerType()) return false;
  const auto *cast = llvm::dyn_cast<c::CastExpr>(e->IgnoreParens());
  while (cast && cast->getCastKind() == c::CK_BitCast) { // a null pointer of another type is none to Clang
    e = cast->getSubExpr();
    cast = llvm::dyn_cast<c::CastExpr>(e->IgnoreParens());
  }
  return (cast && cast->getCastKind() == c::CK_NullToPointer) ||
         e->isNullPointerConstant(const_cast<c::ASTContext &>(context), c::Expr::NPC_ValueDependentIsNotNull) != c::Expr::NPCK_NotNull;
}

// True where a variable has its first value for good.
bool Calls::keepsValue(const c::VarDecl *v) const {
  c::QualType type = v->getASTContext().getBaseElementType(v->getType());
  return v->getInit() && (type.isConstQualified() || (isFunctionPointer(v->getType()) && v->hasLocalStorage() && !changed_.count(v)));
}

// True where an expression means the same wherever it stands in the function: literals, and variables that never change nor have a
// namesake.
bool Calls::isSteady(const c::Stmt *e, bool members) const {
  if (const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(e)) {
    const auto *v = llvm::dyn_cast<c::VarDecl>(ref->getDecl());
    return !v || (v->hasLocalStorage() && !changed_.count(v) && names_.at(v->getNameAsString()) == 1);
  }
  if (llvm::isa<c::ArraySubscriptExpr>(e) || (llvm::isa<c::MemberExpr>(e) && !members) || llvm::isa<c::CallExpr>(e)) return false;
  if (const auto *op = llvm::dyn_cast<c::UnaryOperator>(e))
    if (op->getOpcode() == c::UO_Deref) return false;
  return std::all_of(e->child_begin(), e->child_end(), [&](const c::Stmt *part) { return !part || isSteady(part, members); });
}

// The initialisers of what an lvalue may name.
Calls::Settled Calls::objects(const c::Expr *lvalue) const {
  Settled s;
  const c::Expr *e = bare(lvalue);
  if (const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(e)) {
    const auto *v = llvm::dyn_cast<c::VarDecl>(ref->getDecl());
    if (const c::VarDecl *def = v ? v->getInitializingDeclaration() : nullptr)
      if (keepsValue(def)) {
        bool copied = def->getType()->isRecordType() && !llvm::isa<c::InitListExpr>(bare(def->getInit()));
        s = copied ? objects(def->getInit()) : Settled{nullptr, false, {def->getInit()}};
        if (s.choice && !isSteady(s.choice)) return {};
      }
  } else if (const auto *member = llvm::dyn_cast<c::MemberExpr>(e)) {
    const auto *field = llvm::dyn_cast<c::FieldDecl>(member->getMemberDecl());
    if (!field || member->isArrow()) return {};
    s = objects(member->getBase());
    for (const c::Expr *&value : s.values) value = item(value, field->getFieldIndex());
  } else if (const auto *sub = llvm::dyn_cast<c::ArraySubscriptExpr>(e)) {
    s = objects(sub->getBase());
    c::Expr::EvalResult index;
    if (sub->getIdx()->EvaluateAsInt(index, caller_.function->getASTContext())) {
      for (const c::Expr *&value : s.values) value = item(value, static_cast<unsigned>(index.Val.getInt().getExtValue()));
    } else if (s.values.size() == 1 && !s.choice && !sub->getIdx()->HasSideEffects(caller_.function->getASTContext())) {
      const auto *list = llvm::dyn_cast<c::InitListExpr>(bare(s.values[0]));
      s.values.clear();
      s.choice = sub->getIdx();
      for (unsigned i = 0; list && i < list->getNumInits(); ++i) s.values.push_back(item(list, i));
    } else {
      return {};
    }
  }
  if (std::find(s.values.begin(), s.values.end(), nullptr) != s.values.end()) return {};
  return s;
}

Calls::Settled Calls::settle(const c::Expr *e) const {
  e = bare(e);
  if (const auto *op = llvm::dyn_cast<c::UnaryOperator>(e))
    return op->getOpcode() == c::UO_AddrOf || op->getOpcode() == c::UO_Deref ? settle(op->getSubExpr()) : Settled{};
  if (const auto *choice = llvm::dyn_cast<c::ConditionalOperator>(e)) {
    Settled s;
    if (choice->getCond()->HasSideEffects(caller_.function->getASTContext())) return s;
    s.choice = choice->getCond();
    s.isCondition = true;
    s.values = {choice->getTrueExpr(), choice->getFalseExpr()};
    return s;
  }
  if (const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(e))
    if (llvm::isa<c::FunctionDecl>(ref->getDecl()) || llvm::isa<c::ParmVarDecl>(ref->getDecl())) return {nullptr, false, {e}};
  Settled s = objects(e);
  if (s.values.size() != 1 || s.choice) return s;
  Settled behind = settle(s.values[0]);
  return behind.choice && !isSteady(behind.choice) ? Settled{} : behind;
}

// The one function that an expression is; null where there is none.
const c::FunctionDecl *Calls::function(const c::Expr *e) const {
  const auto *ref = llvm::dyn_cast<c::DeclRefExpr>(bare(e));
  if (const auto *f = ref ? llvm::dyn_cast<c::FunctionDecl>(ref->getDecl()) : nullptr) return f;
  if (const auto *param = ref ? llvm::dyn_cast<c::ParmVarDecl>(ref->getDecl()) : nullptr) {
    bool own = !changed_.count(param) && param->getDeclContext() == caller_.function;
    return own && !caller_.bound.empty() ? caller_.bound[param->getFunctionScopeIndex()] : nullptr;
  }
  Settled s = settle(e);
  return s.values.size() == 1 && !s.choice && bare(s.values[0]) != bare(e) ? function(s.values[0]) : nullptr;
}

Reach Calls::reachFunction(const c::FunctionDecl *callee, const c::CallExpr *call) const {
  Reach r;
  r.callee = callee;
  r.rule = ruleOf(callee, match_);
  std::string name = callee->getNameAsString();
  const c::FunctionDecl *definition = source_.definition(callee);
  const MathFunction *math = findMath(name);
  const c::SourceManager &sm = callee->getASTContext().getSourceManager();
  std::string file = sm.getFilename(sm.getSpellingLoc(callee->getLocation())).str(), generic = "/tgmath.h";
  if (file.size() > generic.size() && file.compare(file.size() - generic.size(), generic.size(), generic) == 0)
    return r.kind = Reach::Generic, r;
  bool copies = isOne(name, {"memcpy", "memmove", "memset"}), builtin = name != mathName(name);
  if (!r.rule.empty())
    r.kind = Reach::Rule;
  else if (!definition && math && isOwn(callee, *math))
    r.kind = Reach::Math;
  else if (builtin && isOne(name, {"expect", "expect_with_probability"}))
    r.kind = Reach::Same;
  else if (builtin && isOne(name, {"unreachable"}))
    r.kind = Reach::Nothing;
  else if (builtin && isOne(name, {"nan", "nanf", "inf", "inff", "huge_val", "huge_valf"}))
    r.kind = Reach::NotFinite;
  else if (!definition && copies && call->getNumArgs() == 3)
    r.kind = Reach::Copy, r.copy = bulkCopy(call, mathName(name));
  else if (!definition)
    r.kind = Reach::NoBody;
  else {
    if (!sameTypes(callee, definition)) return r.kind = Reach::OtherTypes, r;
    Instance instance{definition, {}};
    if (call->getNumArgs() != definition->getNumParams() && !definition->isVariadic())
      r.kind = Reach::NoBody; // not the one declared here
    if (r.kind == Reach::NoBody) return r;
    for (unsigned i = 0; i < definition->getNumParams(); ++i) {
      bool isFunction = isFunctionPointer(definition->getParamDecl(i)->getType());
      const c::FunctionDecl *bound = isFunction && i < call->getNumArgs() ? function(call->getArg(i)) : nullptr;
      if (isFunction && !bound) return {};
      instance.bound.push_back(bound);
    }
    r.kind = Reach::Function;
    r.instance = instance;
  }
  return r;
}

Reach Calls::reach(const c::CallExpr *call) const {
  Settled s = settle(call->getCallee());
  if (s.values.size() == 1 && !s.choice) {
    const c::FunctionDecl *callee = function(s.values[0]);
    return callee ? reachFunction(callee, call) : Reach{};
  }
  Reach all;
  for (const c::Expr *value : s.values) {
    const c::FunctionDecl *callee = function(value);
    Reach one = callee ? reachFunction(callee, call) : Reach{};
    bool fits = one.kind == Reach::Function || one.kind == Reach::Math || one.kind == Reach::Rule;
    if (!fits) return one.kind == Reach::NoBody ? one : Reach{};
    all.kind = Reach::Choice;
    all.options.push_back(one);
  }
  all.choice = s.choice;
  all.choiceIsCondition = s.isCondition;
  return all;
}

} // namespace tlgen
