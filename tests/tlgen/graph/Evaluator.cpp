#include "Evaluator.h"

#include <cmath>
#include <stdexcept>

using namespace tlgen;

void Evaluator::reach(const Node *n) {
  if (!n || !reached_.insert(n).second) return;
  for (const Node *arg : n->args) reach(arg);
  if (n->array) reach(n->array);
  for (auto &term : n->terms) reach(term.first);
  if (n->of) reach(n->of);
}

void Evaluator::reach(const Loop *loop) {
  if (!loop || !loops_.insert(loop).second) return;
  reach(loop->outer);
  reach(loop->trips);
  reach(loop->condition);
  for (const Carry &c : loop->carried) {
    reach(c.init);
    reach(c.out);
    reach(c.in);
  }
}

void Evaluator::reach(const Array *array) {
  if (!arrays_.insert(array).second) return;
  for (const Write &w : array->writes) {
    reach(w.loop);
    reach(w.index);
    reach(w.value);
  }
}

double Evaluator::value(const Node *n) {
  reach(n);
  return of(n).asReal();
}

std::vector<double> Evaluator::rows(const Array *array) {
  reach(array);
  std::vector<double> result;
  for (long i = 0; i < array->length; ++i) result.push_back(element(array, i).asReal());
  return result;
}

Value Evaluator::of(const Node *n) {
  auto known = known_.find(n);
  if (known != known_.end()) return known->second;
  return known_[n] = compute(n);
}

Value Evaluator::compute(const Node *n) {
  switch (n->op) {
  case Node::Number:
    return Value::of(n->value);
  case Node::Affine: {
    long sum = n->offset;
    for (auto &[loop, factor] : n->terms) sum += factor * iteration_.at(loop);
    return Value::of(sum);
  }
  case Node::Leaf: {
    std::vector<long> indices;
    for (const Node *arg : n->args) indices.push_back(of(arg).integer);
    return input_(*n->slot, indices);
  }
  case Node::Carried:
    return carried_.at(n->of)[size_t(n->which)];
  case Node::Final:
    run(n->of);
    return carried_.at(n->of)[size_t(n->which)];
  case Node::Read:
    return element(n->array, of(n->args[0]).integer);
  case Node::Select:
    return of(n->args[of(n->args[0]).integer ? 1 : 2]);
  case Node::Conjunction:
    return Value::of(long(of(n->args[0]).integer && of(n->args[1]).integer));
  case Node::Disjunction:
    return Value::of(long(of(n->args[0]).integer || of(n->args[1]).integer));
  default:
    return operation(n);
  }
}

static long integerOperation(const std::string &op, long a, long b) {
  if (op == "+") return a + b;
  if (op == "-") return a - b;
  if (op == "*") return a * b;
  if (op == "/") return a / b;
  if (op == "%") return a % b;
  if (op == "&") return a & b;
  if (op == "|") return a | b;
  if (op == "^") return a ^ b;
  if (op == "<<") return a << b;
  if (op == ">>") return a >> b;
  throw std::runtime_error("integer operation " + op);
}

static Value converted(const std::string &type, const Value &v) {
  long n = v.isInteger ? v.integer : long(v.real);
  if (type == "tl_real") return Value::of(v.asReal());
  if (type == "signed char" || type == "char") return Value::of(long(static_cast<signed char>(n)));
  if (type == "unsigned char") return Value::of(long(static_cast<unsigned char>(n)));
  if (type == "short") return Value::of(long(static_cast<short>(n)));
  if (type == "unsigned short") return Value::of(long(static_cast<unsigned short>(n)));
  if (type == "int") return Value::of(long(static_cast<int>(n)));
  if (type == "unsigned int") return Value::of(long(static_cast<unsigned>(n)));
  return Value::of(n);
}

static double function(const std::string &f, const std::vector<double> &x) {
  using F1 = double (*)(double);
  using F2 = double (*)(double, double);
  static const std::map<std::string, F1> one = {
      {"sin", std::sin},       {"cos", std::cos},       {"tan", std::tan},     {"asin", std::asin},   {"acos", std::acos},
      {"atan", std::atan},     {"sinh", std::sinh},     {"cosh", std::cosh},   {"tanh", std::tanh},   {"asinh", std::asinh},
      {"acosh", std::acosh},   {"atanh", std::atanh},   {"exp", std::exp},     {"exp2", std::exp2},   {"expm1", std::expm1},
      {"log", std::log},       {"log2", std::log2},     {"log10", std::log10}, {"log1p", std::log1p}, {"sqrt", std::sqrt},
      {"cbrt", std::cbrt},     {"erf", std::erf},       {"erfc", std::erfc},   {"fabs", std::fabs},   {"floor", std::floor},
      {"ceil", std::ceil},     {"trunc", std::trunc},   {"round", std::round}, {"rint", std::rint},   {"nearbyint", std::nearbyint},
      {"tgamma", std::tgamma}, {"lgamma", std::lgamma}, {"logb", std::logb}};
  static const std::map<std::string, F2> two = {
      {"pow", std::pow},           {"hypot", std::hypot},        {"atan2", std::atan2}, {"fmin", std::fmin},
      {"fmax", std::fmax},         {"fdim", std::fdim},          {"fmod", std::fmod},   {"remainder", std::remainder},
      {"copysign", std::copysign}, {"nextafter", std::nextafter}};
  if (one.count(f)) return one.at(f)(x[0]);
  if (two.count(f)) return two.at(f)(x[0], x[1]);
  if (f == "fma") return std::fma(x[0], x[1], x[2]);
  if (f == "scalbn" || f == "ldexp") return std::ldexp(x[0], int(x[1]));
  if (f == "isnan") return std::isnan(x[0]);
  if (f == "isinf") return std::isinf(x[0]);
  if (f == "isfinite") return std::isfinite(x[0]);
  if (f == "isnormal") return std::isnormal(x[0]);
  if (f == "signbit") return std::signbit(x[0]);
  if (f == "isunordered") return std::isunordered(x[0], x[1]);
  throw std::runtime_error("function " + f);
}

Value Evaluator::operation(const Node *n) {
  std::vector<Value> v;
  std::vector<double> x;
  for (const Node *arg : n->args) {
    v.push_back(of(arg));
    x.push_back(v.back().asReal());
  }
  switch (n->op) {
  case Node::Add:
    return Value::of(x[0] + x[1]);
  case Node::Mul:
    return Value::of(x[0] * x[1]);
  case Node::Recip:
    return Value::of(1 / x[0]);
  case Node::Math:
    return Value::of(function(n->text, x));
  case Node::Taylor:
    return Value::of(external_(n->text, x));
  case Node::Convert:
    return converted(n->text, v[0]);
  case Node::Integer:
    return Value::of(integerOperation(n->text, v[0].integer, v[1].integer));
  case Node::Compare: {
    bool less = x[0] < x[1], same = x[0] == x[1];
    return Value::of(long(n->text == "<" ? less : n->text == "<=" ? less || same : same));
  }
  case Node::Not:
    return Value::of(long(!v[0].integer));
  default:
    throw std::runtime_error("operation");
  }
}

Value Evaluator::element(const Array *array, long index) {
  Memory &m = memory_[array];
  bool inside = false;
  for (const Write &w : array->writes) inside |= w.loop && w.loop != array->home && running_.count(w.loop);
  if (!m.filled && !inside) fill(array);
  if (index < 0 || index >= array->length || m.written.empty() || !m.written[size_t(index)])
    throw std::runtime_error("element " + std::to_string(index) + " of " + array->name + " is read and not written");
  return m.elements[size_t(index)];
}

void Evaluator::fill(const Array *array) {
  memory_[array].filled = true;
  for (const Write &w : array->writes) {
    const Loop *outermost = w.loop;
    while (outermost && outermost->outer && !running_.count(outermost->outer) && outermost->outer != array->home)
      outermost = outermost->outer;
    if (outermost) run(outermost);
    if (!w.loop || w.loop == array->home) write(array, w);
  }
}

void Evaluator::write(const Array *array, const Write &w) {
  long index = of(w.index).integer;
  Value v = of(w.value);
  Memory &m = memory_[array];
  m.elements.resize(size_t(array->length));
  m.written.resize(size_t(array->length));
  if (index < 0 || index >= array->length || m.written[size_t(index)])
    throw std::runtime_error("element " + std::to_string(index) + " of " + array->name + " is written twice or does not exist");
  m.elements[size_t(index)] = v;
  m.written[size_t(index)] = true;
}

// What varies in the loop is to be computed anew.
void Evaluator::forget(const Loop *loop) {
  for (auto it = known_.begin(); it != known_.end();)
    it = it->first->loop && it->first->loop->within(loop) ? known_.erase(it) : std::next(it);
  for (const Loop *l : loops_)
    if (l != loop && l->within(loop)) done_.erase(l);
  for (const Array *a : arrays_)
    if (a->home && a->home->within(loop)) memory_.erase(a);
}

void Evaluator::run(const Loop *loop) {
  if (running_.count(loop) || !done_.insert(loop).second) return;
  std::vector<Value> now;
  for (const Carry &c : loop->carried) now.push_back(reached_.count(c.in) ? of(c.init) : Value{});
  long trips = loop->trips ? of(loop->trips).integer : -1;
  running_.insert(loop);
  for (const Array *a : arrays_)
    for (const Write &w : a->writes)
      if (w.loop == loop && a->home != loop) { // elements that stand before the loop
        memory_[a].elements.resize(size_t(a->length));
        memory_[a].written.resize(size_t(a->length));
        for (const Write &before : a->writes)
          if (before.loop == loop->outer && !memory_[a].filled) write(a, before);
        memory_[a].filled = true;
      }
  for (long k = 0; trips < 0 || k < trips; ++k) {
    iteration_[loop] = loop->down ? trips - 1 - k : k;
    carried_[loop] = now;
    forget(loop);
    if (loop->condition && !of(loop->condition).integer) break;
    for (size_t i = 0; i < now.size(); ++i)
      if (reached_.count(loop->carried[i].in)) now[i] = of(loop->carried[i].out);
    for (const Loop *inner : loops_)
      if (inner->outer == loop) run(inner);
    for (const Array *a : arrays_)
      for (const Write &w : a->writes)
        if (w.loop == loop && a->home != loop) write(a, w);
  }
  forget(loop);
  running_.erase(loop);
  carried_[loop] = now;
}
