// What expressions are worth, in the arithmetic of C: integers wrap as their types do, constants are computed at once.
#include "MathFunctions.h"
#include "Tracer.h"
#include "Values.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tlgen::symbols {
namespace {

bool isTruth(const Node *n) {
  return n->op == Node::Compare || n->op == Node::Not || n->op == Node::Conjunction || n->op == Node::Disjunction ||
         (n->isConstant() && (n->offset == 0 || n->offset == 1));
}

bool isFloat(const Type *type) { return type->kind == Type::Real && type->name == "float"; }
bool isUnsigned(const Type *type) { return type->name.find("unsigned") != std::string::npos || type->name == "_Bool"; }

int bitsOf(const Type *type) {
  auto has = [&](const char *word) { return type->name.find(word) != std::string::npos; };
  return type->name == "_Bool" ? 1 : has("char") ? 8 : has("short") ? 16 : has("long") ? 64 : 32;
}

// The value that an integer type keeps of a number. Unsigned numbers of 64 bits are kept as the long of the same bits.
long wrapped(long value, const Type *type) {
  if (type->name == "_Bool") return value != 0;
  int bits = bitsOf(type);
  if (bits == 64) return value;
  unsigned long mask = (1ul << bits) - 1, low = static_cast<unsigned long>(value) & mask;
  bool negative = !isUnsigned(type) && (low >> (bits - 1));
  return static_cast<long>(negative ? low | ~mask : low);
}

Range rangeOf(const Type *type) { return tlgen::converted(Range{}, type); }

bool inside(const Range &inner, const Range &outer) { return inner.lo >= outer.lo && inner.hi <= outer.hi; }

bool isAccess(const Expr *e) {
  return e->kind == Expr::Ref || e->kind == Expr::Index || e->kind == Expr::Member || e->kind == Expr::Deref;
}

bool isComparison(const std::string &op) { return op == "<" || op == ">" || op == "<=" || op == ">=" || op == "==" || op == "!="; }

// An unsigned number of 64 bits, negative as a long, stands above all others.
bool compareIntegers(const std::string &op, long a, long b, bool asUnsigned) {
  bool less = asUnsigned ? static_cast<unsigned long>(a) < static_cast<unsigned long>(b) : a < b;
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return less;
  if (op == "<=") return less || a == b;
  return op == ">" ? !less && a != b : !less;
}

// False where C has no answer.
bool computeIntegers(const std::string &op, long x, long y, const Type *type, long &result) {
  bool asUnsigned = isUnsigned(type);
  unsigned long a = static_cast<unsigned long>(x), b = static_cast<unsigned long>(y), r = 0;
  if (op == "/" || op == "%") {
    if (y == 0 || (!asUnsigned && y == -1 && op == "%")) return y != 0 && (result = 0, true);
    if (asUnsigned) r = op == "/" ? a / b : a % b;
    if (!asUnsigned) r = static_cast<unsigned long>(op == "/" ? (y == -1 ? -x : x / y) : x % y);
  } else if (op == "<<" || op == ">>") {
    if (y < 0 || y > 63) return false;
    r = op == "<<" ? a << y : asUnsigned ? a >> y : static_cast<unsigned long>(x >> y);
  } else {
    r = op == "+" ? a + b : op == "-" ? a - b : op == "*" ? a * b : op == "&" ? a & b : op == "|" ? a | b : a ^ b;
  }
  return result = wrapped(static_cast<long>(r), type), true;
}

} // namespace

// An iteration number of a loop whose end is not found yet is in it.
static bool isOpen(const Node *n) {
  return n->op == Node::Affine && std::any_of(n->terms.begin(), n->terms.end(), [](const auto &t) { return !t.first->trips; });
}

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

Node *Tracer::convert(Node *n, const Type *from, const Type *to) {
  if (to->kind == Type::Integer && bitsOf(to) == 64 && to->name.find("128") != std::string::npos) unsuitable("integers of 128 bits");
  if (to->kind == Type::Real && from->kind == Type::Integer) {
    Node *real = graph_.convert("tl_real", n);
    bool exact = inside(bounds(n), {-(1L << 24), 1L << 24});
    return isFloat(to) && !exact ? rounded(real) : real;
  }
  if (to->kind == Type::Real) {
    if (isFloat(from) && !isFloat(to)) return n->isNumber() ? n : graph_.convert("tl_real", n);
    return isFloat(to) && !isFloat(from) ? rounded(n) : n;
  }
  if (from->kind == Type::Real) {
    if (to->name == "_Bool") return graph_.compare("!=", n, graph_.number(0));
    if (n->isNumber() && std::fabs(n->value) < 9e18) return graph_.integer(wrapped(long(n->value), to));
    return graph_.convert(to->name, n);
  }
  if (to->name == "_Bool") return compare("!=", n, graph_.integer(0), from);
  if (n->isConstant()) return graph_.integer(wrapped(n->offset, to));
  Range all = rangeOf(to);
  bool wraps = isUnsigned(to) && bitsOf(to) == 64 && !isUnsigned(from) && bounds(n).lo < 0;
  bool fits = symbols::isOpen(n) || (!wraps && (inside(bounds(n), all) || inside(rangeOf(from), all)));
  return fits ? n : graph_.convert(to->name, n);
}

// A double as a float: of constants only.
Node *Tracer::rounded(Node *n) {
  if (!n->isNumber()) unsuitable("single precision arithmetic, which rounds after each operation,");
  return graph_.number(double(float(n->value)));
}

// The smallest range that is known of an integer.
Range Tracer::bounds(const Node *n) {
  if (n->op == Node::Affine || n->loop) return boundsOf(n); // what is known of loops grows
  auto known = bounds_.find(n);
  if (known != bounds_.end()) return known->second;
  return bounds_[n] = boundsOf(n);
}

// The largest or smallest value over all iterations, loop by loop from the innermost.
long Tracer::extreme(const Node *n, bool largest) {
  while (!n->terms.empty()) {
    auto inner = n->terms.begin();
    for (auto term = n->terms.begin(); term != n->terms.end(); ++term)
      if (term->first->within(inner->first)) inner = term;
    auto [loop, factor] = *inner;
    Node *number = graph_.integer(0);
    if ((factor > 0) == largest) {
      if (!loop->trips || loop->trips->op != Node::Affine) return largest ? LONG_MAX : LONG_MIN;
      number = graph_.integerOp("-", loop->trips, graph_.integer(1));
    }
    auto rest = n->terms;
    rest.erase(rest.begin() + (inner - n->terms.begin()));
    Node *others = graph_.affine(n->offset, std::move(rest));
    n = graph_.integerOp("+", others, graph_.integerOp("*", graph_.integer(factor), number));
  }
  return n->offset;
}

Range Tracer::boundsOf(const Node *n) {
  switch (n->op) {
  case Node::Affine:
    return {extreme(n, false), extreme(n, true)};
  case Node::Compare:
  case Node::Not:
  case Node::Conjunction:
  case Node::Disjunction:
    return {0, 1};
  case Node::Select:
    return hull(bounds(n->args[1]), bounds(n->args[2]));
  case Node::Integer:
    return tlgen::arithmetic(n->text, bounds(n->args[0]), bounds(n->args[1]));
  case Node::Convert: {
    Type type;
    type.kind = Type::Integer;
    type.name = n->text;
    return rangeOf(&type);
  }
  default:
    return {};
  }
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

Node *Tracer::arithmetic(const std::string &op, Node *a, Node *b, const Type *type) {
  return type->kind == Type::Real ? realArithmetic(op, a, b, type) : integerArithmetic(op, a, b, type);
}

Node *Tracer::realArithmetic(const std::string &op, Node *a, Node *b, const Type *type) {
  if (a->isNumber() && b->isNumber()) {
    double x = a->value, y = b->value, r = op == "+" ? x + y : op == "-" ? x - y : op == "*" ? x * y : x / y;
    if (std::isfinite(r)) return isFloat(type) ? rounded(graph_.number(r)) : graph_.number(r);
  }
  if (isFloat(type)) rounded(a->isNumber() ? b : a);
  return op == "+" ? graph_.add(a, b) : op == "-" ? graph_.sub(a, b) : op == "*" ? graph_.mul(a, b) : graph_.div(a, b);
}

Node *Tracer::integerArithmetic(const std::string &op, Node *a, Node *b, const Type *type) {
  long value = 0;
  if (a->isConstant() && b->isConstant()) {
    if (!computeIntegers(op, a->offset, b->offset, type, value)) unsuitable("an integer operation has no result");
    return graph_.integer(value);
  }
  auto is = [](Node *n, long v) { return n->isConstant() && n->offset == v; };
  bool isSum = op == "+" || op == "-" || op == "|" || op == "^" || op == "<<" || op == ">>";
  if ((isSum && is(b, 0)) || ((op == "*" || op == "/") && is(b, 1))) return a;
  if ((op == "+" && is(a, 0)) || (op == "*" && is(a, 1))) return b;
  if ((op == "*" || op == "&") && (is(a, 0) || is(b, 0))) return graph_.integer(0);
  Node *result = graph_.integerOp(op, a, b);
  bool fits = !isUnsigned(type) || symbols::isOpen(result) || (bounds(result).lo >= 0 && inside(bounds(result), rangeOf(type)));
  return fits ? result : graph_.convert(type->name, result);
}

// Of numbers of one type.
Node *Tracer::compare(const std::string &op, Node *a, Node *b, const Type *type) {
  if (type->kind == Type::Real) return graph_.compare(op, a, b);
  if (a->isConstant() && b->isConstant())
    return graph_.integer(compareIntegers(op, a->offset, b->offset, isUnsigned(type) && bitsOf(type) == 64));
  if (a->isConstant() && (op == "==" || op == "!=")) std::swap(a, b);
  bool decides = b->isConstant() && (b->offset == 0 || b->offset == 1) && (op == "==" || op == "!=");
  if (isTruth(a) && decides) return (op == "!=") == (b->offset == 0) ? a : graph_.logicalNot(a);
  const bool moving = a->op == Node::Affine && b->op == Node::Affine;
  Range known = moving ? comparison(op, bounds(graph_.integerOp("-", a, b)), Range::of(0)) : comparison(op, bounds(a), bounds(b));
  if (known.exact()) return graph_.integer(known.lo);
  if (moving) splitAt(op, graph_.integerOp("-", a, b));
  return graph_.compare(op, a, b);
}

// A comparison of iteration numbers that is not decided: the loop is split where its result changes.
void Tracer::splitAt(const std::string &op, Node *difference) {
  if (symbols::isOpen(difference) || !splits_) return; // decided in the next pass
  if (difference->terms.size() > 1) {
    if (op == "==" || op == "!=") return; // a choice of run time
    irregular("a condition compares the numbers of several loops");
  }
  auto [loop, factor] = difference->terms[0];
  size_t level = 0;
  while (level < kept_.size() && kept_[level]->loop != loop) ++level;
  Range numbers = bounds(loop->index);
  auto holds = [&, f = factor](long k) { return compareIntegers(op, difference->offset + f * k, 0, false); };
  for (long k = 1; k <= numbers.hi; ++k)
    if (holds(k) != holds(0)) throw Split{level, k};
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
  if (a.condition) return graph_.select(a.condition, difference(*a.yes, b, size), difference(*a.no, b, size));
  if (b.condition) return graph_.select(b.condition, difference(a, *b.yes, size), difference(a, *b.no, size));
  if (a.object != b.object) unsuitable("pointers into different objects are subtracted");
  Node *d = graph_.integerOp("-", offset(a), offset(b));
  if (size == 1) return d;
  if (d->op != Node::Affine) return graph_.integerOp("/", d, graph_.integer(size));
  auto terms = d->terms;
  for (auto &term : terms) term.second /= size;
  return graph_.affine(d->offset / size, std::move(terms));
}

Node *Tracer::comparePointers(const std::string &op, const Pointer &a, const Pointer &b) {
  auto either = [&](Node *condition, Node *yes, Node *no) {
    return graph_.logicalOr(graph_.logicalAnd(condition, yes), graph_.logicalAnd(graph_.logicalNot(condition), no));
  };
  if (a.condition) return either(a.condition, comparePointers(op, *a.yes, b), comparePointers(op, *a.no, b));
  if (b.condition) return either(b.condition, comparePointers(op, a, *b.yes), comparePointers(op, a, *b.no));
  Type type;
  type.kind = Type::Integer;
  type.name = "long";
  if (a.object == b.object) return compare(op, offset(a), offset(b), &type);
  if (op != "==" && op != "!=") return graph_.integer(compareIntegers(op, a.object, b.object, false)); // any answer will do
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
    Node *yes = graph_.logicalAnd(p.condition, isNull(*p.yes));
    return graph_.logicalOr(yes, graph_.logicalAnd(graph_.logicalNot(p.condition), isNull(*p.no)));
  }
  if (!isGiven(p)) return graph_.integer(p.object == Pointer::null);
  const Object &o = objects_[size_t(p.object)];
  Slot s;
  s.kind = Slot::Member;
  s.text = "(" + o.text + " != 0)";
  s.integer = true;
  s.length = 1;
  return graph_.compare("==", graph_.leaf(graph_.slot(s), o.indices), graph_.integer(0));
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

// Functions of math.h

Node *Tracer::mathCall(const Expr *e) {
  std::vector<Node *> args;
  for (const Expr *arg : e->args) {
    if (arg->type->kind == Type::Pointer) unsuitable("the function '" + e->text + "' takes a pointer");
    args.push_back(number(arg));
  }
  at(e->loc);
  bool varied = std::any_of(args.begin(), args.end(), [&](Node *n) { return isVaried(n); });
  if (e->rule) {
    if (varied && args.size() > 1) unsuitable("the derivatives of '" + e->text + "' go by a rule for several numbers");
    return graph_.taylor(e->text, 0, args);
  }
  const MathFunction *f = findMath(e->text);
  if (!f) unsuitable("the function '" + e->text + "' is not known");
  if (f->kind == MathFunction::Test) return test(e, args);
  if (f->name != e->text) unsuitable("single precision arithmetic, which rounds after each operation,");
  const std::string name = f->name;
  if (name == "ilogb") return graph_.convert("int", graph_.math(name, args));
  if (name == "lround" || name == "lrint") return graph_.convert("long", graph_.math(name.substr(1), args));
  if (name == "llround" || name == "llrint") return graph_.convert("long long", graph_.math(name.substr(2), args));
  if ((name == "ldexp" || name == "scalbn") && args[1]->isConstant())
    return graph_.scale(std::ldexp(1.0, int(args[1]->offset)), args[0]);
  Node *value = graph_.math(name, args);
  if (value->op != Node::Math) return value;
  for (size_t i = 0; i < value->args.size(); ++i)
    if (isVaried(value->args[i]) && !derivative(graph_, value, i))
      unsuitable("there is no formula for the derivative of '" + name + "'");
  return value;
}

// A function of whole numbers, or that asks a question.
Node *Tracer::test(const Expr *e, const std::vector<Node *> &args) {
  const std::string name = findMath(e->text)->name;
  static const std::map<std::string, std::string> comparisons = {
      {"isgreater", ">"}, {"isgreaterequal", ">="}, {"isless", "<"}, {"islessequal", "<="}};
  auto op = comparisons.find(name);
  if (op != comparisons.end()) return graph_.compare(op->second, args[0], args[1]);
  if (name == "islessgreater") return graph_.logicalOr(graph_.compare("<", args[0], args[1]), graph_.compare("<", args[1], args[0]));
  if (name == "abs" || name == "labs" || name == "llabs") {
    Node *negative = compare("<", args[0], graph_.integer(0), e->type);
    Node *opposite = integerArithmetic("-", graph_.integer(0), args[0], e->type);
    return graph_.select(negative, opposite, args[0]);
  }
  bool known = args[0]->isNumber() && (name == "isnan" || name == "isinf" || name == "isfinite");
  if (known) return graph_.integer(name == "isfinite"); // constants are finite
  return graph_.compare("!=", graph_.math(name, args), graph_.integer(0));
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
