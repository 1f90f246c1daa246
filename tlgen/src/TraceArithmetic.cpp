// Arithmetic as C does it: integers wrap as their types do, constants are computed at once, and what range an integer can be in is
// known as far as it follows from the source.
#include "MathFunctions.h"
#include "Tracer.h"

#include <algorithm>
#include <cmath>

namespace tlgen::symbols {

int bitsOf(const Type *type) {
  auto has = [&](const char *word) { return type->name.find(word) != std::string::npos; };
  return type->name == "_Bool" ? 1 : has("char") ? 8 : has("short") ? 16 : has("long") ? 64 : 32;
}

namespace {

bool isTruth(const Node *n) {
  return n->op == Node::Compare || n->op == Node::Not || n->op == Node::Conjunction || n->op == Node::Disjunction ||
         (n->isConstant() && (n->offset == 0 || n->offset == 1));
}

bool isFloat(const Type *type) { return type->kind == Type::Real && type->name == "float"; }
bool isUnsigned(const Type *type) { return type->name.find("unsigned") != std::string::npos || type->name == "_Bool"; }

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

// An unsigned number of 64 bits, negative as a long, stands above all others.
bool compareIntegers(const std::string &op, long a, long b, bool asUnsigned) {
  bool less = asUnsigned ? static_cast<unsigned long>(a) < static_cast<unsigned long>(b) : a < b;
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return less;
  if (op == "<=") return less || a == b;
  return op == ">" ? !less && a != b : !less;
}

// result = x op y as the type keeps it. False where C has no answer.
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

// An iteration number of a loop whose end is not found yet is in it.
bool isOpen(const Node *n) {
  return n->op == Node::Affine && std::any_of(n->terms.begin(), n->terms.end(), [](const auto &t) { return !t.first->trips; });
}

} // namespace

// Conversions

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
  bool fits = isOpen(n) || (!wraps && (inside(bounds(n), all) || inside(rangeOf(from), all)));
  return fits ? n : graph_.convert(to->name, n);
}

// A double as a float: of constants only.
Node *Tracer::rounded(Node *n) {
  if (!n->isNumber()) unsuitable("single precision arithmetic, which rounds after each operation,");
  return graph_.number(double(float(n->value)));
}

// Ranges

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

// Operations

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
  bool fits = !isUnsigned(type) || isOpen(result) || (bounds(result).lo >= 0 && inside(bounds(result), rangeOf(type)));
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
  if (isOpen(difference) || !splits_) return; // decided in the next pass
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
  if (name == "islessgreater") {
    Node *greater = graph_.compare("<", args[1], args[0]);
    return graph_.logicalOr(graph_.compare("<", args[0], args[1]), greater);
  }
  if (name == "abs" || name == "labs" || name == "llabs") {
    Node *negative = compare("<", args[0], graph_.integer(0), e->type);
    Node *opposite = integerArithmetic("-", graph_.integer(0), args[0], e->type);
    return graph_.select(negative, opposite, args[0]);
  }
  bool known = args[0]->isNumber() && (name == "isnan" || name == "isinf" || name == "isfinite");
  if (known) return graph_.integer(name == "isfinite"); // constants are finite
  Node *zero = graph_.integer(0);
  return graph_.compare("!=", graph_.math(name, args), zero);
}

} // namespace tlgen::symbols
