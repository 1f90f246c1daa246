// Sums of products, as numbers by the factors that they stand before.
#include "MultiplyOut.h"

#include <algorithm>
#include <optional>

namespace tlgen {
namespace {

class MultiplyOut {
public:
  explicit MultiplyOut(Graph &graph) : graph_(graph) {}

  Node *operator()(Node *value) {
    const Sum *sum = of(value);
    if (!sum) return nullptr;
    Graph::Making making(graph_, nullptr, value->loc);
    Node *made = graph_.number(0);
    for (const auto &[factors, number] : *sum) {
      Node *product = graph_.number(number);
      for (Node *factor : factors) product = graph_.mul(product, factor);
      made = graph_.add(made, product);
    }
    return made;
  }

private:
  static constexpr size_t MOST = 200;
  using Factors = std::vector<Node *>; // in order
  struct InOrder {
    bool operator()(const Factors &a, const Factors &b) const {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), ById());
    }
  };
  using Sum = std::map<Factors, double, InOrder>;

  // Null where there are too many terms.
  const Sum *of(Node *value) {
    auto known = known_.find(value);
    if (known == known_.end()) known = known_.emplace(value, make(value)).first;
    return known->second ? &*known->second : nullptr;
  }

  std::optional<Sum> make(Node *value) {
    if (value->isNumber()) return Sum{{{}, value->value}};
    if ((value->op != Node::Add && value->op != Node::Mul) || value->fixed) return Sum{{{value}, 1.0}};
    const Sum *a = of(value->args[0]), *b = of(value->args[1]);
    if (!a || !b || (value->op == Node::Mul && a->size() * b->size() > MOST)) return std::nullopt;
    Sum sum;
    if (value->op == Node::Add) {
      sum = *a;
      for (const auto &[factors, number] : *b) put(sum, factors, number);
    } else {
      for (const auto &[left, x] : *a)
        for (const auto &[right, y] : *b) {
          Factors factors;
          std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(factors), ById());
          put(sum, factors, x * y);
        }
    }
    if (sum.size() > MOST) return std::nullopt;
    return sum;
  }

  // Adds a term; one with a sine's square as two.
  void put(Sum &sum, const Factors &factors, double number) {
    auto square = std::adjacent_find(factors.begin(), factors.end(),
                                     [](const Node *a, const Node *b) { return a == b && a->op == Node::Math && a->text == "sin"; });
    if (square != factors.end()) {
      Node *cosine = graph_.math("cos", (*square)->args);
      Factors others = factors;
      others.erase(others.begin() + (square - factors.begin()), others.begin() + (square - factors.begin()) + 2);
      put(sum, others, number);
      for (int i = 0; i < 2; ++i) others.insert(std::upper_bound(others.begin(), others.end(), cosine, ById()), cosine);
      return put(sum, others, -number);
    }
    auto term = sum.emplace(factors, 0.0).first;
    term->second += number;
    if (term->second == 0.0) sum.erase(term);
  }

  Graph &graph_;
  std::unordered_map<Node *, std::optional<Sum>> known_;
};

} // namespace

Node *multipliedOut(Graph &graph, Node *value) { return MultiplyOut(graph)(value); }

} // namespace tlgen
