// What expressions are worth, and what they change.
#include "Tracer.h"

#include <algorithm>
#include <cstdlib>

namespace tlgen::symbols {
namespace {

bool isAccess(const Expr *e) {
  return e->kind == Expr::Ref || e->kind == Expr::Index || e->kind == Expr::Member || e->kind == Expr::Deref;
}

bool isComparison(const std::string &op) { return op == "<" || op == ">" || op == "<=" || op == ">=" || op == "==" || op == "!="; }

} // namespace

// How many numbers and pointers an object of the type holds.
long Tracer::leaves(const Type *type) {
  if (type->kind == Type::Array) {
    long count = type->count;
    if (type->length) {
      Node *length = number(type->length);
      if (!length->isConstant()) unsuitable("the length of an array depends on " + dependence(length));
      count = length->offset;
    }
    long size = count * leaves(type->element);
    if (count < 0 || size > maxLeaves) unsuitable("an array is too large");
    return size;
  }
  if (type->kind != Type::Struct) return 1;
  auto [known, isNew] = records_.emplace(type->record, 0);
  if (isNew)
    for (const Field &field : type->record->fields) known->second += leaves(field.type);
  return known->second;
}

Cells Tracer::eval(const Expr *e) {
  checkSize();
  if (e->loc.line) at(e->loc);
  switch (e->kind) {
  case Expr::Ref:
  case Expr::Index:
  case Expr::Member:
  case Expr::Deref:
    return load(e);
  case Expr::Literal:
    if (e->type->kind == Type::Struct) return fill(e->type, nullptr);
    return {literal(e)};
  case Expr::AddressOf:
  case Expr::Decay:
    return {{Cell::Address, nullptr, place(e->args[0])}};
  case Expr::Unary:
    return {{Cell::Number, unary(e), nullptr}};
  case Expr::Binary:
    return {binary(e)};
  case Expr::Conditional:
    return conditional(e);
  case Expr::Call:
    return call(e);
  case Expr::MathCall:
    return {{Cell::Number, mathCall(e), nullptr}};
  case Expr::Cast:
    return castOf(e);
  case Expr::Assign:
    return assign(e);
  case Expr::Step:
    return step(e);
  case Expr::Comma:
    eval(e->args[0]);
    return eval(e->args[1]);
  case Expr::InitList:
    return fill(e->type, e);
  }
  std::abort();
}

// The value of an lvalue. A struct may be read before all of it has values.
Cells Tracer::load(const Expr *e) {
  Cells cells = read(place(e), std::max(1L, leaves(e->type)), e->type);
  at(e->loc);
  if (e->type->kind == Type::Struct || e->type->kind == Type::Array) return cells;
  return {demanded(cells[0], e->type)};
}

Node *Tracer::number(const Expr *e) {
  Cell c = cell(e);
  if (c.kind != Cell::Number) unsuitable("a pointer stands where a number is needed");
  return c.node;
}

PointerRef Tracer::pointer(const Expr *e) {
  Cell c = cell(e);
  if (c.kind != Cell::Address) unsuitable("where a pointer points is not known");
  return c.pointer;
}

Node *Tracer::truth(const Expr *e) { return truth(cell(e), e->type); }

Node *Tracer::truth(const Cell &c, const Type *type) {
  if (c.kind == Cell::Address) return graph_.logicalNot(isNull(*c.pointer));
  if (c.kind != Cell::Number) unsuitable("a condition is not known");
  if (type->kind == Type::Real) return graph_.compare("!=", c.node, graph_.number(0));
  return compare("!=", c.node, graph_.integer(0), type);
}

Cell Tracer::literal(const Expr *e) {
  const std::string &text = e->text;
  if (e->type->kind == Type::Real) return {Cell::Number, graph_.number(std::strtod(text.c_str(), nullptr)), nullptr};
  if (e->type->kind == Type::Integer) {
    long value = text[0] == '-' ? std::strtol(text.c_str(), nullptr, 10) : long(std::strtoul(text.c_str(), nullptr, 10));
    return {Cell::Number, graph_.integer(value), nullptr};
  }
  if (text[0] != '"') return {Cell::Address, nullptr, to(Pointer::null)};
  return {Cell::Address, nullptr, to(object(0, e, "a string", e->type->element))};
}

Cells Tracer::castOf(const Expr *e) {
  const Expr *inner = e->args[0];
  if (e->type->kind == Type::Void && isAccess(inner)) return place(inner), Cells(1); // nobody reads it
  Cells cells = eval(inner);
  if (cells.size() != 1 || cells[0].kind != Cell::Number || e->type->kind == Type::Void) return cells;
  if (e->type->kind == Type::Pointer) unsuitable("a number is made a pointer");
  cells[0].node = convert(cells[0].node, inner->type, e->type);
  return cells;
}

Node *Tracer::unary(const Expr *e) {
  if (e->text == "!") return graph_.logicalNot(truth(e->args[0]));
  Node *x = number(e->args[0]);
  if (e->text == "+") return x;
  if (e->type->kind == Type::Real) return graph_.neg(x);
  Node *first = graph_.integer(e->text == "~" ? -1 : 0);
  return integerArithmetic("-", first, x, e->type);
}

Cell Tracer::binary(const Expr *e) {
  const Expr *left = e->args[0], *right = e->args[1];
  if (e->text == "&&" || e->text == "||") return {Cell::Number, logical(e), nullptr};
  if (left->type->kind == Type::Pointer || right->type->kind == Type::Pointer) return pointerBinary(e);
  Node *a = number(left), *b = number(right);
  at(e->loc);
  if (isComparison(e->text)) return {Cell::Number, compare(e->text, a, b, left->type), nullptr};
  return {Cell::Number, arithmetic(e->text, a, b, e->type), nullptr};
}

// Pointers

Cell Tracer::pointerBinary(const Expr *e) {
  const Expr *left = e->args[0], *right = e->args[1];
  if (left->type->kind == Type::Pointer && right->type->kind == Type::Pointer) {
    PointerRef a = pointer(left), b = pointer(right);
    if (e->text != "-") return {Cell::Number, comparePointers(e->text, *a, *b), nullptr};
    return {Cell::Number, difference(*a, *b, leaves(left->type->element)), nullptr};
  }
  bool first = left->type->kind == Type::Pointer;
  PointerRef p = pointer(first ? left : right);
  return {Cell::Address, nullptr, advanced(p, number(first ? right : left), e->text == "-", e->type->element)};
}

PointerRef Tracer::advanced(const PointerRef &p, Node *by, bool back, const Type *element) {
  if (back) by = graph_.integerOp("-", graph_.integer(0), by);
  return moved(p, leaves(element), by);
}

Node *Tracer::difference(const Pointer &a, const Pointer &b, long size) {
  if (a.condition || b.condition) {
    const Pointer &choice = a.condition ? a : b;
    auto with = [&](const Pointer &one) { return a.condition ? difference(one, b, size) : difference(a, one, size); };
    Node *no = with(*choice.no), *yes = with(*choice.yes);
    return graph_.select(choice.condition, yes, no);
  }
  if (a.object != b.object) unsuitable("pointers into different objects are subtracted");
  Node *right = offset(b), *d = graph_.integerOp("-", offset(a), right);
  if (size == 1) return d;
  if (d->op != Node::Affine) return graph_.integerOp("/", d, graph_.integer(size));
  auto terms = d->terms;
  for (auto &term : terms) term.second /= size;
  return graph_.affine(d->offset / size, std::move(terms));
}

Node *Tracer::comparePointers(const std::string &op, const Pointer &a, const Pointer &b) {
  if (a.condition || b.condition) {
    const Pointer &choice = a.condition ? a : b;
    auto with = [&](const Pointer &one) { return a.condition ? comparePointers(op, one, b) : comparePointers(op, a, one); };
    Node *no = with(*choice.no), *yes = with(*choice.yes);
    Node *otherwise = graph_.logicalAnd(graph_.logicalNot(choice.condition), no);
    return graph_.logicalOr(graph_.logicalAnd(choice.condition, yes), otherwise);
  }
  Type type;
  type.kind = Type::Integer;
  type.name = "long";
  if (a.object == b.object) {
    Node *right = offset(b);
    return compare(op, offset(a), right, &type);
  }
  if (op != "==" && op != "!=") { // any answer will do
    Node *right = graph_.integer(b.object);
    return compare(op, graph_.integer(a.object), right, &type);
  }
  Node *same = a.object == Pointer::null ? isNull(b) : b.object == Pointer::null ? isNull(a) : nullptr;
  if (!same && isGiven(a) && isGiven(b)) unsuitable("whether two pointers of the parameters are the same is not known");
  if (!same) same = graph_.integer(0);
  return op == "==" ? same : graph_.logicalNot(same);
}

// Whether a pointer was read from the parameters.
bool Tracer::isGiven(const Pointer &p) const {
  return p.object != Pointer::null && objects_[size_t(p.object)].kind == Object::Parameters && objects_[size_t(p.object)].unbounded;
}

Node *Tracer::isNull(const Pointer &p) {
  if (p.condition) {
    Node *yes = graph_.logicalAnd(p.condition, isNull(*p.yes)), *no = isNull(*p.no);
    return graph_.logicalOr(yes, graph_.logicalAnd(graph_.logicalNot(p.condition), no));
  }
  if (!isGiven(p)) return graph_.integer(p.object == Pointer::null);
  const Object &o = objects_[size_t(p.object)];
  Slot s;
  s.kind = Slot::Member;
  s.text = "(" + o.text + " != 0)";
  s.integer = true;
  s.length = 1;
  Node *null = graph_.integer(0);
  return graph_.compare("==", graph_.leaf(graph_.slot(s), o.indices), null);
}

// Choices

// The states in which a condition holds and in which not. Of && and || each operand is decided by itself, so that what the second one
// changes is known where it was reached.
void Tracer::decide(const Expr *condition, State &yes, State &no) {
  const bool isAnd = condition->kind == Expr::Binary && condition->text == "&&";
  if (isAnd || (condition->kind == Expr::Binary && condition->text == "||")) {
    State first, settled, held, failed;
    decide(condition->args[0], isAnd ? first : settled, isAnd ? settled : first);
    take(first);
    if (state_.live) decide(condition->args[1], held, failed);
    yes = isAnd ? held : mergeAll({settled, held});
    no = isAnd ? mergeAll({settled, failed}) : failed;
    return;
  }
  Node *holds = truth(condition);
  yes = no = state_;
  yes.live = !holds->isConstant() || holds->offset;
  no.live = !holds->isConstant() || !holds->offset;
  if (holds->isConstant()) return;
  yes.path = under(holds);
  no.path = under(graph_.logicalNot(holds));
}

// Runs both ways of a condition of run time, and merges what they leave behind.
void Tracer::branch(Node *condition, const std::function<void()> &yes, const std::function<void()> &no) {
  const Path *before = state_.path, *first = under(condition), *second = under(graph_.logicalNot(condition));
  const size_t jumps = pending();
  State other = state_;
  take(first);
  yes();
  State after = std::move(state_);
  other.path = second;
  take(std::move(other));
  no();
  take(mergeAll({after, state_}));
  if (pending() == jumps) take(before); // nothing went elsewhere
}

// The second operand is reached where the first does not settle it.
Node *Tracer::logical(const Expr *e) {
  bool isAnd = e->text == "&&";
  Node *first = truth(e->args[0]), *second = nullptr;
  if (first->isConstant()) return (first->offset != 0) == isAnd ? truth(e->args[1]) : graph_.integer(!isAnd);
  branch(isAnd ? first : graph_.logicalNot(first), [&] { second = truth(e->args[1]); }, [] {});
  return isAnd ? graph_.logicalAnd(first, second) : graph_.logicalOr(first, second);
}

Cells Tracer::conditional(const Expr *e) {
  Node *condition = truth(e->args[0]);
  if (condition->isConstant()) return eval(e->args[condition->offset ? 1 : 2]);
  Cells yes, no;
  branch(condition, [&] { yes = eval(e->args[1]); }, [&] { no = eval(e->args[2]); });
  return merged(condition, yes, no);
}

// Changes

Cells Tracer::assign(const Expr *e) {
  const Expr *left = e->args[0], *right = e->args[1];
  if (e->text == "=") {
    bool raw = e->wholesale && isAccess(right);
    Cells cells = raw ? read(place(right), std::max(1L, leaves(right->type)), right->type) : eval(right);
    at(e->loc);
    name(left, cells);
    write(place(left), cells);
    return cells;
  }
  PointerRef p = place(left);
  Cell old = demanded(read(p, 1, left->type)[0], left->type);
  Cell by = cell(right);
  at(e->loc);
  const std::string op = e->text.substr(0, e->text.size() - 1);
  Cell result = old;
  if (left->type->kind == Type::Pointer) {
    result.pointer = advanced(old.pointer, by.node, op == "-", left->type->element);
  } else { // in the wider type of both
    bool wide = right->type->kind == Type::Real || (left->type->kind == Type::Integer && bitsOf(right->type) >= bitsOf(left->type));
    const Type *type = wide && op != "<<" && op != ">>" ? right->type : left->type;
    Node *value = arithmetic(op, convert(old.node, left->type, type), by.node, type);
    result.node = convert(value, type, left->type);
  }
  name(left, {result});
  write(p, {result});
  return {result};
}

void Tracer::name(const Expr *left, const Cells &cells) {
  while (left->kind != Expr::Ref && left->kind != Expr::Member && !left->args.empty()) left = left->args[0];
  name(left->kind == Expr::Ref ? left->var->name : left->text, cells);
}

// A number is called like the first variable or member that holds it.
void Tracer::name(const std::string &variable, const Cells &cells) {
  if (cells.size() != 1 || cells[0].kind != Cell::Number) return;
  if (cells[0].node->name.empty()) cells[0].node->name = variable;
  assigned_.push_back(cells[0].node);
}

Cells Tracer::step(const Expr *e) {
  const Expr *left = e->args[0];
  const std::string op = e->text.substr(1);
  PointerRef p = place(left);
  Cell old = demanded(read(p, 1, left->type)[0], left->type), now = old;
  at(e->loc);
  if (left->type->kind == Type::Pointer)
    now.pointer = advanced(old.pointer, graph_.integer(1), op == "-", left->type->element);
  else if (left->type->kind == Type::Real)
    now.node = realArithmetic(op, old.node, graph_.number(1), left->type);
  else
    now.node = integerArithmetic(op, old.node, graph_.integer(1), left->type);
  write(p, {now});
  return {e->prefix ? now : old};
}

// A number or pointer that is used. To use one that has no value is undefined in C: it may be zero.
Cell Tracer::demanded(const Cell &c, const Type *type) {
  if (c.kind == Cell::Unset) return fill(type, nullptr)[0];
  if (c.kind == Cell::Lost) unsuitable("what a variable holds here depends on a choice of run time");
  return c;
}

// Objects

// The leaves of an object that begins with this initialiser; a null one is zero.
Cells Tracer::fill(const Type *type, const Expr *e) {
  if (e && e->kind != Expr::InitList) return eval(e);
  auto item = [&](size_t i) { return e && i < e->args.size() ? e->args[i] : nullptr; };
  Cells cells;
  auto add = [&](const Type *t, size_t i) {
    Cells part = fill(t, item(i));
    cells.insert(cells.end(), part.begin(), part.end());
  };
  if (type->kind == Type::Array) {
    long count = leaves(type) / std::max(1L, leaves(type->element));
    for (long i = 0; i < count; ++i) add(type->element, size_t(i));
  } else if (type->kind == Type::Struct) {
    for (size_t i = 0; i < type->record->fields.size(); ++i) add(type->record->fields[i].type, i);
  } else if (item(0)) {
    return eval(item(0));
  } else if (type->kind == Type::Pointer) {
    cells.push_back({Cell::Address, nullptr, to(Pointer::null)});
  } else {
    cells.push_back({Cell::Number, type->kind == Type::Real ? graph_.number(0) : graph_.integer(0), nullptr});
  }
  return cells;
}

PointerRef Tracer::place(const Expr *e) {
  switch (e->kind) {
  case Expr::Ref: {
    const Variable *v = e->var;
    return to(v->scope == Variable::Global || v->isStatic ? constant(v) : object(frames_.size(), v, v->name, v->type));
  }
  case Expr::Index: {
    PointerRef base = e->args[0]->kind == Expr::Decay ? place(e->args[0]->args[0]) : pointer(e->args[0]);
    return moved(base, leaves(e->type), number(e->args[1]));
  }
  case Expr::Deref:
    return pointer(e->args[0]);
  case Expr::Member: {
    PointerRef base = e->arrow ? pointer(e->args[0]) : place(e->args[0]);
    const Record *record = (e->arrow ? e->args[0]->type->element : e->args[0]->type)->record;
    long before = 0;
    for (const Field &field : record->fields) {
      if (field.name == e->text) break;
      before += leaves(field.type);
    }
    return moved(base, before);
  }
  case Expr::Comma:
    eval(e->args[0]);
    return place(e->args[1]);
  default: { // a temporary, or a compound literal
    Cells cells = eval(e);
    int id = object(frames_.size(), e, "a temporary", e->type);
    define(id, std::move(cells));
    return to(id);
  }
  }
}

} // namespace tlgen::symbols
