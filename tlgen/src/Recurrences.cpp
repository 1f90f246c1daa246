// Recurrences of sums, products, reciprocals and elementary functions, as C.
#include "Recurrences.h"
#include "PrintC.h"
#include "Trace.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tlgen {
namespace {

// Values that take part: more make code that compilers take minutes for, and that no cache holds.
const size_t mostValues = 1500;
const long mostPower = 8; // as products

std::string str(long n) { return std::to_string(n); }

// Functions of one argument with a recurrence of their own.
bool hasRecurrence(const std::string &function) {
  static const std::set<std::string> known = {"sin", "cos", "sinh", "cosh", "exp", "log", "sqrt", "cbrt", "tan", "atan"};
  return known.count(function) > 0;
}

bool isPower(const Node *n) { return n->op == Node::Math && (n->text == "pow" || n->text == "tl_power"); }

// The function that the recurrence of another one needs beside it.
std::string partner(const std::string &function) {
  static const std::map<std::string, std::string> partners = {{"sin", "cos"}, {"cos", "sin"}, {"sinh", "cosh"}, {"cosh", "sinh"}};
  auto known = partners.find(function);
  return known == partners.end() ? "" : known->second;
}

// Of a root and whole powers.
bool hasRoot(double exponent) { return std::fabs(exponent) < mostPower && exponent - std::floor(exponent) == 0.5; }

long differentiated(const Node *power) { return power->text == "tl_power" ? power->args[2]->offset : 0; }

} // namespace

Recurrences::Recurrences(Graph &graph, std::vector<Node *> accelerations) : graph_(graph), accelerations_(std::move(accelerations)) {
  rows_ = 2 * long(accelerations_.size()); // of q, then of qd
  for (Node *&a : accelerations_) a = prepared(a);
  for (Node *a : accelerations_) add(a);
  later_ = makeLater();
}

// Whether the value is another one from state to state.
bool Recurrences::varies(const Node *n) const {
  auto known = varies_.find(n);
  if (known != varies_.end()) return known->second;
  bool is = n->op == Node::Leaf && n->slot->kind != Slot::Member;
  for (const Node *arg : n->args) is = varies(arg) || is;
  return varies_[n] = is;
}

// Roots, reciprocals, and products of powers of one base, as a power of it.
Recurrences::Power Recurrences::powerOf(Node *n) {
  if (n->op == Node::Math && n->text == "sqrt") return {n->args[0], 0.5};
  if (n->op == Node::Recip) {
    const Power of = powerOf(n->args[0]);
    return {of.base, -of.exponent};
  }
  if (n->op == Node::Mul) {
    const Power a = powerOf(n->args[0]), b = powerOf(n->args[1]);
    if (a.base == b.base) return {a.base, a.exponent + b.exponent};
  }
  return {n, 1};
}

// The same value, where powers with few factors are products and hypot is a root: their recurrences divide by nothing. One over a
// root's cube, or a higher odd power, is one power in the place of at least three other recurrences, each of which waits for the one
// before.
Node *Recurrences::prepared(Node *n) {
  auto known = prepared_.find(n);
  if (known != prepared_.end()) return known->second;
  if (!varies(n)) return n;
  if (n->loop || n->op == Node::Carried || n->op == Node::Final || n->op == Node::Read)
    throw Unsuitable{"a value depends on a loop", n->loc};
  std::vector<Node *> args;
  for (Node *arg : n->args) args.push_back(prepared(arg));
  Graph::Making making(graph_, nullptr, n->loc);
  Node *made = nullptr;
  if (isPower(n) && n->args[1]->isNumber() && (n->text == "pow" || n->args[2]->isConstant())) {
    const double exponent = n->args[1]->value, left = exponent - double(differentiated(n));
    if (left == double(long(left)) && left >= 0 && left <= mostPower) {
      double factor = 1;
      for (long i = 0; i < differentiated(n); ++i) factor *= exponent - double(i);
      made = graph_.number(factor);
      for (long i = 0; i < long(left); ++i) made = graph_.mul(made, args[0]);
    }
  }
  if (n->op == Node::Math && n->text == "hypot") {
    Node *square = graph_.mul(args[0], args[0]), *other = graph_.mul(args[1], args[1]);
    made = graph_.math("sqrt", {graph_.add(square, other)});
  }
  if (!made) made = args == n->args ? n : graph_.rebuild(n, args);
  const Power power = powerOf(made);
  if (made->op == Node::Mul && power.exponent < -1 && hasRoot(power.exponent))
    made = graph_.math("pow", {power.base, graph_.number(power.exponent)});
  prepared_[made] = made;
  return prepared_[n] = made;
}

// What the slopes of tan and atan are made of: tan' = 1 + tan^2, atan' = 1/(1 + a^2).
Node *Recurrences::onePlusSquare(Node *x) const {
  Node *square = graph_.mul(x, x);
  return graph_.add(square, graph_.number(1));
}

// ---- which values and rows there are ----

void Recurrences::add(Node *n) {
  if (values_.count(n) || n->isNumber()) return;
  if (!varies(n)) {
    if (fixedNumbers_.emplace(n, fixed_.size()).second) fixed_.push_back(n);
    return;
  }
  if (n->op == Node::Leaf) {
    if (n->slot->kind != Slot::T && !(n->args.size() == 1 && n->args[0]->isConstant()))
      throw Unsuitable{"which coordinate is read depends on a loop", n->loc};
  } else if (n->op == Node::Math) {
    return addMath(n);
  } else if (n->op != Node::Add && n->op != Node::Mul && n->op != Node::Recip) {
    throw Unsuitable{"a value depends on a choice by the state, or is rounded", n->loc};
  }
  if (n->op != Node::Leaf)
    for (Node *arg : n->args) add(arg);
  if (values_.size() >= mostValues) throw Unsuitable{"the recurrences would be too many", n->loc};
  Value &v = values_[n];
  v.node = n;
  v.place = long(order_.size());
  order_.push_back(n);
  if (n->op == Node::Mul && varies(n->args[0]) && varies(n->args[1])) needProduct(n->args[0], n->args[1]);
  if (n->op == Node::Recip) needForward(n->args[0]), needForward(n), needSecond(n);
}

void Recurrences::addMath(Node *n) {
  const bool power = isPower(n) && !varies(n->args[1]);
  if (!power && !(hasRecurrence(n->text) && n->args.size() == 1))
    throw Unsuitable{"there is no recurrence for '" + (n->text == "tl_power" ? "pow" : n->text) + "'", n->loc};
  for (Node *arg : n->args)
    if (!isInteger(arg)) add(arg);
  Graph::Making making(graph_, nullptr, n->loc);
  std::vector<Node *> made = {n};
  if (!partner(n->text).empty()) {
    Node *other = graph_.math(partner(n->text), n->args);
    if (!values_.count(other)) made.push_back(other);
  }
  if (n->text == "tan") { // 1 + tan^2
    Node *sum = onePlusSquare(n);
    made.push_back(graph_.mul(n, n)), made.push_back(sum);
  }
  if (n->text == "atan") add(onePlusSquare(n->args[0]));
  for (Node *m : made) {
    if (values_.count(m)) continue;
    varies_[m] = true;
    if (m->op != Node::Math) {
      for (Node *arg : m->args) add(arg);
    }
    Value &v = values_[m];
    v.node = m;
    v.place = long(order_.size());
    order_.push_back(m);
  }
  const Node *a = n->args[0];
  for (Node *m : made) {
    if (m->op == Node::Mul) needProduct(m->args[0], m->args[1]);
    if (m->op == Node::Math && m->text != "log" && m->text != "atan" && m->text != "tan") needForward(m), needSecond(m);
  }
  if (n->text == "sqrt") needOnce(n);
  if (n->text == "log") needWeighted(n), needForward(a), needSecond(a), needOnce(n);
  if (n->text == "atan") {
    const Node *sum = onePlusSquare(n->args[0]);
    needWeighted(n), needForward(sum), needSecond(sum), needOnce(n);
  }
  if (n->text == "tan") needWeighted(a), needForward(made.back()), needSecond(made.back());
  if (n->text == "exp" || !partner(n->text).empty()) needWeighted(a);
  if (power || n->text == "cbrt") needWeighted(a), needForward(a), needOnce(n);
}

void Recurrences::needForward(const Node *n) {
  Value &v = value(n);
  if (v.forward < 0) v.forward = rows_++;
}
void Recurrences::needSecond(const Node *n) {
  needForward(n);
  value(n).second = true;
}
void Recurrences::needWeighted(const Node *n) {
  Value &v = value(n);
  if (v.weighted < 0) v.weighted = rows_++;
}
void Recurrences::needOnce(const Node *n) {
  Value &v = value(n);
  if (v.once < 0) v.once = onces_++;
}

// The second factor: better one that is so already.
void Recurrences::needProduct(const Node *a, const Node *b) {
  needForward(a), needForward(b);
  if (!value(a).second) needSecond(b);
}

// ---- text ----

long Recurrences::workspace() const { return older() + 4 * long(pairs_.size()); }

std::string Recurrences::row(long number) const { return "x + " + str(number * rowLength); }

std::string Recurrences::fixedText(const Node *n) const {
  return n->isNumber() ? operand({realConstant(n->value), n->value < 0 ? Prefix : Primary}, Product)
                       : "fixed[" + str(long(fixedNumbers_.at(n))) + "]";
}

std::string Recurrences::operandText(const Node *n) const { return varies(n) ? value(n).name() : fixedText(n); }

// The row of a coordinate or velocity, which is ahead of the orders that are computed.
long Recurrences::state(const Node *leaf) const {
  return leaf->args[0]->offset + (leaf->slot->kind == Slot::Q ? 0 : long(accelerations_.size()));
}

// sum_(j=1..k-1) of the row a and b.
std::string Recurrences::between(long a, const Node *b) {
  const std::pair<long, long> pair = {a * rowLength, value(b).forward * rowLength};
  auto known = std::find(pairs_.begin(), pairs_.end(), pair);
  const long number = known - pairs_.begin();
  if (known == pairs_.end()) pairs_.push_back(pair);
  return "tl_series_between(" + row(a) + ", " + row(value(b).forward) + ", older + " + str(4 * number) + ", k, place, first)";
}

// After the rows, in front of what is older.
std::string Recurrences::once(const Value &v) const { return "x[" + str(rows_ * rowLength + v.once) + "]"; }

// Coefficient 0.
std::string Recurrences::initial(const Value &v) const {
  const Node *n = v.node;
  switch (n->op) {
  case Node::Leaf:
    return n->slot->kind == Slot::T ? "t" : (n->slot->kind == Slot::Q ? "q[" : "qd[") + str(n->args[0]->offset) + "]";
  case Node::Add:
    return operandText(n->args[0]) + " + " + operandText(n->args[1]);
  case Node::Mul:
    return operandText(n->args[0]) + " * " + operandText(n->args[1]);
  case Node::Recip:
    return "TL_C(1.0) / " + operandText(n->args[0]);
  default: {
    if (n->text == "pow" && n->args[1]->isNumber() && n->args[1]->value < 0 && hasRoot(n->args[1]->value)) {
      const std::string base = operandText(n->args[0]);
      std::string product = "TL_LIBM(sqrt)(" + base + ")";
      for (double left = n->args[1]->value; left < -1; ++left) product = base + " * " + product;
      return "TL_C(1.0) / (" + product + ")";
    }
    std::string args;
    for (const Node *arg : n->args) args += (args.empty() ? "" : ", ") + (arg->isConstant() ? str(arg->offset) : operandText(arg));
    return mathText(n->text, args).s;
  }
  }
}

// What is computed once beside it: one over what the recurrence divides by.
std::string Recurrences::onceText(const Value &v) const {
  const std::string &function = v.node->text;
  if (function == "sqrt") return "TL_C(0.5) / " + v.name();
  if (function == "atan") {
    const std::string a = operandText(v.node->args[0]);
    return "TL_C(1.0) / (TL_C(1.0) + " + a + " * " + a + ")";
  }
  return "TL_C(1.0) / " + operandText(v.node->args[0]);
}

// Coefficient k >= 1. What was computed last, a coefficient of this order, comes in by one multiplication and addition: the time goes
// by the chain of these from one order to the next.
std::string Recurrences::general(const Value &v) {
  const Node *n = v.node;
  auto zeroth = [this](const Node *of) { return "x[" + str(value(of).forward * rowLength) + "]"; };
  switch (n->op) {
  case Node::Leaf:
    return n->slot->kind == Slot::T ? "k == 1 ? TL_C(1.0) : TL_C(0.0)" : "x[" + str(state(n) * rowLength) + " + k]";
  case Node::Add: {
    const Node *a = n->args[0], *b = n->args[1];
    if (!varies(a)) return operandText(b);
    if (!varies(b)) return operandText(a);
    return operandText(a) + " + " + operandText(b);
  }
  case Node::Mul: {
    const Node *a = n->args[0], *b = n->args[1];
    if (!varies(a) || !varies(b)) return initial(v);
    if (!value(b).second) std::swap(a, b);
    const std::string older = between(value(a).forward, b);
    if (a == b) return older + " + TL_C(2.0) * " + zeroth(a) + " * " + value(a).name();
    if (value(a).place > value(b).place) std::swap(a, b);
    return older + " + " + zeroth(b) + " * " + value(a).name() + " + " + zeroth(a) + " * " + value(b).name();
  }
  case Node::Recip: {
    const Node *a = n->args[0];
    return "-" + zeroth(n) + " * " + between(value(a).forward, n) + " - " + zeroth(n) + " * " + zeroth(n) + " * " + value(a).name();
  }
  default:
    return mathGeneral(v);
  }
}

// With a the argument, c the function, w_j = j a_j or j c_j, B(x,y) = sum_(j=1..k-1) x_j y_(k-j):
//   exp          c_k = (B(w,c) + k a_k c_0)/k, likewise sin, cos, sinh, cosh from their partners, tan from 1 + tan^2
//   sqrt         c_k = (a_k - B(c,c))/(2 c_0)
//   log, atan    c_k = (a_k - B(w,d)/k)/d_0, w of c, d = a or 1 + a^2
//   power r      c_k = ((r+1)/k B(w,c) - B(a,c) + r a_k c_0)/a_0
std::string Recurrences::mathGeneral(const Value &v) {
  const Node *n = v.node, *a = n->args[0];
  const std::string once = v.once < 0 ? "" : this->once(v);
  auto zeroth = [this](const Node *of) { return "x[" + str(value(of).forward * rowLength) + "]"; };
  auto integral = [&](const Node *slope, const std::string &sign) {
    return sign + "(over_k * " + between(value(a).weighted, slope) + " + " + value(a).name() + " * " + zeroth(slope) + ")";
  };
  if (n->text == "exp") return integral(n, "");
  if (!partner(n->text).empty()) return integral(graph_.math(partner(n->text), n->args), n->text == "cos" ? "-" : "");
  if (n->text == "tan" || n->text == "atan") {
    const Node *sum = onePlusSquare(n->text == "tan" ? v.node : v.node->args[0]);
    if (n->text == "tan") return integral(sum, "");
    return "-" + once + " * over_k * " + between(v.weighted, sum) + " + " + once + " * " + value(a).name();
  }
  if (n->text == "sqrt") return "-" + once + " * " + between(v.forward, n) + " + " + once + " * " + value(a).name();
  if (n->text == "log") return "-" + once + " * over_k * " + between(v.weighted, a) + " + " + once + " * " + value(a).name();
  std::string r = n->text == "cbrt" ? "(TL_C(1.0) / TL_C(3.0))" : fixedText(n->args[1]);
  if (n->text == "tl_power" && differentiated(n)) r = "(" + r + " - " + realConstant(double(differentiated(n))) + ")";
  return once + " * ((" + r + " + TL_C(1.0)) * over_k * " + between(value(a).weighted, n) + " - " + between(value(a).forward, n) +
         ") + " + r + " * " + zeroth(n) + " * " + once + " * " + value(a).name();
}

// What later orders read of a value.
std::string Recurrences::keep(const Value &v, bool first) const {
  std::string s;
  auto put = [&](long number, bool second, const std::string &text) {
    if (first || !second)
      s += "  x[" + str(number * rowLength) + (first ? "" : " + k") + "] = " + text + ";\n";
    else
      s += "  tl_series_put(" + row(number) + ", k, place, " + text + ");\n";
  };
  if (v.forward >= 0) put(v.forward, v.second, v.name());
  if (v.weighted >= 0 && !first) put(v.weighted, false, "(tl_real)k * " + v.name());
  return s;
}

// Velocities and coordinates from accelerations of order k.
std::string Recurrences::follow(const std::string &k) const {
  const long n = long(accelerations_.size());
  std::string s = "  const tl_real over_1 = TL_C(1.0) / (tl_real)(" + k + " + 1), over_2 = TL_C(1.0) / (tl_real)(" + k + " + 2);\n";
  for (long i = 0; i < n; ++i) {
    const Node *a = accelerations_[size_t(i)];
    const std::string rate = "rate" + str(i);
    std::string acceleration = varies(a) || k == "0" ? operandText(a) : "TL_C(0.0)";
    s += "  const tl_real " + rate + " = over_1 * " + acceleration + ";\n";
    s += "  x[" + str((n + i) * rowLength) + " + " + k + " + 1] = " + rate + ";\n";
    s += "  x[" + str(i * rowLength) + " + " + k + " + 2] = over_2 * " + rate + ";\n";
  }
  return s;
}

std::string Recurrences::first() const {
  const long n = long(accelerations_.size());
  std::string s;
  for (long i = 0; i < n; ++i) {
    s += "  x[" + str(i * rowLength) + "] = q[" + str(i) + "];\n  x[" + str(i * rowLength) + " + 1] = qd[" + str(i) + "];\n";
    s += "  x[" + str((n + i) * rowLength) + "] = qd[" + str(i) + "];\n";
  }
  std::string kept;
  for (const Node *node : order_) {
    const Value &v = value(node);
    s += "  const tl_real " + v.name() + " = " + initial(v) + ";\n";
    kept += keep(v, true);
    if (v.once >= 0) kept += "  " + once(v) + " = " + onceText(v) + ";\n";
  }
  return s + kept + follow("0");
}

std::string Recurrences::makeLater() {
  std::string s = "  const tl_real over_k = TL_C(1.0) / (tl_real)k;\n", kept;
  for (const Node *node : order_) {
    const Value &v = value(node);
    s += "  const tl_real " + v.name() + " = " + general(v) + ";\n";
    kept += keep(v, false);
  }
  return s + kept + "  (void)over_k;\n" + follow("k");
}

} // namespace tlgen
