// Derivatives and domains of the elementary functions, as values.
#include "Graph.h"

#include <cmath>
#include <functional>

namespace tlgen {
namespace {

using Formula = std::function<Node *(Graph &, Node *x, Node *y)>; // y: the function's value at x

Node *onePlus(Graph &g, Node *x) { return g.add(g.number(1), x); }
Node *oneMinus(Graph &g, Node *x) { return g.sub(g.number(1), x); }
Node *square(Graph &g, Node *x) { return g.mul(x, x); }
Node *oneMinusSquare(Graph &g, Node *x) {
  Node *sum = onePlus(g, x), *difference = oneMinus(g, x);
  return g.mul(difference, sum);
}
Node *root(Graph &g, Node *x) { return g.math("sqrt", {x}); }
Node *rootOfSquareMinusOne(Graph &g, Node *x) { // for x > 1 alone
  Node *sum = root(g, onePlus(g, x)), *difference = root(g, g.sub(x, g.number(1)));
  return g.mul(difference, sum);
}
Node *beyondOne(Graph &g, Node *x) {
  Node *one = g.number(1);
  return g.compare(">=", g.math("fabs", {x}), one);
}
Node *notPositive(Graph &g, Node *x) { return g.compare("<=", x, g.number(0)); }
Node *isZero(Graph &g, Node *x) { return g.compare("==", x, g.number(0)); }

struct Function {
  Formula derivative;
  Formula outside; // null: defined everywhere
};

const double LN2 = 0.693147180559945309417, LN10 = 2.30258509299404568402, TWO_BY_ROOT_PI = 1.12837916709551257390;

const std::map<std::string, Function> &ofOne() {
  auto zero = [](Graph &g, Node *, Node *) { return g.number(0); };
  auto positive = [](Graph &g, Node *x, Node *) { return notPositive(g, x); };
  auto bell = [](Graph &g, Node *x) { return g.scale(TWO_BY_ROOT_PI, g.math("exp", {g.neg(square(g, x))})); };
  static const std::map<std::string, Function> table = {
      {"sin", {[](Graph &g, Node *x, Node *) { return g.math("cos", {x}); }, nullptr}},
      {"cos", {[](Graph &g, Node *x, Node *) { return g.neg(g.math("sin", {x})); }, nullptr}},
      {"tan", {[](Graph &g, Node *, Node *y) { return onePlus(g, square(g, y)); }, nullptr}},
      {"asin",
       {[](Graph &g, Node *x, Node *) { return g.recip(root(g, oneMinusSquare(g, x))); },
        [](Graph &g, Node *x, Node *) { return beyondOne(g, x); }}},
      {"acos",
       {[](Graph &g, Node *x, Node *) { return g.neg(g.recip(root(g, oneMinusSquare(g, x)))); },
        [](Graph &g, Node *x, Node *) { return beyondOne(g, x); }}},
      {"atan", {[](Graph &g, Node *x, Node *) { return g.recip(onePlus(g, square(g, x))); }, nullptr}},
      {"sinh", {[](Graph &g, Node *x, Node *) { return g.math("cosh", {x}); }, nullptr}},
      {"cosh", {[](Graph &g, Node *x, Node *) { return g.math("sinh", {x}); }, nullptr}},
      {"tanh", {[](Graph &g, Node *x, Node *) { return square(g, g.recip(g.math("cosh", {x}))); }, nullptr}},
      {"asinh", {[](Graph &g, Node *x, Node *) { return g.recip(root(g, onePlus(g, square(g, x)))); }, nullptr}},
      {"acosh",
       {[](Graph &g, Node *x, Node *) { return g.recip(rootOfSquareMinusOne(g, x)); },
        [](Graph &g, Node *x, Node *) { return g.compare("<=", x, g.number(1)); }}},
      {"atanh",
       {[](Graph &g, Node *x, Node *) { return g.recip(oneMinusSquare(g, x), "atanh"); },
        [](Graph &g, Node *x, Node *) { return beyondOne(g, x); }}},
      {"exp", {[](Graph &, Node *, Node *y) { return y; }, nullptr}},
      {"exp2", {[](Graph &g, Node *, Node *y) { return g.scale(LN2, y); }, nullptr}},
      {"expm1", {[](Graph &g, Node *x, Node *) { return g.math("exp", {x}); }, nullptr}},
      {"log", {[](Graph &g, Node *x, Node *) { return g.recip(x, "log"); }, positive}},
      {"log2", {[](Graph &g, Node *x, Node *) { return g.scale(1 / LN2, g.recip(x, "log2")); }, positive}},
      {"log10", {[](Graph &g, Node *x, Node *) { return g.scale(1 / LN10, g.recip(x, "log10")); }, positive}},
      {"log1p",
       {[](Graph &g, Node *x, Node *) { return g.recip(onePlus(g, x), "log1p"); },
        [](Graph &g, Node *x, Node *) { return g.compare("<=", x, g.number(-1)); }}},
      {"sqrt", {[](Graph &g, Node *, Node *y) { return g.scale(0.5, g.recip(y)); }, positive}},
      {"cbrt",
       {[](Graph &g, Node *, Node *y) { return g.scale(1.0 / 3, square(g, g.recip(y))); },
        [](Graph &g, Node *x, Node *) { return isZero(g, x); }}},
      {"erf", {[bell](Graph &g, Node *x, Node *) { return bell(g, x); }, nullptr}},
      {"erfc", {[bell](Graph &g, Node *x, Node *) { return g.neg(bell(g, x)); }, nullptr}},
      {"fabs", {[](Graph &g, Node *x, Node *) { return g.sign(x, "fabs"); }, [](Graph &g, Node *x, Node *) { return isZero(g, x); }}},
      {"floor", {zero, nullptr}},
      {"ceil", {zero, nullptr}},
      {"trunc", {zero, nullptr}},
      {"round", {zero, nullptr}},
      {"rint", {zero, nullptr}},
      {"nearbyint", {zero, nullptr}},
  };
  return table;
}

int orderOf(const Node *power) { return power->text == "pow" ? 0 : int(power->args[2]->offset); }

// y is the k-th derivative of x^e in x. Its own in e: the k-th of x^e log x, by Leibniz' rule.
Node *ofPower(Graph &g, Node *y, size_t argument) {
  Node *x = y->args[0], *e = y->args[1];
  const int k = orderOf(y);
  if (argument == 0) return g.power(x, e, k + 1);
  Node *sum = g.mul(y, g.math("log", {x})), *inverse = g.number(1);
  double falling = -1; // -k * -(k-1) .. -(k-j+1), negated
  for (int j = 1; j <= k; ++j) {
    falling *= j - 1 - k;
    inverse = g.mul(inverse, g.recip(x));
    sum = g.add(sum, g.scale(falling / j, g.mul(inverse, g.power(x, e, k - j))));
  }
  return sum;
}

Node *copysignSlope(Graph &g, Node *a, Node *b) {
  Node *signOfB = g.sign(b, "copysign"), *signOfA = g.sign(a, "copysign");
  return g.mul(signOfA, signOfB);
}

// Functions of two and more numbers.
Node *ofMany(Graph &g, Node *y, size_t argument) {
  const std::string &f = y->text;
  Node *a = y->args[0], *b = y->args[1], *one = g.number(1), *zero = g.number(0);
  if (f == "pow" || f == "tl_power") return argument < 2 ? ofPower(g, y, argument) : nullptr;
  if (f == "hypot") return g.div(y->args[argument], y);
  if (f == "atan2") {
    Node *second = square(g, b), *first = square(g, a), *r = g.recip(g.add(first, second));
    return argument == 0 ? g.mul(b, r) : g.neg(g.mul(a, r));
  }
  if (f == "fma") return argument == 2 ? one : y->args[1 - argument];
  if (f == "fmin" || f == "fmax" || f == "fdim") { // one half and one half of a sign
    const bool rising = f == "fdim" || (f == "fmin") == (argument == 1);
    Node *half = g.scale(rising ? 0.5 : -0.5, g.sign(g.sub(a, b), f)), *slope = g.add(g.number(0.5), half);
    return f == "fdim" && argument == 1 ? g.neg(slope) : slope;
  }
  if (f == "copysign") return argument == 1 ? zero : copysignSlope(g, a, b);
  if (f == "fmod" || f == "remainder") return argument == 0 ? one : g.neg(g.math("rint", {g.div(g.sub(a, y), b)}));
  if (f == "ldexp" || f == "scalbn" || f == "scalbln") return argument == 1 ? nullptr : g.math(f, {one, b});
  return nullptr;
}

// Literal exponents: whole ones take every x, but no 0 where they are negative; others no x < 0.
Node *outsideOfPower(Graph &g, Node *y) {
  Node *x = y->args[0], *e = y->args[1];
  if (!e->isNumber()) return g.logicalNot(g.math("tl_power_exists", {x, e, g.integer(orderOf(y))}));
  if (e->value < 0) return e->value == std::floor(e->value) ? isZero(g, x) : notPositive(g, x);
  return e->value == std::floor(e->value) ? nullptr : g.compare("<", x, g.number(0));
}

} // namespace

Node *derivative(Graph &graph, Node *math, size_t argument) {
  if (math->op == Node::Taylor) return math->args.size() == 1 ? graph.taylor(math->text, math->which + 1, math->args) : nullptr;
  if (math->args.size() > 1) return ofMany(graph, math, argument);
  auto known = ofOne().find(math->text);
  return known == ofOne().end() ? nullptr : known->second.derivative(graph, math->args[0], math);
}

Node *outsideDomain(Graph &graph, Node *math) {
  Node *x = math->args.empty() ? nullptr : math->args[0];
  if (math->op == Node::Recip) return math->text.empty() ? isZero(graph, x) : notPositive(graph, x);
  if (math->op != Node::Math) return nullptr;
  const std::string &f = math->text;
  if (math->args.size() == 1) {
    auto known = ofOne().find(f);
    return known == ofOne().end() || !known->second.outside ? nullptr : known->second.outside(graph, x, math);
  }
  Node *y = math->args[1];
  if (f == "pow" || f == "tl_power") return outsideOfPower(graph, math);
  if (f == "hypot") return isZero(graph, math);
  if (f == "fmin" || f == "fmax" || f == "fdim") return graph.compare("==", x, y);
  if (f == "copysign" && x->isNumber()) return math->which ? isZero(graph, y) : nullptr;
  if (f == "atan2" || f == "copysign") {
    Node *second = isZero(graph, y), *first = isZero(graph, x);
    return f == "atan2" ? graph.logicalAnd(first, second) : graph.logicalOr(first, second);
  }
  if (f == "fmod" || f == "remainder") return isZero(graph, y);
  return nullptr;
}

} // namespace tlgen
