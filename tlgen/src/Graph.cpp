// Making of nodes: each value once, with the arithmetic that can be done at once done.
#include "Graph.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tlgen {
namespace {

template <class T> void put(std::string &key, const T &v) {
  char raw[sizeof v];
  std::memcpy(raw, &v, sizeof v);
  key.append(raw, sizeof v);
}

std::string keyOf(const Node &n) {
  std::string key;
  put(key, n.op);
  put(key, n.value);
  put(key, n.offset);
  for (auto &[loop, factor] : n.terms) {
    put(key, loop);
    put(key, factor);
  }
  put(key, n.slot);
  put(key, n.array);
  put(key, n.of);
  put(key, n.which);
  for (const Node *arg : n.args) put(key, arg);
  return key + n.text;
}

Loop *deeper(Loop *a, Loop *b) {
  if (!a || !b) return a ? a : b;
  return a->within(b) ? a : b;
}

// Arithmetic on parameters, outside of loops.
bool isFixed(const Node &n) {
  if (n.loop || n.guard) return false;
  if (n.op == Node::Leaf) return n.slot->kind == Slot::Member && !n.slot->integer;
  if (n.op != Node::Add && n.op != Node::Mul && n.op != Node::Recip && n.op != Node::Number) return false;
  return std::all_of(n.args.begin(), n.args.end(), [](const Node *arg) { return arg->fixed; });
}

bool isNegation(const Node *n) { return n->op == Node::Mul && n->args[0]->is(-1); }

const Guard *common(const Guard *a, const Guard *b) {
  while (a && !Graph::covers(a, b)) a = a->outer;
  return a;
}

// Whether one is a guard of other values of what the other is, or of what both are.
bool isRemade(const Guard *a, const Guard *b) {
  auto source = [](const Guard *g) { return g->of ? g->of : g; };
  const Guard *both = common(a, b);
  for (const Guard *x = a; x != both; x = x->outer)
    for (const Guard *y = b; y != both; y = y->outer)
      if (source(x) == source(y)) return true;
  return false;
}

// The conditions that are known where the loop's values are: a value that does not vary in a loop is computed before it.
const Guard *visible(const Guard *guard, const Loop *loop) {
  while (guard && guard->holds->loop && !(loop && loop->within(guard->holds->loop))) guard = guard->outer;
  return guard;
}

} // namespace

bool isInteger(const Node *n) {
  switch (n->op) {
  case Node::Affine:
  case Node::Integer:
  case Node::Compare:
  case Node::Not:
  case Node::Conjunction:
  case Node::Disjunction:
    return true;
  case Node::Convert:
    return n->text != "tl_real";
  case Node::Leaf:
    return n->slot->integer;
  case Node::Carried:
  case Node::Final:
    return isInteger(n->of->carried[size_t(n->which)].init);
  case Node::Select:
    return isInteger(n->args[1]);
  default:
    return false;
  }
}

bool isOperation(const Node *n) {
  return n->op == Node::Add || n->op == Node::Mul || n->op == Node::Recip || n->op == Node::Math || n->op == Node::Taylor;
}

Graph::Scaled Graph::scaled(Node *n) {
  if (n->isNumber()) return {n->value, nullptr};
  if (n->op == Node::Mul && n->args[0]->isNumber()) return {n->args[0]->value, n->args[1]};
  return {1, n};
}

bool Graph::covers(const Guard *outer, const Guard *inner) {
  for (; inner; inner = inner->outer)
    if (inner == outer) return true;
  return !outer;
}

const Guard *Graph::under(const Guard *outer, Node *condition, const Guard *of) {
  Node *holds = outer ? logicalAnd(outer->holds, condition) : condition;
  for (const Guard &g : guards_)
    if (g.outer == outer && g.holds == holds) return &g;
  return &guards_.emplace_back(Guard{outer, holds, of});
}

const Guard *Graph::remade(const Guard *of, const std::function<Node *(Node *)> &other) {
  if (!of) return nullptr;
  Node *condition = other(of->holds);
  return condition == of->holds ? of : under(remade(of->outer, other), condition, of->of ? of->of : of);
}

// What is there already. An operation under the same condition of other values is another one: it has no condition that both know.
Node *Graph::find(const std::string &key) const {
  for (auto [known, end] = known_.equal_range(key); known != end; ++known)
    if (!isOperation(known->second) || !isRemade(known->second->guard, guard)) return known->second;
  return nullptr;
}

// Without sharing, too, values that are no operations are there once: other parts compare or index by them.
Node *Graph::make(Node n) {
  std::string key = keyOf(n);
  Node *old = sharing || !isOperation(&n) ? find(key) : nullptr;
  if (old) {
    if (!covers(old->guard, guard)) old->guard = common(old->guard, guard);
    return old;
  }
  n.id = int(nodes_.size());
  n.loc = loc;
  n.name = name;
  if (n.op == Node::Carried) n.loop = n.of;
  if (n.op == Node::Final) n.loop = n.of->outer;
  if (n.op == Node::Read) n.loop = n.array->home;
  for (auto &[loop, factor] : n.terms) n.loop = deeper(n.loop, loop);
  for (const Node *arg : n.args) n.loop = deeper(n.loop, arg->loop);
  n.fixed = isFixed(n);
  n.guard = visible(guard, n.loop);
  Node *made = &nodes_.emplace_back(std::move(n));
  known_.emplace(std::move(key), made);
  return made;
}

const Slot *Graph::slot(Slot s) {
  for (const Slot &known : slots_)
    if (known.kind == s.kind && known.text == s.text) return &known;
  return &slots_.emplace_back(std::move(s));
}

Node *Graph::number(double value) {
  Node n(Node::Number);
  n.value = value == 0 ? 0 : value;
  return make(std::move(n));
}

Node *Graph::affine(long offset, std::vector<std::pair<Loop *, long>> terms) {
  Node n(Node::Affine);
  n.offset = offset;
  std::map<int, std::pair<Loop *, long>> sum;
  for (auto &[loop, factor] : terms) {
    sum[loop->id].first = loop;
    sum[loop->id].second += factor;
  }
  for (auto &[id, term] : sum)
    if (term.second) n.terms.push_back(term);
  return make(std::move(n));
}

Node *Graph::leaf(const Slot *slot, std::vector<Node *> indices) {
  Node n(Node::Leaf);
  n.slot = slot;
  n.args = std::move(indices);
  return make(std::move(n));
}

Node *Graph::add(Node *a, Node *b) {
  if (a->is(0)) return b;
  if (b->is(0)) return a;
  if (a->isNumber() && b->isNumber()) return number(a->value + b->value);
  Scaled x = scaled(a), y = scaled(b);
  if (x.rest == y.rest) return scale(x.factor + y.factor, x.rest);
  if (Node *merged = simplifying ? mergedSum(a, b) : nullptr) return merged;
  if (isNegation(a) && isNegation(b)) return neg(add(x.rest, y.rest));
  if (a->fixed && b->fixed)
    if (Node *product = factoredSum(x, y)) return product;
  return plainSum(a, b);
}

Node *Graph::plainSum(Node *a, Node *b) {
  Node n(Node::Add);
  n.args = {a, b};
  if (isNegation(a) || (!isNegation(b) && b->id < a->id)) std::swap(n.args[0], n.args[1]);
  return make(std::move(n));
}

Node *Graph::plainProduct(Node *a, Node *b) {
  Node n(Node::Mul);
  n.args = {a, b};
  if (b->isNumber()) std::swap(n.args[0], n.args[1]);
  return make(std::move(n));
}

Node *Graph::scaledNode(const Scaled &s) {
  if (!s.rest || s.factor == 0) return number(s.factor);
  if (s.factor == 1) return s.rest;
  if (s.factor == -1 && s.rest->op == Node::Add && isNegation(s.rest->args[1]))
    return add(s.rest->args[1]->args[1], neg(s.rest->args[0]));
  Node n(Node::Mul);
  n.args = {number(s.factor), s.rest};
  return make(std::move(n));
}

// Products are kept in one order of their factors, so that those of the same factors are the same and cancel in sums: numbers that do
// not move first, then functions, inputs, and what was computed.
Node *Graph::mul(Node *a, Node *b) {
  Scaled x = scaled(a), y = scaled(b);
  double factor = x.factor * y.factor;
  if (factor == 0) return number(0);
  if (!x.rest || !y.rest) return scaledNode({factor, x.rest ? x.rest : y.rest});
  std::vector<Node *> factors;
  const size_t most = 8;
  factorsOf(x.rest, factors);
  factorsOf(y.rest, factors);
  if (factors.size() > most || !simplifying) factors = {x.rest, y.rest};
  std::sort(factors.begin(), factors.end(),
            [](const Node *l, const Node *r) { return std::make_pair(rank(l), l->id) < std::make_pair(rank(r), r->id); });
  Node *product = factors[0];
  for (size_t k = 1; k < factors.size(); ++k) {
    Node n(Node::Mul);
    n.args = {product, factors[k]};
    product = make(std::move(n));
  }
  return scaledNode({factor, product});
}

int Graph::rank(const Node *n) {
  if (n->fixed) return 0;
  if (n->op == Node::Leaf) return n->slot->kind == Slot::Member ? 0 : 2;
  return n->op == Node::Math || n->op == Node::Recip ? 1 : 3;
}

void Graph::factorsOf(Node *n, std::vector<Node *> &to) {
  if (n->op == Node::Mul && !n->args[0]->isNumber()) {
    factorsOf(n->args[0], to);
    factorsOf(n->args[1], to);
  } else {
    to.push_back(n);
  }
}

Node *Graph::recip(Node *a, const std::string &of) {
  if (a->isNumber() && a->value != 0) return number(1 / a->value);
  if (a->op == Node::Recip && of.empty()) return a->args[0];
  Scaled x = scaled(a);
  if (x.rest && x.factor != 1 && (x.factor > 0 || of.empty())) return scale(1 / x.factor, recip(x.rest, of));
  Node n(Node::Recip);
  n.text = of;
  n.args = {a};
  return make(std::move(n));
}

namespace {

using Unary = double (*)(double);

double folded(const std::string &function, double x) {
  static const std::map<std::string, Unary> known = {
      {"sin", std::sin},   {"cos", std::cos},     {"tan", std::tan},     {"asin", std::asin},   {"acos", std::acos},
      {"atan", std::atan}, {"sinh", std::sinh},   {"cosh", std::cosh},   {"tanh", std::tanh},   {"exp", std::exp},
      {"log", std::log},   {"sqrt", std::sqrt},   {"cbrt", std::cbrt},   {"fabs", std::fabs},   {"floor", std::floor},
      {"ceil", std::ceil}, {"expm1", std::expm1}, {"log1p", std::log1p}, {"trunc", std::trunc}, {"asinh", std::asinh}};
  auto f = known.find(function);
  return f == known.end() ? NAN : f->second(x);
}

// x^n for a whole n > 0 by squaring.
Node *wholePower(Graph &g, Node *x, int n) {
  if (n == 1) return x;
  Node *half = wholePower(g, x, n / 2), *square = g.mul(half, half);
  return n % 2 ? g.mul(square, x) : square;
}

} // namespace

Node *Graph::math(const std::string &function, std::vector<Node *> args) {
  Node *x = args[0];
  if (args.size() == 1 && x->isNumber()) {
    double value = folded(function, x->value);
    if (std::isfinite(value)) return number(value);
  }
  if (function == "tl_power" && (args[1]->isNumber() || args[1]->isConstant())) return power(x, args[1], int(args[2]->offset));
  if (function == "pow" && args[1]->isConstant()) args[1] = number(double(args[1]->offset));
  if (function == "pow" && args[1]->isNumber()) {
    double e = args[1]->value;
    if (e == 0) return number(1);
    if (e == 0.5) return math("sqrt", {x});
    if (e == std::floor(e) && std::fabs(e) <= 16) return e > 0 ? wholePower(*this, x, int(e)) : recip(wholePower(*this, x, int(-e)));
  }
  if (function == "sin" && isNegation(x)) return neg(math("sin", {x->args[1]}));
  if ((function == "cos" || function == "fabs") && isNegation(x)) return math(function, {x->args[1]});
  Node n(Node::Math);
  n.text = function;
  n.args = std::move(args);
  return make(std::move(n));
}

// Functions with signs in their derivatives.
static const char *const kinked[] = {"", "copysign", "fabs", "fdim", "fmax", "fmin"};

std::string sourceFunction(const Node *n) {
  if (n->op == Node::Recip) return n->text.empty() ? "div" : n->text;
  return n->op == Node::Math && n->which ? kinked[n->which] : n->text;
}

Node *Graph::sign(Node *a, const std::string &of) {
  if (a->isNumber() && a->value != 0) return number(a->value < 0 ? -1 : 1);
  Scaled x = scaled(a);
  if (x.rest && x.factor != 1) return scale(x.factor < 0 ? -1 : 1, sign(x.rest, of));
  Node n(Node::Math);
  n.text = "copysign";
  n.which = int(std::find(std::begin(kinked), std::end(kinked), of) - std::begin(kinked));
  n.args = {number(1), a};
  return make(std::move(n));
}

Node *Graph::power(Node *x, Node *exponent, int k) {
  if (k == 0) return math("pow", {x, exponent});
  if (!exponent->isNumber() && !exponent->isConstant()) return math("tl_power", {x, exponent, integer(k)});
  const double e = exponent->isNumber() ? exponent->value : double(exponent->offset);
  return scale(e, power(x, number(e - 1), k - 1));
}

Node *Graph::taylor(const std::string &function, int order, std::vector<Node *> args) {
  Node n(Node::Taylor);
  n.text = function;
  n.which = order;
  n.args = std::move(args);
  return make(std::move(n));
}

Node *Graph::convert(const std::string &type, Node *a) {
  if (a->isNumber() && type != "tl_real" && std::fabs(a->value) < 1e15) return integer(long(a->value));
  if (a->isConstant() && type == "tl_real") return number(double(a->offset));
  Node n(Node::Convert);
  n.text = type;
  n.args = {a};
  return make(std::move(n));
}

Node *Graph::integerOp(const std::string &op, Node *a, Node *b) {
  if (a->op == Node::Affine && b->op == Node::Affine) {
    long sign = op == "-" ? -1 : 1;
    if (op == "+" || op == "-") {
      auto terms = a->terms;
      for (auto &[loop, factor] : b->terms) terms.push_back({loop, sign * factor});
      return affine(a->offset + sign * b->offset, std::move(terms));
    }
    if (op == "*" && (a->isConstant() || b->isConstant())) {
      if (!b->isConstant()) std::swap(a, b);
      auto terms = a->terms;
      for (auto &term : terms) term.second *= b->offset;
      return affine(a->offset * b->offset, std::move(terms));
    }
    if (a->isConstant() && b->isConstant() && b->offset != 0 && op == "/") return integer(a->offset / b->offset);
    if (a->isConstant() && b->isConstant() && b->offset != 0 && op == "%") return integer(a->offset % b->offset);
  }
  Node n(Node::Integer);
  n.text = op;
  n.args = {a, b};
  return make(std::move(n));
}

Node *Graph::compare(const std::string &op, Node *a, Node *b) {
  if (op == ">") return compare("<", b, a);
  if (op == ">=") return compare("<=", b, a);
  if (op == "!=") return logicalNot(compare("==", a, b));
  if ((a->isNumber() && b->isNumber()) || (a->isConstant() && b->isConstant())) {
    double x = a->isNumber() ? a->value : double(a->offset), y = b->isNumber() ? b->value : double(b->offset);
    return integer(op == "<" ? x < y : op == "<=" ? x <= y : x == y);
  }
  if (op == "==" && b->id < a->id) std::swap(a, b);
  Node n(Node::Compare);
  n.text = op;
  n.args = {a, b};
  return make(std::move(n));
}

Node *Graph::logicalNot(Node *a) {
  if (a->isConstant()) return integer(!a->offset);
  if (a->op == Node::Not) return a->args[0];
  Node n(Node::Not);
  n.args = {a};
  return make(std::move(n));
}

Node *Graph::logicalAnd(Node *a, Node *b) {
  if (a->isConstant()) return a->offset ? b : a;
  if (b->isConstant()) return b->offset ? a : b;
  if (a == b) return a;
  Node n(Node::Conjunction);
  n.args = {a, b};
  return make(std::move(n));
}

Node *Graph::logicalOr(Node *a, Node *b) {
  if (a->isConstant()) return a->offset ? a : b;
  if (b->isConstant()) return b->offset ? b : a;
  if (a == b) return a;
  Node n(Node::Disjunction);
  n.args = {a, b};
  return make(std::move(n));
}

Node *Graph::select(Node *condition, Node *a, Node *b) {
  if (condition->isConstant()) return condition->offset ? a : b;
  if (condition->op == Node::Not) return select(condition->args[0], b, a);
  if (a == b) return a;
  Node n(Node::Select);
  n.args = {condition, a, b};
  return make(std::move(n));
}

Loop *Graph::loop(Loop *outer, Node *trips, bool down) {
  Loop *l = &loops_.emplace_back(Loop{int(loops_.size()), outer, trips, nullptr, down, nullptr, {}});
  l->index = affine(0, {{l, 1}});
  return l;
}

Node *Graph::carry(Loop *loop, Node *init) {
  Node n(Node::Carried);
  n.of = loop;
  n.which = int(loop->carried.size());
  Node *in = make(std::move(n));
  loop->carried.push_back({init, in, in});
  return in;
}

Node *Graph::final(Loop *loop, int which) {
  const Carry &carry = loop->carried[size_t(which)];
  if (carry.out == carry.in) return carry.init;
  Node n(Node::Final);
  n.of = loop;
  n.which = which;
  return make(std::move(n));
}

Array *Graph::array(const std::string &label, long length) {
  return &arrays_.emplace_back(Array{int(arrays_.size()), label, length, false, false, nullptr, {}});
}

Node *Graph::read(Array *array, Node *index) {
  Node n(Node::Read);
  n.array = array;
  n.args = {index};
  return make(std::move(n));
}

Array *Graph::runningSums(Node *value, const Loop *of) {
  Loop *&adding = adding_[{of->trips, of->down}];
  if (!adding) adding = loop(nullptr, of->trips, of->down);
  Replacement there = {{of->index, adding->index}};
  value = replace(value, there);
  Array *&sums = sums_[value];
  if (!sums) {
    Node *in = carry(adding, number(0)), *out = add(in, value);
    setOut(in, out);
    sums = array("sums", of->trips->offset);
    write(sums, adding, adding->index, out);
  }
  return sums;
}

Node *Graph::rebuild(Node *n, std::vector<Node *> args) {
  switch (n->op) {
  case Node::Leaf:
    return leaf(n->slot, std::move(args));
  case Node::Read:
    return read(n->array, args[0]);
  case Node::Add:
    return add(args[0], args[1]);
  case Node::Mul:
    return mul(args[0], args[1]);
  case Node::Recip:
    return recip(args[0], n->text);
  case Node::Math:
    return n->which ? sign(args[1], kinked[n->which]) : math(n->text, std::move(args));
  case Node::Taylor:
    return taylor(n->text, n->which, std::move(args));
  case Node::Convert:
    return convert(n->text, args[0]);
  case Node::Integer:
    return integerOp(n->text, args[0], args[1]);
  case Node::Compare:
    return compare(n->text, args[0], args[1]);
  case Node::Not:
    return logicalNot(args[0]);
  case Node::Conjunction:
    return logicalAnd(args[0], args[1]);
  case Node::Disjunction:
    return logicalOr(args[0], args[1]);
  case Node::Select:
    return select(args[0], args[1], args[2]);
  case Node::Number:
  case Node::Affine:
  case Node::Carried:
  case Node::Final:
    break;
  }
  return n;
}

Node *Graph::replace(Node *node, Replacement &by) {
  auto known = by.find(node);
  if (known != by.end()) return known->second;
  Node *result = node;
  if (node->op == Node::Affine) {
    result = integer(node->offset);
    for (auto &[loop, factor] : node->terms) {
      auto index = by.find(loop->index);
      Node *term = index == by.end() ? loop->index : index->second;
      result = integerOp("+", result, integerOp("*", integer(factor), term));
    }
  } else {
    std::vector<Node *> args;
    for (Node *arg : node->args) args.push_back(replace(arg, by));
    if (args != node->args) {
      loc = node->loc;
      result = rebuild(node, std::move(args));
    }
  }
  return by[node] = result;
}

} // namespace tlgen
