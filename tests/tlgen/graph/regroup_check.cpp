// Sums of products in the order of factors that shares most: how many multiplications are left, and that the value is the same as that of
// the products in quad precision, at random numbers.
#include "Evaluator.h"
#include "Regroup.h"

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <random>

using namespace tlgen;

namespace {

// Products of factors, a letter each; digits are numbers, - a sign.
using Products = std::vector<std::string>;

struct Case {
  const char *about;
  Products products;
  int least; // multiplications that no grouping goes below
};

// Each by hand: a product of k factors takes k - 1 multiplications, less those that it shares.
const Case cases[] = {
    {"a single product", {"abc"}, 2},
    {"nothing in common", {"ab", "cd"}, 2},
    {"one pair in two products", {"abc", "abd"}, 3},
    {"the pair stands apart in the source", {"acb", "bda"}, 3},
    {"two pairs in four products", {"abc", "abd", "acd", "bcd"}, 6},
    {"one product inside others", {"ab", "abc", "abcd"}, 3},
    {"a common product of three", {"abcd", "abce", "abcf"}, 5},
    {"squares", {"aab", "aac"}, 3},
    {"a mass matrix: l m C c, l m S s beside l C, l S", {"lmCc", "lmSs", "lC", "lS"}, 6},
    {"numbers are factors", {"3ab", "3ac"}, 3},
    {"signs are none", {"abc", "-abd", "-ab"}, 3},
};

class Sum {
public:
  explicit Sum(const Products &products) {
    Slot s;
    s.kind = Slot::Q;
    q_ = graph.slot(s);
    for (const std::string &product : products) value = value ? graph.plainSum(value, node(product)) : node(product);
  }

  Graph graph;
  Node *value = nullptr;

private:
  Node *node(const std::string &product) {
    const bool negative = product[0] == '-';
    Node *result = nullptr;
    for (char letter : product.substr(negative)) {
      Node *factor = std::isdigit(letter) ? graph.number(letter - '0') : graph.leaf(q_, {graph.integer(letter)});
      result = result ? graph.plainProduct(result, factor) : factor;
    }
    return negative ? graph.neg(result) : result;
  }

  const Slot *q_ = nullptr;
};

// Multiplications that the value needs; changes of sign are none.
int multiplications(const Node *value) {
  std::set<const Node *> seen;
  std::vector<const Node *> open = {value};
  int count = 0;
  while (!open.empty()) {
    const Node *n = open.back();
    open.pop_back();
    if (!seen.insert(n).second) continue;
    count += n->op == Node::Mul && !n->args[0]->is(-1);
    open.insert(open.end(), n->args.begin(), n->args.end());
  }
  return count;
}

// The letters' numbers.
using Numbers = std::vector<double>;

double computed(const Node *value, const Numbers &numbers) {
  Evaluator evaluator([&](const Slot &, const std::vector<long> &indices) { return Value::of(numbers[size_t(indices[0])]); }, nullptr);
  return evaluator.value(value);
}

// In quad precision from the text; size: the sum of the products' sizes.
double expected(const Products &products, const Numbers &numbers, double &size) {
  __float128 sum = 0;
  size = 0;
  for (const std::string &product : products) {
    __float128 term = 1;
    for (char letter : product) term *= letter == '-' ? -1 : std::isdigit(letter) ? letter - '0' : numbers[size_t(letter)];
    sum += term;
    size += std::fabs(double(term));
  }
  return double(sum);
}

// Half an ulp for each multiplication and addition on the way, and for the result.
double rounding(const Products &products) {
  size_t longest = 0;
  for (const std::string &product : products) longest = std::max(longest, product.size());
  return double(longest + products.size()) * DBL_EPSILON / 2;
}

// The number of points where the values differ.
int differences(const char *about, const Products &products, const Node *value, std::mt19937_64 &random) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  int faults = 0;
  for (int point = 0; point < 100; ++point) {
    Numbers numbers(128);
    for (double &x : numbers) x = uniform(random);
    double size, right = expected(products, numbers, size), is = computed(value, numbers);
    if (std::fabs(is - right) <= rounding(products) * size) continue;
    std::printf("%s, point %d: %.17g, not %.17g; difference %.2e of %.2e\n", about, point, is, right, is - right, size);
    faults++;
  }
  return faults;
}

int check(const Case &c, std::mt19937_64 &random) {
  Sum sum(c.products);
  const int before = multiplications(sum.value);
  Node *regrouped = Regrouping(sum.graph, {sum.value})(sum.value);
  const int after = multiplications(regrouped);
  std::printf("%s: %d multiplications, before %d\n", c.about, after, before);
  if (after != c.least) std::printf("  not %d\n", c.least);
  return (after != c.least) + differences(c.about, c.products, regrouped, random);
}

// Any products: never more multiplications, and the same value.
int checkRandom(std::mt19937_64 &random) {
  auto below = [&](unsigned n) { return unsigned(random() % n); };
  int faults = 0;
  for (int repeat = 0; repeat < 200; ++repeat) {
    Products products;
    for (unsigned k = 0; k < 2 + below(12); ++k) {
      std::string product = below(4) ? "" : below(2) ? "-" : "7";
      for (unsigned i = 0; i < 1 + below(6); ++i) product += char('a' + below(7));
      if (std::isalpha(product.back())) products.push_back(product);
    }
    Sum sum(products);
    Node *regrouped = Regrouping(sum.graph, {sum.value})(sum.value);
    const int before = multiplications(sum.value), after = multiplications(regrouped);
    if (after > before) std::printf("random products %d: %d multiplications, before %d\n", repeat, after, before);
    faults += (after > before) + differences("random products", products, regrouped, random);
  }
  return faults;
}

} // namespace

int main() {
  std::mt19937_64 random(1);
  int faults = 0;
  for (const Case &c : cases) faults += check(c, random);
  faults += checkRandom(random);
  return faults ? 1 : 0;
}
