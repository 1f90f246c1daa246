// Activity by unification and a fixed point over each function.
#include "Activity.h"
#include "MathFunctions.h"
#include "PrintC.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>
#include <tuple>

namespace tlgen {

// Pointer members have places of their own; all other members share the struct's.
static bool throughField(const Type *t) {
  while (t->kind == Type::Array) t = t->element;
  return t->kind == Type::Pointer;
}

Place *find(Place *p) {
  while (p->parent) p = p->parent;
  return p;
}

bool Variant::active(const Variable *v) const {
  auto it = places.find(v);
  if (it == places.end()) return false;
  const Place *p = find(it->second);
  for (const Type *t = v->type; t->kind == Type::Pointer || t->kind == Type::Array; t = t->element) {
    if (t->kind != Type::Pointer) continue;
    if (!p->target) return false;
    p = find(p->target);
  }
  return p->active;
}

Place *Variant::place(const Expr *e) const {
  switch (e->kind) {
  case Expr::Ref: {
    auto it = places.find(e->var);
    return it == places.end() ? nullptr : find(it->second);
  }
  case Expr::Index:
  case Expr::Deref:
    return target(e->args[0]);
  case Expr::Member: {
    Place *base = e->arrow ? target(e->args[0]) : place(e->args[0]);
    if (!base || !throughField(e->type)) return base;
    auto it = base->fields.find(e->text);
    return it == base->fields.end() ? nullptr : find(it->second);
  }
  case Expr::Assign:
  case Expr::Step:
    return place(e->args[0]);
  case Expr::Comma:
    return place(e->args[1]);
  case Expr::Call: { // what it returns, for who takes an array out of a struct
    auto it = callees.find(e);
    return it == callees.end() || e->type->kind != Type::Struct ? nullptr : find(it->second->result);
  }
  case Expr::Conditional:
  case Expr::InitList: {
    auto it = literals.find(e);
    return it == literals.end() ? nullptr : find(it->second);
  }
  default:
    return nullptr;
  }
}

Place *Variant::target(const Expr *e) const {
  switch (e->kind) {
  case Expr::Decay:
  case Expr::AddressOf:
    return place(e->args[0]);
  case Expr::Binary:
    return target(e->args[e->args[0]->type->kind == Type::Pointer ? 0 : 1]);
  case Expr::Conditional: {
    Place *first = target(e->args[1]); // none for NULL
    return first ? first : target(e->args[2]);
  }
  case Expr::Comma:
    return target(e->args[1]);
  case Expr::Cast:
    return target(e->args[0]);
  default: {
    Place *p = place(e);
    return p && p->target ? find(p->target) : nullptr;
  }
  }
}

bool Variant::pointsToActive(const Expr *e) const {
  const Place *p = target(e);
  for (const Type *t = e->type->element; p && t->kind != Type::Real && t->kind != Type::Struct; t = t->element) {
    if (t->kind != Type::Pointer && t->kind != Type::Array) return false;
    if (t->kind == Type::Pointer) p = p->target ? find(p->target) : nullptr;
  }
  return p && p->active;
}

bool Variant::varied(const Expr *e) const {
  if (e->kind == Expr::InitList) {
    for (const Expr *item : e->args)
      if (item && varied(item)) return true;
    const Place *p = place(e);
    return p && p->active;
  }
  if (e->type->kind != Type::Real && e->type->kind != Type::Struct) return false;
  switch (e->kind) {
  case Expr::Literal:
    return false;
  case Expr::Call: {
    auto it = callees.find(e);
    return it != callees.end() && find(it->second->result)->active;
  }
  case Expr::Conditional:
    return varied(e->args[1]) || varied(e->args[2]);
  case Expr::Comma:
    return varied(e->args[1]);
  case Expr::MathCall:
    if (!e->rule && findMath(e->text)->kind != MathFunction::Smooth) return false;
    [[fallthrough]];
  case Expr::Unary:
  case Expr::Binary:
  case Expr::Cast:
    for (const Expr *arg : e->args)
      if (varied(arg)) return true;
    return false;
  default: {
    Place *p = place(e);
    return p ? p->active : e->kind == Expr::Member && !e->arrow && varied(e->args[0]); // a member of a temporary
  }
  }
}

// One pass over one variant.
class VariantAnalysis {
public:
  VariantAnalysis(Activity &activity, Variant &variant, bool checking) : activity_(activity), v_(variant), checking_(checking) {}

  // Spreads activity; true where anything changed.
  bool pass() {
    walk(v_.function->body);
    return changed_;
  }

  // Once nothing changes any more: faults that only show then.
  void check() {
    walk(v_.function->body);
    for (const Variable *param : v_.function->params)
      if (v_.active(param)) checkType(param->type, param->loc, "'" + param->name + "'");
    if (find(v_.result)->active) checkType(v_.function->result, v_.function->loc, "the result of '" + v_.function->name + "'");
  }

private:
  void walk(const Stmt *s) {
    if (!s) return;
    for (const Stmt *part : s->body) walk(part);
    walk(s->init);
    if (s->kind == Stmt::Declare) declare(s);
    if (s->expr) visit(s->expr);
    bool decides = s->kind == Stmt::If || s->kind == Stmt::While || s->kind == Stmt::DoWhile || s->kind == Stmt::For;
    if (checking_ && decides && s->expr) checkTruth(s->expr);
    if (s->kind == Stmt::Return && s->expr && v_.varied(s->expr)) activate(v_.result, s->loc, "the result");
    if (s->step) visit(s->step);
    walk(s->then);
    walk(s->otherwise);
  }

  void declare(const Stmt *s) {
    if (!v_.places.count(s->var)) {
      v_.places[s->var] = activity_.makePlace(s->var->type);
      for (Place *p = s->var->isStatic ? find(v_.places[s->var]) : nullptr; p; p = p->target) p->frozen = p->input = true;
    }
    if (s->var->isStatic && s->var->init) {
      prepare(s->var->init);
      give(v_.places[s->var], s->var->type, s->var->init, s->loc, "'" + s->var->name + "'");
    }
    if (checking_ && v_.active(s->var)) checkType(s->var->type, s->var->loc, "'" + s->var->name + "'");
    if (!s->expr) return;
    prepare(s->expr);
    give(v_.places[s->var], s->var->type, s->expr, s->loc, "'" + s->var->name + "'");
  }

  // The object of that type at dest receives the value of e: numbers make it active, pointers share what they point to.
  void give(Place *dest, const Type *type, const Expr *e, const Loc &loc, const std::string &what) {
    if (!e || !dest) return;
    if (e->kind == Expr::InitList && type->kind == Type::Array) {
      for (const Expr *item : e->args) give(dest, type->element, item, loc, what);
    } else if (e->kind == Expr::InitList && type->kind == Type::Struct) {
      for (size_t i = 0; i < e->args.size() && i < type->record->fields.size(); ++i) {
        const Field &field = type->record->fields[i];
        give(member(dest, field.name, field.type), field.type, e->args[i], loc, what);
      }
    } else if (e->kind == Expr::InitList && type->kind == Type::Pointer) {
      if (!e->args.empty()) give(dest, type, e->args[0], loc, what);
    } else if (type->kind == Type::Pointer) {
      unify(find(dest)->target, v_.target(e), loc);
    } else {
      if (v_.varied(e)) activate(dest, loc, what);
      if (type->kind == Type::Struct && v_.place(e)) shareMembers(find(dest), v_.place(e), type, loc);
    }
  }

  void shareMembers(Place *a, Place *b, const Type *type, const Loc &loc) {
    if (a == b) return;
    for (const Field &field : type->record->fields) {
      const Type *inner = field.type;
      while (inner->kind == Type::Array) inner = inner->element;
      if (throughField(field.type)) {
        Place *other = find(member(b, field.name, field.type))->target;
        unify(find(member(a, field.name, field.type))->target, other, loc);
      } else if (inner->kind == Type::Struct) {
        shareMembers(find(a), find(b), inner, loc);
      }
    }
  }

  // The place of a struct's member: its own for pointers, the struct's for numbers.
  Place *member(Place *base, const std::string &name, const Type *type) {
    base = find(base);
    if (!throughField(type)) return base;
    Place *&field = base->fields[name];
    if (!field) {
      field = activity_.makePlace(type);
      inherit(field, base);
    }
    return field;
  }

  // Makes the storage that an expression names known, before it is asked for.
  void prepare(const Expr *e) {
    for (const Expr *arg : e->args)
      if (arg) prepare(arg);
    if (e->kind == Expr::Ref && !v_.places.count(e->var)) v_.places[e->var] = globalPlace(e->var);
    if (e->kind == Expr::InitList && e->text == "compound" && !v_.literals.count(e)) v_.literals[e] = activity_.makePlace(e->type);
    if (e->kind == Expr::Conditional && e->type->kind == Type::Struct) {
      if (!v_.literals.count(e)) v_.literals[e] = activity_.makePlace(e->type);
      for (size_t i : {1, 2}) give(v_.literals[e], e->type, e->args[i], e->loc, "a choice");
    }
    if (e->kind == Expr::Member) {
      Place *base = e->arrow ? v_.target(e->args[0]) : v_.place(e->args[0]);
      if (base) member(base, e->text, e->type);
    }
    if (e->kind == Expr::Conditional && e->type->kind == Type::Pointer) unify(v_.target(e->args[1]), v_.target(e->args[2]), e->loc);
  }

  static void inherit(Place *field, const Place *base) {
    for (Place *p = field; p; p = p->target) p->input = base->input, p->frozen = base->frozen;
  }

  Place *globalPlace(const Variable *var) {
    Place *&p = activity_.globals_[var];
    if (p) return p;
    Place *made = p = activity_.makePlace(var->type);
    for (Place *part = made; part; part = part->target) part->input = part->frozen = true;
    if (var->init) {
      prepare(var->init);
      give(made, var->type, var->init, var->loc, "'" + var->name + "'");
    }
    return made;
  }

  void visit(const Expr *e, const Expr *parent = nullptr) {
    prepare(e);
    for (const Expr *arg : e->args)
      if (arg) visit(arg, e);
    if (e->kind == Expr::Call) call(e);
    if (e->kind == Expr::Assign) assign(e);
    if (e->kind == Expr::InitList && v_.place(e)) give(v_.place(e), e->type, e, e->loc, "a literal");
    if (e->kind == Expr::Step) write(v_.place(e->args[0]), e->loc);
    if (checking_) check(e);
    if (checking_) checkAddress(e, parent);
  }

  void assign(const Expr *e) {
    const Expr *lhs = e->args[0], *rhs = e->args[1];
    Place *p = v_.place(lhs);
    write(p, e->loc);
    if (lhs->type->kind != Type::Integer && e->text == "=")
      give(p, lhs->type, rhs, e->loc, "this");
    else if (lhs->type->kind == Type::Real && v_.varied(rhs))
      activate(p, e->loc, "this");
  }

  void write(Place *p, const Loc &loc) {
    if (!p) return;
    p = find(p);
    if (p->input) activity_.report("write-input", loc, "assignment");
    changed_ |= !p->written;
    p->written = true;
  }

  void activate(Place *p, const Loc &loc, const std::string &what) {
    p = find(p);
    if (p->active) return;
    if (p->frozen) return activity_.report("active-params", loc, what);
    p->active = true;
    changed_ = true;
  }

  void unify(Place *a, Place *b, const Loc &loc) {
    if (!a || !b) return;
    a = find(a), b = find(b);
    if (a == b) return;
    changed_ = true;
    bool mixed = (a->active && b->frozen) || (b->active && a->frozen);
    if (mixed) activity_.report("active-params", loc, "a pointer to both");
    b->parent = a;
    a->active |= b->active, a->input |= b->input, a->frozen |= b->frozen, a->written |= b->written;
    if (!a->target)
      a->target = b->target;
    else
      unify(a->target, b->target, loc);
    for (auto &field : b->fields) {
      Place *&mine = a->fields[field.first];
      if (!mine)
        mine = field.second;
      else
        unify(mine, field.second, loc);
    }
  }

  void call(const Expr *e) {
    std::string signature;
    for (const Expr *arg : e->args) {
      bool active = arg->type->kind == Type::Pointer ? v_.pointsToActive(arg) : v_.varied(arg);
      signature += active ? 'a' : 'p';
    }
    Variant *callee = activity_.variant(e->callee, signature);
    if (v_.callees[e] != callee) v_.callees[e] = callee, changed_ = true;
    std::map<Place *, Place *> met;
    for (size_t i = 0; i < e->args.size(); ++i)
      if (e->args[i]->type->kind == Type::Pointer)
        takeBack(callee->places[callee->function->params[i]]->target, v_.target(e->args[i]), e, met);
      else if (e->args[i]->type->kind == Type::Struct)
        takeBackMembers(find(callee->places[callee->function->params[i]]), v_.place(e->args[i]), e, met);
  }

  // What the callee does to the storage behind a pointer happens to the caller's; what is one place there is one here.
  void takeBack(Place *theirs, Place *ours, const Expr *e, std::map<Place *, Place *> &met) {
    if (!theirs || !ours) return;
    theirs = find(theirs), ours = find(ours);
    auto known = met.emplace(theirs, ours);
    if (!known.second) {
      unify(known.first->second, ours, e->loc);
      return;
    }
    if (theirs->written) write(ours, e->loc);
    if (theirs->active) activate(ours, e->loc, "an argument of '" + e->callee->name + "'");
    takeBack(theirs->target, reached(ours->target, theirs->target, ours), e, met);
    takeBackMembers(theirs, ours, e, met);
  }

  // A struct passed by value does not come back, but what its pointers lead to does.
  void takeBackMembers(Place *theirs, Place *ours, const Expr *e, std::map<Place *, Place *> &met) {
    if (!ours) return;
    ours = find(ours);
    for (auto &field : theirs->fields) takeBack(field.second, reached(ours->fields[field.first], field.second, ours), e, met);
  }

  // Storage of the caller's that only the callee has named so far: as constant as what leads to it.
  Place *reached(Place *&ours, const Place *theirs, const Place *from) {
    if (!ours && theirs) {
      ours = activity_.storage_.emplace_back(std::make_unique<Place>()).get();
      ours->input = from->input, ours->frozen = from->frozen;
    }
    return ours;
  }

  // An active object must have a layout of jets.
  void checkType(const Type *type, const Loc &loc, const std::string &what) {
    while (type->kind == Type::Pointer || type->kind == Type::Array) type = type->element;
    if (type->kind == Type::Struct && !allNumbers(type))
      activity_.report("struct-active", loc, what + " of type '" + type->record->spelling + "'");
  }

  // Pointers to active numbers live in variables and arrays only: what a struct keeps is not followed into calls.
  void checkKept(const Expr *e) {
    auto refuse = [&](const Expr *pointer) {
      if (pointer && pointer->type->kind == Type::Pointer && v_.pointsToActive(pointer))
        activity_.report("pointer-in-struct", pointer->loc, "a pointer kept there");
    };
    if (e->kind == Expr::InitList && e->type->kind == Type::Struct)
      for (const Expr *item : e->args) refuse(item);
    if (e->kind == Expr::Assign && e->args[0]->kind == Expr::Member) refuse(e->args[1]);
    if (e->kind == Expr::Member) refuse(e);
  }

  // The integers of a struct with active numbers are jets as well: only the struct itself leads to them.
  void checkAddress(const Expr *e, const Expr *parent) {
    bool address = e->kind == Expr::Decay || e->kind == Expr::AddressOf;
    const Type *type = address ? e->args[0]->type : nullptr;
    while (type && type->kind == Type::Array) type = type->element;
    if (!address || type->kind != Type::Integer || (parent && (parent->kind == Expr::Index || parent->kind == Expr::Deref))) return;
    Place *p = v_.place(e->args[0]);
    if (p && p->active) activity_.report("struct-active", e->loc, "the address of an integer in it");
  }

  // What only shows once the fixed point is reached.
  void check(const Expr *e) {
    checkKept(e);
    bool follows = e->kind == Expr::Index || e->kind == Expr::Deref || (e->kind == Expr::Member && e->arrow);
    if (follows && !v_.target(e->args[0])) activity_.report("unsupported", e->loc, "a pointer to nothing");
    bool toInteger = e->kind == Expr::Cast && e->type->kind == Type::Integer && e->type->name != "_Bool";
    if (toInteger && v_.varied(e->args[0])) activity_.report("active-integer", e->loc, "conversion to '" + e->type->name + "'");
    bool compound = e->kind == Expr::Assign && e->args[0]->type->kind == Type::Integer && v_.varied(e->args[1]);
    if (compound) activity_.report("active-integer", e->loc, "assignment to '" + e->args[0]->type->name + "'");
    if (e->kind == Expr::MathCall && !e->rule) checkMath(e);
    bool equality = e->kind == Expr::Binary && (e->text == "==" || e->text == "!=");
    if (equality && (v_.varied(e->args[0]) || v_.varied(e->args[1]))) activity_.report("active-equality", e->loc, "'" + e->text + "'");
    bool logical = e->kind == Expr::Binary && (e->text == "&&" || e->text == "||");
    if (logical || e->kind == Expr::Conditional || (e->kind == Expr::Unary && e->text == "!")) checkTruth(e->args[0]);
    if (logical) checkTruth(e->args[1]);
    if (e->kind == Expr::Cast && e->type->name == "_Bool") checkTruth(e->args[0]);
  }

  // A number as a condition is compared with zero.
  void checkTruth(const Expr *e) {
    if (e->type->kind == Type::Real && v_.varied(e)) activity_.report("active-equality", e->loc, "a number as a condition");
  }

  // Functions that are constant between jumps, and those without a derivative that anyone would want.
  void checkMath(const Expr *e) {
    bool active = std::any_of(e->args.begin(), e->args.end(), [&](const Expr *arg) { return v_.varied(arg); });
    MathFunction::Kind kind = findMath(e->text)->kind;
    if (active && kind == MathFunction::Step) activity_.report("zero-derivative", e->loc, "'" + e->text + "'");
    if (active && kind == MathFunction::Opaque) activity_.report("unknown-function", e->loc, "'" + e->text + "'");
  }

  Activity &activity_;
  Variant &v_;
  bool changed_ = false, checking_;
};

Activity::Activity(const Program &program, const Model &model, Diagnostics &diags) : program_(program), diags_(diags) {
  for (const ModelFunction &f : model.functions) {
    std::string signature;
    for (const Arg &arg : f.args) {
      bool array = (arg.role == ArgRole::Q || arg.role == ArgRole::Qd) && arg.index < 0;
      signature += arg.role == ArgRole::Params ? 'c' : array ? 'i' : 'a';
    }
    roots_.push_back(variant(f.function, signature));
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < owned_.size(); ++i)
      changed |= VariantAnalysis(*this, *owned_[i], false).pass(); // new variants join at the end
  }
  std::set<const Variant *> seen;
  std::function<void(Variant *)> list = [&](Variant *v) {
    if (!seen.insert(v).second) return;
    std::map<std::tuple<std::string, std::string, int, unsigned>, Variant *> callees; // by name and place: addresses give no order
    for (auto &c : v->callees) {
      const Function &f = *c.second->function;
      callees[{f.name, c.second->signature, f.loc.file, f.loc.line}] = c.second;
    }
    for (auto &c : callees) list(c.second);
    order_.push_back(v);
  };
  for (Variant *root : roots_) list(root);
  for (Variant *v : order_) VariantAnalysis(*this, *v, true).check();
}

Activity::~Activity() = default;

Place *Activity::makePlace(const Type *type) {
  while (type->kind == Type::Array) type = type->element;
  Place *p = storage_.emplace_back(std::make_unique<Place>()).get();
  if (type->kind == Type::Pointer) p->target = makePlace(type->element);
  return p;
}

Variant *Activity::variant(const Function *f, const std::string &signature) {
  Variant *&known = known_[{f, signature}];
  if (known) return known;
  known = owned_.emplace_back(std::make_unique<Variant>()).get();
  Variant *v = known;
  v->function = f;
  v->signature = signature;
  v->result = makePlace(f->result);
  for (size_t i = 0; i < f->params.size(); ++i) {
    Place *p = v->places[f->params[i]] = makePlace(f->params[i]->type);
    while (p->target) p = p->target;
    p->active = signature[i] == 'a' || signature[i] == 'i';
    p->frozen = signature[i] == 'c';
    p->input = signature[i] == 'c' || signature[i] == 'i';
  }
  return v;
}

void Activity::report(const char *id, const Loc &loc, const std::string &what) { diags_.add(id, program_, loc, what); }

} // namespace tlgen
