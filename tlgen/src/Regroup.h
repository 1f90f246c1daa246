// Products of straight-line code in another order of their factors: one in which they share more.
#ifndef TLGEN_REGROUP_H
#define TLGEN_REGROUP_H

#include "Graph.h"

#include <set>
#include <tuple>

namespace tlgen {

// l_0 m_1 c_0 c_1, l_0 m_1 s_0 s_1, l_0 c_0, l_0 s_0 are six multiplications rather than seven as (l_0 c_0) m_1 c_1, (l_0 s_0) m_1 s_1:
// the two factors that most products have in common become one, over and over; of equals, two that are a product already.
class Regrouping {
public:
  // values: all that is computed together.
  Regrouping(Graph &graph, const std::vector<Node *> &values);

  // The same value.
  Node *operator()(Node *value) { return made(value); }

private:
  using Pair = std::pair<int, int>; // of factors, by number
  struct Product {
    bool negative;
    std::vector<int> factors; // in order
  };

  bool collect(const std::vector<Node *> &values);
  void addProduct(Node *node);
  int number(Node *factor);
  std::set<Pair> pairsOf(const Product &product) const;
  void count(size_t product, bool present);
  std::tuple<size_t, int, Pair> rank(Pair pair) { return {users_[pair].size(), whole_[pair], pair}; }
  void join(Pair pair);
  Node *made(Node *node);
  Node *madeProduct(const Product &product);
  Node *factor(int number);

  Graph &graph_;
  std::deque<Product> products_;
  std::unordered_map<const Node *, size_t> places_; // in products_
  std::vector<Node *> factors_;                     // by number; null for a pair
  std::unordered_map<const Node *, int> numbers_;   // of factors that are no pairs
  std::map<int, Pair> joined_;                      // pairs by number
  std::map<Pair, std::set<size_t>> users_;          // products with both factors
  std::map<Pair, int> whole_;                       // how many products have no other factors
  std::set<std::tuple<size_t, int, Pair>> order_;   // pairs by how many products have them, then whole ones; fewest first
  std::unordered_map<const Node *, Node *> made_;
  std::map<int, Node *> madePairs_;
};

} // namespace tlgen

#endif
