// C from a graph: expressions.
#include "MathFunctions.h"
#include "PrintGraph.h"
#include "Trace.h"

#include <algorithm>
#include <cstdlib>

namespace tlgen {
namespace {

bool isTruth(const Node *n) {
  return n->op == Node::Compare || (n->op == Node::Math && n->text == "tl_power_exists") || n->op == Node::Not ||
         n->op == Node::Conjunction || n->op == Node::Disjunction;
}

// Whether an argument of the function is an int.
bool takesInt(const std::string &function, size_t argument) {
  if (function == "ldexp" || function == "scalbn" || function == "scalbln") return argument == 1;
  return argument == 2 && (function == "tl_power" || function == "tl_power_exists");
}

// Whether there is a tl_lanes_ function of that name.
bool hasLanes(const std::string &function) {
  static const std::set<std::string> toIntegers = {"lround", "lrint", "llround", "llrint"};
  const MathFunction *f = findMath(function);
  const bool real = f && (f->kind == MathFunction::Smooth || f->kind == MathFunction::Step) && !toIntegers.count(f->name);
  return real || function.rfind("tl_power", 0) == 0;
}

bool isNegative(const Node *n) {
  return n->isNumber() ? n->value < 0 : n->op == Node::Mul && n->args[0]->isNumber() && n->args[0]->value < 0;
}

} // namespace

// Whether the value may be another in each lane. What is in memory, or goes from one iteration to the next, always may.
bool GraphPrinter::inLanes(const Node *n) {
  if (!lanes_) return false;
  auto known = inLanes_.find(n);
  if (known != inLanes_.end()) return known->second;
  bool is = n->op == Node::Read || schedule_.place(n) != nullptr || (n->op == Node::Leaf && n->slot->kind != Slot::Member);
  if (n->op == Node::Carried || n->op == Node::Final) is = !isInteger(n->of->carried[size_t(n->which)].init);
  for (const Node *arg : n->args) is |= inLanes(arg);
  if (is) requireLanes(n);
  return inLanes_[n] = is;
}

// Lanes go through the same statements with other numbers: what decides on statements or places, and what is no arithmetic, may not
// depend on them.
void GraphPrinter::requireLanes(const Node *n) {
  auto refuse = [&](const std::string &why) { throw Unsuitable{why, n->loc}; };
  const std::string lanes = " depends on the state, which is another in each lane";
  for (size_t k = 0; k < n->args.size(); ++k) {
    if (!inLanes(n->args[k])) continue;
    const bool ofTruths =
        n->op == Node::Not || n->op == Node::Conjunction || n->op == Node::Disjunction || (n->op == Node::Select && k == 0);
    if (n->op == Node::Leaf || n->op == Node::Read) refuse("the place in an array" + lanes);
    if (n->op == Node::Convert || n->op == Node::Integer || (isInteger(n) && n->op == Node::Select)) refuse("an integer" + lanes);
    if (isTruth(n->args[k]) != ofTruths) refuse("a number that stands for a truth value" + lanes);
    if (n->op == Node::Taylor) refuse("an argument of a function with a rule" + lanes);
    if (n->op == Node::Math && (takesInt(n->text, k) || !hasLanes(n->text))) refuse("an argument of '" + n->text + "'" + lanes);
  }
}

// As an operand that must be lanes.
Text GraphPrinter::filled(const Node *n) { return lanes_ && !inLanes(n) ? Text{"tl_lanes_of(" + real(n).s + ")", Postfix} : real(n); }

std::string GraphPrinter::type(const Node *n) {
  if (isTruth(n)) return inLanes(n) ? "tl_mask" : "int";
  return isInteger(n) ? "long" : inLanes(n) ? "tl_lanes" : "tl_real";
}

GraphPrinter::Shown GraphPrinter::show(const Node *n) {
  auto at = shown_.find(n);
  return at != shown_.end() ? at->second : compute(n);
}

// As an operand of real arithmetic: integers are converted first.
Text GraphPrinter::real(const Node *n) {
  Text t = show(n).text;
  if (n->isConstant()) return {realConstant(double(n->offset)), Primary};
  return isInteger(n) ? Text{"(tl_real)" + operand(t, Prefix), Prefix} : t;
}

// What is added before what is taken away: 4 - i, 2*i + 1.
Text GraphPrinter::affine(const Node *n) {
  std::vector<std::pair<Text, bool>> parts; // true: to be taken away
  for (auto &[loop, factor] : n->terms) {
    Text name{indexNames_.at(loop), Primary}, times{std::to_string(std::labs(factor)) + "*" + name.s, Product};
    if (factor) parts.push_back({std::labs(factor) == 1 ? name : times, factor < 0});
  }
  if (n->offset || parts.empty()) parts.push_back({{std::to_string(std::labs(n->offset)), Primary}, n->offset < 0});
  auto added = std::find_if(parts.begin(), parts.end(), [](const auto &part) { return !part.second; });
  if (added != parts.end()) std::rotate(parts.begin(), added, added + 1);
  Text sum = parts[0].second ? unaryText("-", parts[0].first) : parts[0].first;
  for (size_t i = 1; i < parts.size(); ++i) sum = binaryText(parts[i].second ? "-" : "+", sum, parts[i].first);
  return sum;
}

std::string GraphPrinter::fill(const std::string &text, const std::vector<Text> &indices) {
  std::string s;
  size_t next = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      s += text[i];
      continue;
    }
    bool factor = (i > 0 && text[i - 1] == '*') || (i + 1 < text.size() && text[i + 1] == '*');
    const Text &t = indices[next++];
    s += factor ? operand(t, Product) : t.s;
  }
  return s;
}

std::string GraphPrinter::leaf(const Node *n) {
  static const std::map<Slot::Kind, const char *> texts = {
      {Slot::Q, "q[%]"},     {Slot::Qd, "qd[%]"},         {Slot::T, "t"},
      {Slot::Qdd, "qdd[%]"}, {Slot::Lambda, "lambda[%]"}, {Slot::Direction, "w[%*k + c]"}};
  auto known = texts.find(n->slot->kind);
  if (lanes_ && n->slot->kind == Slot::T) return "t[0]";
  const Variable *table = n->slot->variable;
  if (table && table->scope == Variable::Local) tables_[table->name] = table;
  std::vector<Text> indices;
  for (const Node *arg : n->args) indices.push_back(show(arg).text);
  return fill(known == texts.end() ? n->slot->text : known->second, indices);
}

std::string GraphPrinter::element(const Array *a, const Node *at) {
  auto known = bound_.find(a);
  if (known == bound_.end()) return arrayName(a) + "[" + index(at) + "]";
  const Binding &b = known->second;
  if (std::count(b.lvalue.begin(), b.lvalue.end(), '%') == 1) return fill(b.lvalue, {show(at).text});
  Text columns{std::to_string(b.columns), Primary};
  if (at->op != Node::Affine) return fill(b.lvalue, {binaryText("/", show(at).text, columns), binaryText("%", show(at).text, columns)});
  Node row = *at, column = *at;
  row.offset = at->offset / b.columns, column.offset = at->offset % b.columns;
  for (size_t i = 0; i < at->terms.size(); ++i) {
    bool ofRow = at->terms[i].second % b.columns == 0;
    row.terms[i].second = ofRow ? at->terms[i].second / b.columns : 0;
    column.terms[i].second = ofRow ? 0 : at->terms[i].second;
  }
  return fill(b.lvalue, {affine(&row), affine(&column)});
}

void GraphPrinter::bind(const Array *a, const std::string &lvalue, long columns) { bound_[a] = {lvalue, columns}; }

// Of a function that a batch evaluates.
std::string GraphPrinter::result(const Node *n) {
  const BatchPlace *p = schedule_.place(n);
  const auto &names = results_.at(p->batch);
  const std::string &name = p->batch->function == "sincos" && n->text == "cos" ? names.second : names.first;
  return p->batch->loop || p->batch->args.size() > 1 ? name + "[" + index(p->index) + "]" : name;
}

GraphPrinter::Shown GraphPrinter::combine(const std::string &op, const Node *a, const Node *b, bool integers) {
  Shown x = show(a), y = show(b);
  x.text = binaryText(op, integers ? x.text : real(a), integers ? y.text : real(b));
  x.carried.insert(y.carried.begin(), y.carried.end());
  return x;
}

// a - b for a + -1*b, a - 2*b for a + -2*b.
GraphPrinter::Shown GraphPrinter::sum(const Node *n) {
  const Node *a = n->args[0], *b = n->args[1];
  auto minus = [&](const Node *x) { return isNegative(x) && show(x).text.s[0] == '-'; };
  if (minus(a) && !minus(b)) std::swap(a, b);
  if (!minus(b)) return combine("+", a, b);
  Shown x = show(a), y = show(b);
  Text rest{y.text.s.substr(y.text.s[1] == ' ' ? 2 : 1), b->isNumber() ? Primary : y.text.precedence == Prefix ? Prefix : Product};
  x.text = binaryText("-", real(a), rest);
  x.carried.insert(y.carried.begin(), y.carried.end());
  return x;
}

// -x for -1*x, a/b for a * 1/b.
GraphPrinter::Shown GraphPrinter::product(const Node *n) {
  const Node *a = n->args[0], *b = n->args[1];
  if (a->is(-1)) {
    Shown x = show(b);
    Text t = real(b);
    x.text = t.precedence == Product && t.s[0] != '-' ? Text{"-" + t.s, Product} : unaryText("-", t);
    return x;
  }
  auto inverse = [&](const Node *x) { return x->op == Node::Recip && show(x).text.precedence != Primary; };
  if (inverse(a)) std::swap(a, b);
  if (inverse(b)) {
    Shown x = show(a), y = show(b->args[0]);
    x.text = binaryText("/", real(a), real(b->args[0]));
    x.carried.insert(y.carried.begin(), y.carried.end());
    return x;
  }
  Shown x = combine("*", a, b);
  bool bare =
      a->isNumber() && show(b).text.precedence == Product && show(b).text.s[0] != '-' && show(b).text.s.find('/') == std::string::npos;
  if (bare) x.text = {realConstant(a->value) + " * " + show(b).text.s, Product};
  return x;
}

// A call of a function of math.h or of taylor/power.h.
Text GraphPrinter::functionText(const std::string &name, const std::string &args, bool lanes) {
  if (!lanes) return mathText(name, args);
  const std::string stem = name == "ldexp" ? "scalbn" : name.rfind("tl_", 0) == 0 ? name.substr(3) : name;
  return {"tl_lanes_" + stem + "(" + args + ")", Postfix};
}

// The same, or a function of the user.
GraphPrinter::Shown GraphPrinter::call(const Node *n) {
  const bool lanes = inLanes(n);
  Shown s;
  std::string list;
  std::vector<Text> args;
  for (size_t i = 0; i < n->args.size(); ++i) {
    const Node *arg = n->args[i];
    Shown x = show(arg);
    args.push_back(lanes ? filled(arg) : real(arg));
    if (takesInt(n->text, i)) args.back() = {(arg->isConstant() ? "" : "(int)") + operand(x.text, Prefix), Prefix};
    list += (list.empty() ? "" : ", ") + args.back().s;
    s.carried.insert(x.carried.begin(), x.carried.end());
  }
  s.text = n->op == Node::Taylor ? externalText(n->text, args) : functionText(n->text, list, lanes);
  return s;
}

// a op b of truth values: && and || of C, & and | of lanes.
GraphPrinter::Shown GraphPrinter::both(const std::string &op, const Node *a, const Node *b) {
  if (!inLanes(a) && !inLanes(b)) return combine(op, a, b, true);
  auto mask = [&](const Node *n) { return inLanes(n) ? show(n).text : Text{"tl_lanes_truth(" + show(n).text.s + ")", Postfix}; };
  Shown x = show(a);
  x.text = binaryText(op.substr(1), mask(a), mask(b));
  x.carried.merge(show(b).carried);
  return x;
}

GraphPrinter::Shown GraphPrinter::choice(const Node *n) {
  Shown c = show(n->args[0]), a = show(n->args[1]), b = show(n->args[2]);
  const bool whole = isInteger(n->args[1]) && isInteger(n->args[2]), lanes = inLanes(n);
  auto operandOf = [&](size_t k, const Shown &x) { return whole ? x.text : lanes ? filled(n->args[k]) : real(n->args[k]); };
  const Text x = operandOf(1, a), y = operandOf(2, b);
  if (inLanes(n->args[0]))
    c.text = {"tl_lanes_select(" + c.text.s + ", " + x.s + ", " + y.s + ")", Postfix};
  else
    c.text = {operand(c.text, Or) + " ? " + operand(x, Or) + " : " + operand(y, Choice), Choice};
  c.carried.insert(a.carried.begin(), a.carried.end());
  c.carried.insert(b.carried.begin(), b.carried.end());
  return c;
}

GraphPrinter::Shown GraphPrinter::compute(const Node *n) {
  inLanes(n);
  switch (n->op) {
  case Node::Number:
    return {{realConstant(n->value), n->value < 0 ? Prefix : Primary}, {}};
  case Node::Affine:
    return {affine(n), {}};
  case Node::Leaf:
    if (n->slot->integer) return {{"(long)" + leaf(n), Prefix}, {}};
    return {{leaf(n), Postfix}, {}};
  case Node::Carried:
    return {{carriedNames_.at({n->of, size_t(n->which)}), Primary}, {n}};
  case Node::Final:
    return {{carriedNames_.at({n->of, size_t(n->which)}), Primary}, {}};
  case Node::Read:
    return {{element(n->array, n->args[0]), Postfix}, show(n->args[0]).carried};
  case Node::Add:
    return sum(n);
  case Node::Mul:
    return product(n);
  case Node::Recip: {
    Shown x = show(n->args[0]);
    x.text = binaryText("/", {realConstant(1), Primary}, real(n->args[0]));
    return x;
  }
  case Node::Math:
    return schedule_.place(n) ? Shown{{result(n), Postfix}, {}} : call(n);
  case Node::Taylor:
    return n->args.size() > 1 ? call(n) : Shown{derivativeOf(n), {}};
  case Node::Convert: {
    Shown x = show(n->args[0]);
    x.text = {"(" + n->text + ")" + operand(x.text, Prefix), Prefix};
    return x;
  }
  case Node::Integer:
    return combine(n->text, n->args[0], n->args[1], true);
  case Node::Compare: {
    const Node *a = n->args[0], *b = n->args[1];
    bool constant = a->isNumber() || a->isConstant(), integers = isInteger(a) && isInteger(b);
    if (constant) std::swap(a, b); // x > 0, not 0 < x
    return combine(constant && n->text[0] == '<' ? ">" + n->text.substr(1) : n->text, a, b, integers);
  }
  case Node::Not: {
    Shown x = show(n->args[0]);
    x.text = inLanes(n) ? Text{"tl_lanes_not(" + x.text.s + ")", Postfix} : unaryText("!", x.text);
    return x;
  }
  case Node::Conjunction:
    return both("&&", n->args[0], n->args[1]);
  case Node::Disjunction:
    return both("||", n->args[0], n->args[1]);
  case Node::Select:
    return choice(n);
  }
  std::abort();
}

Text GraphPrinter::derivativeOf(const Node *n) {
  Text coefficient{externals_.at({n->text, n->args[0]}) + "[" + std::to_string(n->which) + "]", Postfix};
  double factorial = 1;
  for (int k = 2; k <= n->which; ++k) factorial *= k;
  return factorial == 1 ? coefficient : binaryText("*", {realConstant(factorial), Primary}, coefficient);
}

} // namespace tlgen
