// Greedy choice of shared pairs of factors.
#include "Regroup.h"

#include <algorithm>
#include <cmath>

namespace tlgen {
namespace {

bool isProduct(const Node *n) { return n->op == Node::Mul && !n->args[0]->is(-1); }

bool isStraight(const Node *n) { return !n->loop && n->op != Node::Carried && n->op != Node::Final && n->op != Node::Read; }

} // namespace

Regrouping::Regrouping(Graph &graph, const std::vector<Node *> &values) : graph_(graph) {
  if (!collect(values)) {
    products_.clear();
    places_.clear();
    return;
  }
  for (size_t k = 0; k < products_.size(); ++k) count(k, true);
  while (!order_.empty() && std::get<0>(*order_.rbegin()) > 1) join(std::get<Pair>(*order_.rbegin()));
}

// Finds the products: those that are not factors of others only. False where there are loops, which compute their values once each.
bool Regrouping::collect(const std::vector<Node *> &values) {
  std::vector<Node *> open;
  std::set<const Node *> seen;
  auto add = [&](Node *n) {
    if (!seen.insert(n).second) return;
    open.push_back(n);
    if (isProduct(n)) addProduct(n);
  };
  for (Node *value : values) add(value);
  while (!open.empty()) {
    Node *n = open.back();
    open.pop_back();
    if (!isStraight(n)) return false;
    if (isProduct(n))
      for (int k : products_[places_.at(n)].factors) add(factors_[size_t(k)]);
    else
      for (Node *arg : n->args) add(arg);
  }
  return true;
}

void Regrouping::addProduct(Node *node) {
  std::vector<Node *> factors;
  Graph::Scaled scaled = Graph::scaled(node);
  if (std::fabs(scaled.factor) != 1) factors.push_back(graph_.number(std::fabs(scaled.factor)));
  Graph::factorsOf(scaled.rest, factors);
  Product product{scaled.factor < 0, {}};
  for (Node *factor : factors) product.factors.push_back(number(factor));
  std::sort(product.factors.begin(), product.factors.end());
  places_[node] = products_.size();
  products_.push_back(std::move(product));
}

int Regrouping::number(Node *factor) {
  auto [at, isNew] = numbers_.emplace(factor, int(factors_.size()));
  if (isNew) factors_.push_back(factor);
  return at->second;
}

std::set<Regrouping::Pair> Regrouping::pairsOf(const Product &product) const {
  std::set<Pair> pairs;
  for (size_t i = 0; i < product.factors.size(); ++i)
    for (size_t j = i + 1; j < product.factors.size(); ++j) pairs.insert({product.factors[i], product.factors[j]});
  return pairs;
}

// Enters a product with its pairs, or takes it out.
void Regrouping::count(size_t product, bool present) {
  for (const Pair &pair : pairsOf(products_[product])) {
    std::set<size_t> &users = users_[pair];
    order_.erase(rank(pair));
    if (present)
      users.insert(product);
    else
      users.erase(product);
    if (products_[product].factors.size() == 2) whole_[pair] += present ? 1 : -1;
    if (!users.empty()) order_.insert(rank(pair));
  }
}

// The pair becomes one factor of all that have it.
void Regrouping::join(Pair pair) {
  int joined = int(factors_.size());
  factors_.push_back(nullptr);
  joined_[joined] = pair;
  const std::set<size_t> users = users_[pair];
  for (size_t user : users) {
    count(user, false);
    std::vector<int> &factors = products_[user].factors;
    factors.erase(std::find(factors.begin(), factors.end(), pair.first));
    factors.erase(std::find(factors.begin(), factors.end(), pair.second));
    factors.push_back(joined); // the highest number so far
    count(user, true);
  }
}

Node *Regrouping::factor(int number) {
  auto pair = joined_.find(number);
  if (pair == joined_.end()) return made(factors_[size_t(number)]);
  Node *&known = madePairs_[number];
  if (!known) {
    Node *right = factor(pair->second.second);
    known = graph_.plainProduct(factor(pair->second.first), right);
  }
  return known;
}

Node *Regrouping::madeProduct(const Product &product) {
  Node *value = factor(product.factors[0]);
  for (size_t k = 1; k < product.factors.size(); ++k) value = graph_.plainProduct(value, factor(product.factors[k]));
  return product.negative ? graph_.plainProduct(graph_.number(-1), value) : value;
}

Node *Regrouping::made(Node *node) {
  auto known = made_.find(node);
  if (known != made_.end()) return known->second;
  Graph::Making making(graph_, node->guard, node->loc);
  graph_.name = node->name;
  Node *value = node;
  auto product = places_.find(node);
  if (product != places_.end()) {
    value = madeProduct(products_[product->second]);
  } else if (!products_.empty() && !node->args.empty()) {
    std::vector<Node *> args;
    for (Node *arg : node->args) args.push_back(made(arg));
    if (args != node->args)
      value = node->op == Node::Add   ? graph_.plainSum(args[0], args[1])
              : node->op == Node::Mul ? graph_.plainProduct(args[0], args[1])
                                      : graph_.rebuild(node, std::move(args));
  }
  return made_[node] = value;
}

} // namespace tlgen
