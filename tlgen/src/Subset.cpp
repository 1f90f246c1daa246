// Refuses what tlgen does not accept. A white list: a construct that no line here names is refused.
#include "Subset.h"

#include "clang/AST/ASTContext.h"
#include "clang/AST/Attr.h"
#include "clang/AST/RecursiveASTVisitor.h"
#include "clang/Lex/Lexer.h"

#include <set>

namespace tlgen {
namespace {

using namespace clang;
using clang::Expr; // not the intermediate program's
using clang::Stmt;

// The attribute of a declaration that may change what it means; null where there is none.
const Attr *otherMeaning(const Decl *decl) {
  static const std::set<std::string> harmless = {"unused",
                                                 "maybe_unused",
                                                 "used",
                                                 "always_inline",
                                                 "noinline",
                                                 "const",
                                                 "pure",
                                                 "hot",
                                                 "cold",
                                                 "nonnull",
                                                 "nothrow",
                                                 "deprecated",
                                                 "annotate",
                                                 "gnu_inline",
                                                 "leaf",
                                                 "malloc",
                                                 "flatten",
                                                 "artificial",
                                                 "section",
                                                 "visibility",
                                                 "noreturn",
                                                 "_Noreturn",
                                                 "minsize",
                                                 "optnone",
                                                 "no_sanitize",
                                                 "target",
                                                 "warn_unused_result",
                                                 "returns_nonnull",
                                                 "nodiscard",
                                                 "noclone"};
  for (const Attr *a : decl->attrs()) {
    bool packing = isa<MaxFieldAlignmentAttr>(a);
    if ((packing || !a->isImplicit()) && !isa<AsmLabelAttr>(a) && !harmless.count(a->getSpelling())) return a;
  }
  return nullptr;
}

// See refusedType: behind a pointer, and which structs are being looked at.
const char *refused(QualType type, bool behind, std::set<const RecordDecl *> &seen) {
  if (type.isVolatileQualified()) return "volatile";
  if (type->isAtomicType()) return "atomic";
  if (type->isAnyComplexType()) return "complex";
  if (type->isSpecificBuiltinType(BuiltinType::LongDouble)) return "long-double";
  if (type->isFunctionPointerType()) return nullptr; // what is done with it decides
  if (const auto *array = type->getAsArrayTypeUnsafe())
    return isa<ConstantArrayType>(array) || isa<VariableArrayType>(array) ? refused(array->getElementType(), behind, seen) : "type";
  if (type->isPointerType()) return type->getPointeeType()->isVoidType() ? "type" : refused(type->getPointeeType(), true, seen);
  if (type->isUnionType()) return "union";
  if (const auto *record = type->getAs<RecordType>()) {
    const RecordDecl *def = record->getDecl()->getDefinition();
    if (!def || def->field_empty()) return "type";
    if (!seen.insert(def).second) return nullptr;
    if (otherMeaning(def)) return "attribute";
    for (const FieldDecl *field : def->fields()) {
      if (field->isBitField()) return "type";
      if (otherMeaning(field)) return "attribute";
      QualType t = field->getType();
      const ASTContext &context = def->getASTContext();
      if (!t->isIncompleteType() && context.getTypeAlign(t) != context.getTypeAlign(t.getCanonicalType())) return "attribute";
      const char *id = refused(t, behind, seen);
      bool bytes = behind && t->isConstantSizeType() && !t->isIncompleteType(); // it can stay, untouched
      if (id && !bytes) return id;
    }
    return nullptr;
  }
  if (type->isSpecificBuiltinType(BuiltinType::Double) || type->isSpecificBuiltinType(BuiltinType::Float)) return nullptr;
  if (type->isIntegralOrEnumerationType() && !type->isBitIntType()) return nullptr;
  return "type";
}

bool holdsPointer(QualType type) {
  if (const auto *array = type->getAsArrayTypeUnsafe()) return holdsPointer(array->getElementType());
  const auto *record = type->getAs<RecordType>();
  if (!record || !record->getDecl()->getDefinition()) return type->isPointerType();
  for (const FieldDecl *field : record->getDecl()->getDefinition()->fields())
    if (holdsPointer(field->getType())) return true;
  return false;
}

class Walker : public RecursiveASTVisitor<Walker> {
public:
  Walker(const Source &source, const Match &match, const Instance &instance, std::set<Instance> &callees)
      : source_(source), context_(instance.function->getASTContext()), calls_(source, match, instance), callees_(callees) {}

  // Only what a list means, not how it was written: designators are resolved.
  bool TraverseInitListExpr(InitListExpr *list, DataRecursionQueue * = nullptr) {
    if (InitListExpr *meaning = list->getSemanticForm()) list = meaning;
    VisitStmt(list);
    for (Expr *item : list->inits())
      if (item) TraverseStmt(item);
    return true;
  }

  bool TraverseStaticAssertDecl(StaticAssertDecl *) { return true; } // Clang has seen to it

  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *e, DataRecursionQueue * = nullptr) {
    if (isAssert(e) && e->getArgumentExpr()->HasSideEffects(context_))
      report("assert-effect", e->getBeginLoc(), "'" + spelling(e) + "'");
    return VisitStmt(e);
  } // nobody evaluates it

  // What an assembler would read is nothing to look at.
  bool TraverseGCCAsmStmt(GCCAsmStmt *s, DataRecursionQueue * = nullptr) { return VisitStmt(s); }

  // Of a copy of whole objects, the pointers as they were before they lost their types.
  bool TraverseCallExpr(CallExpr *call, DataRecursionQueue * = nullptr) {
    Reach reach = calls_.reach(call);
    if (reach.kind == Reach::NotFinite || reach.kind == Reach::Generic) return VisitCallExpr(call);
    if (reach.kind != Reach::Copy) return RecursiveASTVisitor::TraverseCallExpr(call);
    if (!statements_.count(call)) report("unsupported", call->getBeginLoc(), "the value of '" + spelling(call) + "'");
    if (!reach.copy) report("bulk-copy", call->getBeginLoc(), "'" + spelling(call) + "'");
    if (!reach.copy) return true;
    for (const Expr *part : {reach.copy->to, reach.copy->from, reach.copy->factor})
      if (part) TraverseStmt(const_cast<Expr *>(part));
    return true;
  }

  // Which cases stand in their switch's own block, and which gotos go forward to a block they are in: before anything is visited.
  bool TraverseCompoundStmt(CompoundStmt *block) {
    blocks_.push_back(block);
    for (const Stmt *part : block->body()) noteStatement(part);
    bool good = RecursiveASTVisitor::TraverseCompoundStmt(block);
    blocks_.pop_back();
    return good;
  }

  bool VisitSwitchStmt(SwitchStmt *s) {
    if (const auto *body = dyn_cast<CompoundStmt>(s->getBody()))
      for (const Stmt *part : body->body())
        for (const auto *choice = dyn_cast<SwitchCase>(part); choice; choice = dyn_cast<SwitchCase>(choice->getSubStmt()))
          if (!isa<CaseStmt>(choice) || !cast<CaseStmt>(choice)->getRHS()) cases_.insert(choice);
    return true;
  }

  bool VisitStmt(Stmt *s) {
    noteParts(s);
    if (auto *jump = dyn_cast<GotoStmt>(s)) checkJump(jump);
    if (const char *id = refusedStmt(s)) report(id, s->getBeginLoc(), std::string("'") + spelling(s) + "'");
    return true;
  }

  bool VisitVarDecl(VarDecl *v) {
    std::string name = "'" + v->getNameAsString() + "'";
    if (const char *id = refusedType(v->getType()))
      report(id, v->getLocation(), name + " of type '" + v->getType().getAsString() + "'");
    if (const Attr *a = otherMeaning(v)) report("attribute", v->getLocation(), std::string("'") + a->getSpelling() + "' of " + name);
    for (QualType t = v->getType(); const auto *array = context_.getAsVariableArrayType(t); t = array->getElementType())
      if (!calls_.isSteady(array->getSizeExpr(), true)) report("vla", v->getLocation(), name);
    if (v->isStaticLocal() && !deepConst(v->getType())) report("global-state", v->getLocation(), "static variable " + name);
    if (v->hasExternalStorage()) report("global-state", v->getLocation(), "extern variable " + name);
    if (v->getInit() && holdsFunction(v->getType())) settled(v->getInit());
    if (v->getInit()) noteString(v->getInit());
    return true;
  }

  bool VisitMemberExpr(MemberExpr *e) {
    const auto *field = dyn_cast<FieldDecl>(e->getMemberDecl());
    if (const char *id = field ? refusedMember(field) : "type")
      report(id, e->getMemberLoc(), "member '" + e->getMemberDecl()->getNameAsString() + "'");
    return true;
  }

  bool VisitDeclRefExpr(DeclRefExpr *ref) {
    if (auto *v = dyn_cast<VarDecl>(ref->getDecl())) {
      if (v->hasGlobalStorage() && !v->isStaticLocal()) checkGlobal(v, ref->getLocation());
    }
    QualType type = ref->getType();
    while (const auto *array = type->getAsArrayTypeUnsafe()) type = array->getElementType();
    bool function = isa<FunctionDecl>(ref->getDecl()) || Calls::isFunctionPointer(type);
    if (function && !settled_.count(ref)) report("function-pointer", ref->getLocation(), "'" + ref->getDecl()->getNameAsString() + "'");
    return true;
  }

  bool VisitCallExpr(CallExpr *call) {
    Reach reach = calls_.reach(call);
    settled(call->getCallee());
    for (const Expr *arg : call->arguments())
      if (Calls::isFunctionPointer(arg->getType())) settled(arg);
    std::string name = reach.callee ? "'" + reach.callee->getNameAsString() + "'" : "'" + spelling(call) + "'";
    switch (reach.kind) {
    case Reach::Math:
      break;
    case Reach::Rule:
      checkExternal(reach.callee, call);
      break;
    case Reach::Copy: // see TraverseCallExpr
      break;
    case Reach::Choice:
      if (call->getType()->isVoidType() && !statements_.count(call)) report("unsupported", call->getBeginLoc(), name);
      for (const Reach &option : reach.options) {
        if (option.kind == Reach::Function) callees_.insert(option.instance);
        if (option.kind == Reach::Rule) checkExternal(option.callee, call);
      }
      break;
    case Reach::Function:
      callees_.insert(reach.instance);
      break;
    case Reach::Same:
    case Reach::Nothing:
      break;
    case Reach::OtherTypes:
      report("declaration-differs", call->getBeginLoc(), name);
      break;
    case Reach::Generic:
      report("tgmath", call->getBeginLoc(), "'" + spelling(call) + "'");
      break;
    case Reach::NotFinite:
      report("not-finite", call->getBeginLoc(), name);
      break;
    case Reach::NoBody:
      report("unknown-function", call->getBeginLoc(), name);
      break;
    case Reach::Unsettled:
      report("function-pointer", call->getBeginLoc(), name);
    }
    return true;
  }

private:
  // What Frontend makes of assert(condition).
  bool isAssert(const UnaryExprOrTypeTraitExpr *e) const {
    if (e->isArgumentType() || !e->getBeginLoc().isMacroID()) return false;
    return Lexer::getImmediateMacroName(e->getBeginLoc(), context_.getSourceManager(), context_.getLangOpts()) == "assert";
  }

  // The functions named in an expression are known where it is used.
  void settled(const Expr *e) {
    if (const auto *ref = dyn_cast<DeclRefExpr>(e)) settled_.insert(ref);
    for (const Stmt *part : e->children())
      if (part && isa<Expr>(part)) settled(cast<Expr>(part));
  }

  static bool holdsFunction(QualType type) {
    if (const auto *array = type->getAsArrayTypeUnsafe()) return holdsFunction(array->getElementType());
    if (Calls::isFunctionPointer(type)) return true;
    const auto *record = type->getAs<RecordType>();
    const RecordDecl *def = record ? record->getDecl()->getDefinition() : nullptr;
    return def && std::any_of(def->field_begin(), def->field_end(), [](const FieldDecl *f) { return holdsFunction(f->getType()); });
  }

  // A string that initialises an array is a list of its characters; one that a table points to is a name.
  void noteString(const Expr *init) {
    if (const auto *text = dyn_cast<StringLiteral>(init->IgnoreParenImpCasts())) strings_.insert(text);
    const auto *list = dyn_cast<InitListExpr>(init);
    if (list && list->getSemanticForm()) list = list->getSemanticForm();
    for (unsigned i = 0; list && i < list->getNumInits(); ++i)
      if (list->getInit(i)) noteString(list->getInit(i));
  }

  // An external function with a rule computes a number from numbers.
  void checkExternal(const FunctionDecl *f, const CallExpr *call) {
    auto isDouble = [](QualType type) { return type->isSpecificBuiltinType(BuiltinType::Double); };
    bool fits = isDouble(f->getReturnType()) && f->getNumParams() >= 1 && f->getNumParams() <= maxRuleArguments;
    for (const ParmVarDecl *param : f->parameters()) fits &= isDouble(param->getType());
    if (!fits) report("rule-type", call->getBeginLoc(), "'" + f->getNameAsString() + "'");
  }

  // Expressions that stand as statements: nobody takes their value.
  void noteStatement(const Stmt *s) {
    while (s && (isa<LabelStmt>(s) || isa<SwitchCase>(s) || isa<AttributedStmt>(s)))
      s = isa<LabelStmt>(s)    ? cast<LabelStmt>(s)->getSubStmt()
          : isa<SwitchCase>(s) ? cast<SwitchCase>(s)->getSubStmt()
                               : cast<AttributedStmt>(s)->getSubStmt();
    const auto *e = dyn_cast_or_null<Expr>(s);
    if (!e) return;
    const auto *cast = dyn_cast<CStyleCastExpr>(e->IgnoreParens());
    if (cast && cast->getType()->isVoidType()) e = cast->getSubExpr();
    if (const auto *call = dyn_cast<CallExpr>(e->IgnoreParenImpCasts())) statements_.insert(call);
  }

  void noteParts(const Stmt *s) {
    if (const auto *branch = dyn_cast<IfStmt>(s)) noteStatement(branch->getThen()), noteStatement(branch->getElse());
    if (const auto *loop = dyn_cast<ForStmt>(s)) noteStatement(loop->getBody());
    if (const auto *loop = dyn_cast<WhileStmt>(s)) noteStatement(loop->getBody());
    if (const auto *loop = dyn_cast<DoStmt>(s)) noteStatement(loop->getBody());
  }

  // The id of the message that refuses a statement or expression; null where it is accepted.
  const char *refusedStmt(const Stmt *s) const {
    if (const auto *number = dyn_cast<FloatingLiteral>(s))
      if (!number->getValue().isFinite()) return "not-finite";
    if (isa<IndirectGotoStmt>(s) || isa<AddrLabelExpr>(s)) return "goto";
    if (const auto *jump = dyn_cast<GotoStmt>(s)) return jumps_.count(jump) ? nullptr : "goto";
    if (const auto *choice = dyn_cast<SwitchCase>(s)) return cases_.count(choice) ? nullptr : "switch";
    if (const auto *choice = dyn_cast<SwitchStmt>(s)) return isa<CompoundStmt>(choice->getBody()) ? nullptr : "switch";
    if (isa<LabelStmt>(s) || isa<AttributedStmt>(s)) return nullptr; // hints to an optimiser
    if (isa<StringLiteral>(s) && strings_.count(s)) return nullptr;
    if (isa<AsmStmt>(s)) return "asm";
    if (isa<VAArgExpr>(s)) return "variadic";
    if (isa<CompoundStmt>(s) || isa<DeclStmt>(s) || isa<IfStmt>(s) || isa<ForStmt>(s) || isa<WhileStmt>(s) || isa<DoStmt>(s) ||
        isa<BreakStmt>(s) || isa<ContinueStmt>(s) || isa<ReturnStmt>(s) || isa<NullStmt>(s))
      return nullptr;
    if (isa<CastExpr>(s)) return Calls::isNull(cast<CastExpr>(s), context_) ? nullptr : refusedCast(cast<CastExpr>(s));
    if (const auto *op = dyn_cast<UnaryOperator>(s)) return refusedUnary(op);
    if (const auto *size = dyn_cast<UnaryExprOrTypeTraitExpr>(s))
      for (QualType t = size->getTypeOfArgument(); const auto *array = context_.getAsVariableArrayType(t); t = array->getElementType())
        if (!calls_.isSteady(array->getSizeExpr(), true)) return "vla"; // its length of then
    if (isa<IntegerLiteral>(s) || isa<FloatingLiteral>(s) || isa<CharacterLiteral>(s) || isa<ParenExpr>(s) || isa<DeclRefExpr>(s) ||
        isa<ArraySubscriptExpr>(s) || isa<MemberExpr>(s) || isa<BinaryOperator>(s) || isa<ConditionalOperator>(s) || isa<CallExpr>(s) ||
        isa<InitListExpr>(s) || isa<ImplicitValueInitExpr>(s) || isa<UnaryExprOrTypeTraitExpr>(s) || isa<ConstantExpr>(s) ||
        isa<CompoundLiteralExpr>(s))
      return isa<Expr>(s) ? refusedValue(cast<Expr>(s)) : nullptr;
    return "unsupported";
  }

  // A goto is a way out where its label stands later, directly in a block that the goto is in.
  void checkJump(const GotoStmt *jump) {
    const SourceManager &sm = context_.getSourceManager();
    const LabelStmt *label = jump->getLabel()->getStmt();
    bool forward = label && sm.isBeforeInTranslationUnit(jump->getGotoLoc(), label->getIdentLoc());
    for (const CompoundStmt *block : blocks_)
      for (const Stmt *part : block->body())
        for (const auto *l = dyn_cast<LabelStmt>(part); l; l = dyn_cast<LabelStmt>(l->getSubStmt()))
          if (l == label && forward) jumps_.insert(jump);
  }

  static const char *refusedValue(const Expr *e) {
    if (e->getType()->isSpecificBuiltinType(BuiltinType::LongDouble)) return "long-double";
    if (e->getType()->isAnyComplexType()) return "complex";
    return nullptr;
  }

  static bool pointsToVolatile(QualType type) {
    for (; type->isPointerType(); type = type->getPointeeType())
      if (type->getPointeeType().isVolatileQualified()) return true;
    return false;
  }

  static const char *refusedCast(const CastExpr *c) {
    if (isa<CStyleCastExpr>(c) && pointsToVolatile(c->getType())) return "volatile";
    switch (c->getCastKind()) {
    case CK_LValueToRValue:
    case CK_NoOp:
    case CK_ArrayToPointerDecay:
    case CK_FunctionToPointerDecay:
    case CK_IntegralCast:
    case CK_IntegralToFloating:
    case CK_FloatingCast:
    case CK_FloatingToIntegral:
    case CK_IntegralToBoolean:
    case CK_FloatingToBoolean:
    case CK_ToVoid:
    case CK_BuiltinFnToFnPtr:
    case CK_NullToPointer:
    case CK_PointerToBoolean:
      return refusedValue(c);
    case CK_BitCast:
      return sameNumbers(c->getType(), c->getSubExpr()->getType()) ? nullptr : "pointer-cast";
    case CK_IntegralToPointer:
    case CK_PointerToIntegral:
      return "pointer-cast";
    default:
      return "unsupported";
    }
  }

  // Pointers to the same type but for const, or to the same kind of number, whatever the shape of the arrays between: the layout of
  // jets is the same.
  static bool sameNumbers(QualType a, QualType b) {
    auto pointee = [](QualType t) { return t->isPointerType() ? t->getPointeeType() : t; };
    auto number = [&](QualType pointer) {
      QualType t = pointee(pointer);
      while (const auto *array = t->getAsArrayTypeUnsafe()) t = array->getElementType();
      return t.getCanonicalType().getUnqualifiedType();
    };
    if (number(a) != number(b)) return false;
    bool same = pointee(a).getCanonicalType().getUnqualifiedType() == pointee(b).getCanonicalType().getUnqualifiedType();
    return number(a)->isArithmeticType() || (same && number(a)->isRecordType());
  }

  static const char *refusedUnary(const UnaryOperator *op) {
    switch (op->getOpcode()) {
    case UO_Real:
    case UO_Imag:
      return "complex";
    case UO_Extension:
    case UO_Coawait:
      return "unsupported";
    default:
      return refusedValue(op);
    }
  }

  // const all the way down: no pointer to something that could be written.
  bool deepConst(QualType type) const {
    type = context_.getBaseElementType(type);
    bool fixed = !type->isPointerType() || Calls::isFunctionPointer(type) || deepConst(type->getPointeeType());
    return type.isConstQualified() && fixed;
  }

  void checkGlobal(const VarDecl *v, SourceLocation at) {
    std::string name = "'" + v->getNameAsString() + "'";
    if (!deepConst(v->getType())) return report("global-state", at, "global variable " + name);
    const VarDecl *def = source_.definition(v);
    if (!def || !def->getInit()) return report("global-state", at, "constant " + name + " without a value");
    if (const char *id = refusedType(v->getType())) return report(id, at, name);
    if (!visitedGlobals_.insert(def).second) return;
    if (holdsFunction(def->getType())) settled(def->getInit());
    noteString(def->getInit());
    TraverseStmt(const_cast<Expr *>(def->getInit()));
  }

  std::string spelling(const Stmt *s) const {
    const SourceManager &sm = context_.getSourceManager();
    bool invalid = false;
    CharSourceRange range = CharSourceRange::getTokenRange(sm.getExpansionRange(s->getSourceRange()).getAsRange());
    std::string text = Lexer::getSourceText(range, sm, context_.getLangOpts(), &invalid).str();
    text = text.substr(0, text.find('\n'));
    if (invalid || text.empty()) return s->getStmtClassName();
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  }

  void report(const char *id, SourceLocation at, const std::string &what) { source_.report(id, context_, at, what); }

  const Source &source_;
  const ASTContext &context_;
  Calls calls_;
  std::set<Instance> &callees_;
  std::set<const DeclRefExpr *> settled_;
  std::set<const Stmt *> statements_, strings_;
  std::set<const SwitchCase *> cases_;
  std::set<const GotoStmt *> jumps_;
  std::vector<const CompoundStmt *> blocks_;
  std::set<const VarDecl *> visitedGlobals_;
};

class Subset {
public:
  Subset(const Source &source, const Match &match) : source_(source), match_(match) {}

  // Depth first, so that callees come before callers and a cycle meets itself on the stack.
  void visit(const Instance &instance) {
    const FunctionDecl *function = instance.function;
    if (done_.count(instance)) return;
    auto cycle = std::find_if(stack_.begin(), stack_.end(), [&](const Instance *f) { return !(*f < instance) && !(instance < *f); });
    if (cycle != stack_.end()) {
      bool bounded = std::any_of(cycle, stack_.end(), [&](const Instance *f) { return match_.recursion.count(f->function) > 0; });
      if (!bounded)
        source_.report("recursion", function->getASTContext(), function->getLocation(), "'" + function->getNameAsString() + "'");
      return;
    }
    stack_.push_back(&instance);
    checkSignature(function);
    std::set<Instance> callees;
    Walker walker(source_, match_, instance, callees);
    for (ParmVarDecl *param : function->parameters()) walker.VisitVarDecl(param);
    walker.TraverseStmt(function->getBody());
    std::vector<Instance> ordered(callees.begin(), callees.end());
    std::sort(ordered.begin(), ordered.end(), [](const Instance &a, const Instance &b) { return instanceName(a) < instanceName(b); });
    for (const Instance &callee : ordered) visit(callee);
    stack_.pop_back();
    done_.insert(instance);
    order.push_back(instance);
  }

  std::vector<Instance> order;

private:
  void checkSignature(const FunctionDecl *f) {
    std::string name = "'" + f->getNameAsString() + "'";
    if (const Attr *a = otherMeaning(f))
      source_.report("attribute", f->getASTContext(), f->getLocation(), std::string("'") + a->getSpelling() + "' of " + name);
    if (f->isVariadic()) source_.report("variadic", f->getASTContext(), f->getLocation(), name);
    QualType result = f->getReturnType();
    if (result->isPointerType())
      source_.report("return-pointer", f->getASTContext(), f->getLocation(), name);
    else if (!result->isVoidType() && holdsPointer(result))
      source_.report("return-pointer", f->getASTContext(), f->getLocation(), name);
    else if (!result->isVoidType())
      if (const char *id = refusedType(result))
        source_.report(id, f->getASTContext(), f->getLocation(), name + " returns '" + result.getAsString() + "'");
  }

  const Source &source_;
  const Match &match_;
  std::set<Instance> done_;
  std::vector<const Instance *> stack_;
};

} // namespace

const char *refusedType(QualType type) {
  std::set<const RecordDecl *> seen;
  return refused(type, false, seen);
}

const char *refusedMember(const FieldDecl *field) {
  std::set<const RecordDecl *> seen;
  return refused(field->getType(), field->getASTContext().getBaseElementType(field->getType())->isRecordType(), seen);
}

std::vector<Instance> checkSubset(const Source &source, const Match &match) {
  Subset subset(source, match);
  for (const Matched &m : match.functions) subset.visit(plainInstance(m.function));
  return subset.order;
}

} // namespace tlgen
