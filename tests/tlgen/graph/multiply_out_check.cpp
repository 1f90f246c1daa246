// Sums of products out of products of sums: how many terms are left, and that the value is the same at random numbers.
#include "Evaluator.h"
#include "MultiplyOut.h"

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <random>

using namespace tlgen;

namespace {

struct Plane {
  Plane() {
    Slot s;
    s.kind = Slot::Q;
    const Slot *q = graph.slot(s);
    for (long i = 0; i < 4; ++i) x[i] = graph.leaf(q, {graph.integer(i)});
    sine = graph.math("sin", {x[0]});
    cosine = graph.math("cos", {x[0]});
  }
  // Neither shared factors nor squares are looked for.
  Node *sum(Node *a, Node *b) { return graph.plainSum(a, b); }
  Node *product(Node *a, Node *b) { return graph.plainProduct(a, b); }
  Node *square(Node *a) { return product(a, a); }
  Node *difference(Node *a, Node *b) { return sum(a, graph.neg(b)); }

  Graph graph;
  Node *x[4], *sine, *cosine;
};

// The square of a velocity (u, r w) in polar coordinates, from its parts along fixed axes.
Node *speed(Plane &p) {
  Node *u = p.x[1], *across = p.product(p.x[2], p.x[3]);
  return p.sum(p.square(p.sum(p.product(u, p.sine), p.product(across, p.cosine))),
               p.square(p.difference(p.product(across, p.sine), p.product(u, p.cosine))));
}
Node *difference_of_squares(Plane &p) { return p.product(p.sum(p.x[1], p.x[2]), p.difference(p.x[1], p.x[2])); }
Node *nothing(Plane &p) { return p.difference(p.square(p.sum(p.x[1], p.x[2])), p.square(p.sum(p.x[2], p.x[1]))); }
Node *sine_to_the_fourth(Plane &p) { return p.square(p.square(p.sine)); } // 1 - 2 cos^2 + cos^4
Node *inside_a_function(Plane &p) { return p.square(p.graph.math("exp", {p.sum(p.x[1], p.x[2])})); }

struct Case {
  const char *about;
  Node *(*make)(Plane &p);
  size_t terms;
};

const Case cases[] = {{"a velocity in polar coordinates", speed, 2},
                      {"a difference of squares", difference_of_squares, 2},
                      {"terms that cancel", nothing, 0},
                      {"a sine to the fourth", sine_to_the_fourth, 3},
                      {"a function of a sum", inside_a_function, 1}};

size_t termsOf(const Node *n) {
  if (n->is(0)) return 0;
  return n->op == Node::Add ? termsOf(n->args[0]) + termsOf(n->args[1]) : 1;
}

int check(const Case &c, std::mt19937_64 &random) {
  Plane p;
  Node *given = c.make(p), *made = multipliedOut(p.graph, given);
  const size_t terms = made ? termsOf(made) : 999;
  int faults = terms != c.terms;
  if (faults) std::printf("%s: %zu terms, not %zu\n", c.about, terms, c.terms);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int point = 0; made && point < 100; ++point) {
    double numbers[4];
    for (double &x : numbers) x = uniform(random);
    auto computed = [&](const Node *value) {
      return Evaluator([&](const Slot &, const std::vector<long> &i) { return Value::of(numbers[i[0]]); }, nullptr).value(value);
    };
    const double is = computed(made), was = computed(given), size = 100 + std::fabs(was); // of what cancels
    if (std::fabs(is - was) <= 8 * DBL_EPSILON * size) continue;
    std::printf("%s: %.17g, not %.17g\n", c.about, is, was);
    faults++;
  }
  return faults;
}

// (a + b + 2)^40 has 861 terms.
int checkMost() {
  Plane p;
  Node *sum = p.sum(p.sum(p.x[1], p.x[2]), p.graph.number(2)), *product = sum;
  for (int i = 1; i < 40; ++i) product = p.product(product, sum);
  if (!multipliedOut(p.graph, product)) return 0;
  std::printf("too many terms were multiplied out\n");
  return 1;
}

} // namespace

int main() {
  std::mt19937_64 random(1);
  int faults = checkMost();
  for (const Case &c : cases) faults += check(c, random);
  return faults ? 1 : 0;
}
