// Sums: equal terms are taken together, a sin^2 + a cos^2 is a, and terms cancel that stand in products of sums.
#include "Graph.h"

#include <algorithm>

namespace tlgen {
namespace {

// A term of a sum, or of a sum that is a factor of such a term: a b (c + d (e + f)) has the parts c and d (e + f).
struct Term {
  double factor;              // the number in front
  Node *node;                 // the rest; null for a number
  int outer;                  // the term whose part it is; -1: none
  std::vector<Node *> others; // the factors of node, but for the sum of its parts
  std::vector<int> parts;
  double number;                      // the number in front when all is multiplied out
  uint64_t product;                   // what the factors add up to, each as a random number: the same for the same factors
  bool gone = false, changed = false; // itself, something in its parts
};

uint64_t mixed(const Node *node) {
  uint64_t x = uint64_t(node->id) * 0x9e3779b97f4a7c15u;
  x ^= x >> 29;
  x *= 0xbf58476d1ce4e5b9u;
  return x ^ (x >> 32);
}

// Terms that cancel once products of sums are multiplied out: S (a + b c) - S b c is S a. Nothing else is multiplied out.
class Cancellation {
public:
  Cancellation(Graph &graph, const std::vector<Graph::Scaled> &terms, bool straight) : graph_(graph), straight_(straight) {
    for (const Graph::Scaled &term : terms) append(-1, term);
    for (size_t k = 0; k < terms_.size(); ++k) takeApart(k);
  }

  // The sum without them; null where there are none.
  Node *sum() {
    bool any = false;
    for (size_t k = 0; k < terms_.size(); ++k) any = cancel(int(k)) || any;
    if (!any) return nullptr;
    Node *sum = graph_.number(0);
    for (size_t k = 0; k < terms_.size() && terms_[k].outer < 0; ++k) sum = graph_.add(sum, remaining(k));
    return sum;
  }

private:
  static constexpr size_t MOST = 128, DEPTH = 2;
  static constexpr int LEVELS = 2;

  void append(int outer, const Graph::Scaled &scaled) {
    Term term{scaled.factor, scaled.rest, outer, {}, {}, scaled.factor, 0};
    if (term.node) Graph::factorsOf(term.node, term.others);
    for (const Node *factor : term.others) term.product += mixed(factor);
    if (outer >= 0) {
      const Term &of = terms_[size_t(outer)];
      term.number *= of.number;
      for (const Node *factor : of.others) term.product += mixed(factor);
      for (int o = of.outer; o >= 0; o = terms_[size_t(o)].outer)
        for (const Node *factor : terms_[size_t(o)].others) term.product += mixed(factor);
    }
    terms_.push_back(std::move(term));
  }

  size_t depth(size_t k) const { return terms_[k].outer < 0 ? 0 : 1 + depth(size_t(terms_[k].outer)); }

  // The parts of one sum among the factors.
  void takeApart(size_t k) {
    std::vector<Node *> &others = terms_[k].others;
    auto sum = std::find_if(others.rbegin(), others.rend(), [](const Node *n) { return n->op == Node::Add; });
    std::vector<Graph::Scaled> parts;
    if (sum == others.rend() || depth(k) == DEPTH) return;
    split(*sum, 1, LEVELS, parts);
    if (terms_.size() + parts.size() > MOST) return;
    others.erase(std::next(sum).base());
    for (const Graph::Scaled &part : parts) {
      terms_[k].parts.push_back(int(terms_.size()));
      append(int(k), part);
    }
  }

  // The terms of a sum, as far as they stand near its end: what is below is shared with other sums more often.
  static void split(Node *n, double factor, int levels, std::vector<Graph::Scaled> &to) {
    Graph::Scaled s = Graph::scaled(n);
    if (levels == 0 || !s.rest || s.rest->op != Node::Add) return to.push_back({factor * s.factor, s.rest});
    for (Node *arg : s.rest->args) split(arg, factor * s.factor, levels - 1, to);
  }

  // Makes the term and an earlier one gone, if there is one that it cancels with.
  bool cancel(int k) {
    if (!free(k)) return false;
    std::vector<int> &same = known_[terms_[size_t(k)].product];
    for (int other : same) {
      if (terms_[size_t(other)].number != -terms_[size_t(k)].number || !free(other) || !worthwhile(other, k) ||
          factors(other) != factors(k))
        continue;
      drop(other);
      drop(k);
      return true;
    }
    same.push_back(k);
    return false;
  }

  // A whole term goes, or a sum of two in a loop is one product afterwards. Longer sums, and those of straight-line code, are better
  // left alone: others share them.
  bool worthwhile(int a, int b) const { return terms_[size_t(a)].outer < 0 || (!straight_ && isOneOfTwo(a) && isOneOfTwo(b)); }

  bool isOneOfTwo(int k) const {
    int outer = terms_[size_t(k)].outer;
    return outer < 0 || (depth(size_t(k)) == 1 && terms_[size_t(outer)].parts.size() == 2);
  }

  // Whether it is there as a whole.
  bool free(int k) const {
    if (terms_[size_t(k)].gone || terms_[size_t(k)].changed) return false;
    for (int o = terms_[size_t(k)].outer; o >= 0; o = terms_[size_t(o)].outer)
      if (terms_[size_t(o)].gone) return false;
    return true;
  }

  // All factors when multiplied out, in order.
  std::vector<Node *> factors(int k) const {
    std::vector<Node *> all;
    if (terms_[size_t(k)].node) Graph::factorsOf(terms_[size_t(k)].node, all);
    for (int o = terms_[size_t(k)].outer; o >= 0; o = terms_[size_t(o)].outer)
      all.insert(all.end(), terms_[size_t(o)].others.begin(), terms_[size_t(o)].others.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  void drop(int k) {
    terms_[size_t(k)].gone = true;
    for (int o = terms_[size_t(k)].outer; o >= 0; o = terms_[size_t(o)].outer) terms_[size_t(o)].changed = true;
  }

  // What is left of it in its own sum.
  Node *remaining(size_t k) {
    const Term &term = terms_[k];
    if (term.gone) return graph_.number(0);
    if (!term.changed) return term.node ? graph_.scale(term.factor, term.node) : graph_.number(term.factor);
    Node *product = graph_.number(0);
    for (int part : term.parts) product = graph_.add(product, remaining(size_t(part)));
    for (Node *factor : term.others) product = graph_.mul(product, factor);
    return graph_.scale(term.factor, product);
  }

  Graph &graph_;
  bool straight_;
  std::vector<Term> terms_; // outer ones first
  std::unordered_map<uint64_t, std::vector<int>> known_;
};

} // namespace

// The sum where terms of a and b are alike, so that they become one, or cancel; null where there are none.
Node *Graph::mergedSum(Node *a, Node *b) {
  std::vector<Scaled> all, right;
  if (!terms(a, 1, all) || !terms(b, 1, right)) return nullptr;
  size_t left = all.size();
  all.insert(all.end(), right.begin(), right.end());
  std::vector<Scaled> few = all;
  bool fewer = takeTogether(few, left, true) && few.size() <= 2; // longer sums are better left alone: others share them
  if (fewer)
    all = few;
  else
    fewer = takeTogether(all, left, false);
  bool straight = !a->loop && !b->loop;
  if (Node *sum = Cancellation(*this, all, straight).sum()) return sum;
  while (straight && multiplyOut(all)) fewer = takeTogether(all, 0, false) || fewer;
  if (!fewer) return nullptr;
  Node *fixed = number(0), *sum = number(0);
  for (const Scaled &term : all) {
    Node *part = scaledNode(term);
    if (part->fixed)
      fixed = add(fixed, part);
    else
      sum = sum->is(0) ? part : plainSum(sum, part);
  }
  return fixed->is(0) ? sum : sum->is(0) ? fixed : plainSum(sum, fixed);
}

// The sum of two products as the product of the factors that they share and a sum; null where they share none.
Node *Graph::factoredSum(const Scaled &a, const Scaled &b) {
  std::vector<Node *> left, right;
  if (a.rest) factorsOf(a.rest, left);
  if (b.rest) factorsOf(b.rest, right);
  Node *shared = nullptr, *x = number(a.factor), *y = number(b.factor);
  for (Node *factor : left) {
    auto same = std::find(right.begin(), right.end(), factor);
    if (same == right.end()) {
      x = mul(x, factor);
    } else {
      shared = shared ? mul(shared, factor) : factor;
      right.erase(same);
    }
  }
  for (Node *factor : right) y = mul(y, factor);
  return shared ? mul(shared, add(x, y)) : nullptr;
}

// A product's factors that are not fixed.
std::vector<Node *> Graph::movingFactors(Node *product) {
  std::vector<Node *> factors;
  if (product) factorsOf(product, factors);
  factors.erase(std::remove_if(factors.begin(), factors.end(), [](const Node *n) { return n->fixed; }), factors.end());
  return factors;
}

// The sum of two terms with the same moving factors.
Graph::Scaled Graph::joined(const Scaled &a, const Scaled &b, const std::vector<Node *> &moving) {
  auto fixedPart = [&](const Scaled &term) {
    std::vector<Node *> factors;
    factorsOf(term.rest, factors);
    Node *product = number(term.factor);
    for (Node *factor : factors)
      if (factor->fixed) product = mul(product, factor);
    return product;
  };
  Node *right = fixedPart(b), *sum = add(fixedPart(a), right);
  for (Node *factor : moving) sum = mul(sum, factor);
  return scaled(sum);
}

// Adds each term behind the first `left` to one before it that is equal, or differs in fixed factors only. False where there are none.
bool Graph::takeTogether(std::vector<Scaled> &terms, size_t left, bool fixedApart) {
  std::vector<Scaled> all;
  std::vector<std::vector<Node *>> moving;
  for (const Scaled &term : terms) {
    std::vector<Node *> factors = fixedApart ? movingFactors(term.rest) : std::vector<Node *>();
    auto alike = [&](size_t k) { return all[k].rest == term.rest || (!factors.empty() && moving[k] == factors); };
    size_t k = all.size() < left ? all.size() : 0;
    while (k < all.size() && !alike(k)) ++k;
    if (k == all.size()) {
      all.push_back(term);
      moving.push_back(factors);
      continue;
    }
    Scaled sum = all[k].rest == term.rest ? Scaled{all[k].factor + term.factor, term.rest} : joined(all[k], term, factors);
    all[k] = sum.factor == 0 ? Scaled{0, term.rest} : sum;
  }
  bool fewer = joinSquares(all) || all.size() < terms.size();
  all.erase(std::remove_if(all.begin(), all.end(), [](const Scaled &term) { return term.factor == 0; }), all.end());
  terms = std::move(all);
  return fewer;
}

// Takes products with a sum of two terms apart where one of these is like another term. False where there are none.
bool Graph::multiplyOut(std::vector<Scaled> &terms) {
  std::vector<Scaled> all;
  for (const Scaled &term : terms) {
    std::vector<Node *> factors;
    if (term.rest) factorsOf(term.rest, factors);
    Node *sum = factors.size() > 1 ? factors.back() : nullptr; // sums come last
    std::vector<Scaled> parts;
    if (sum && sum->op == Node::Add && sum->args[0]->op != Node::Add && sum->args[1]->op != Node::Add)
      for (Node *part : sum->args) {
        for (size_t k = 0; k + 1 < factors.size(); ++k) part = mul(factors[k], part);
        parts.push_back({term.factor * scaled(part).factor, scaled(part).rest});
      }
    bool alike = std::any_of(parts.begin(), parts.end(), [&](const Scaled &part) {
      return std::any_of(terms.begin(), terms.end(), [&](const Scaled &other) { return other.rest == part.rest; });
    });
    if (!alike) parts = {term};
    all.insert(all.end(), parts.begin(), parts.end());
  }
  bool more = all.size() > terms.size();
  terms = std::move(all);
  return more;
}

// a sin(x)^2 + a cos(x)^2 is a. True where there were such terms.
bool Graph::joinSquares(std::vector<Scaled> &terms) {
  bool found = false;
  for (size_t k = 0; k < terms.size(); ++k) {
    std::vector<Node *> factors;
    if (terms[k].rest) factorsOf(terms[k].rest, factors);
    for (size_t i = 0; i + 1 < factors.size(); ++i) {
      Node *sine = factors[i];
      if (sine != factors[i + 1] || sine->op != Node::Math || sine->text != "sin") continue;
      Node *others = number(1), *cosine = math("cos", sine->args);
      for (size_t j = 0; j < factors.size(); ++j)
        if (j != i && j != i + 1) others = mul(others, factors[j]);
      Node *partner = mul(others, mul(cosine, cosine));
      auto other = std::find_if(terms.begin(), terms.end(),
                                [&](const Scaled &t) { return t.rest == partner && t.factor == terms[k].factor && t.factor != 0; });
      if (other == terms.end()) continue;
      Scaled rest = scaled(others);
      double factor = terms[k].factor;
      other->factor = terms[k].factor = 0;
      auto same = std::find_if(terms.begin(), terms.end(), [&](const Scaled &t) { return t.rest == rest.rest; });
      if (same != terms.end())
        same->factor += factor * rest.factor;
      else
        terms.push_back({factor * rest.factor, rest.rest});
      found = true;
      break;
    }
  }
  return found;
}

// The terms of a sum, negated sums taken apart; false where there are too many to look at.
bool Graph::terms(Node *n, double factor, std::vector<Scaled> &to) {
  const size_t most = 24;
  if (to.size() > most) return false;
  Scaled s = scaled(n);
  if (s.rest && s.rest->op == Node::Add)
    return terms(s.rest->args[0], factor * s.factor, to) && terms(s.rest->args[1], factor * s.factor, to);
  to.push_back({factor * s.factor, s.rest});
  return true;
}

} // namespace tlgen
