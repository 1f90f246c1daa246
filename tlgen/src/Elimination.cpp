// Elimination by least degree, with values for numbers.
#include "Elimination.h"
#include "Regroup.h"
#include "Trace.h"

#include <algorithm>

namespace tlgen {
namespace {

// Products of one solution: more make code that is slower than a loop over a full matrix.
const long mostProducts = 20000;

class Elimination {
public:
  Elimination(Graph &graph, const Results &simulate, long n, long m1, long m2)
      : graph_(graph), simulate_(simulate), n_(n), m1_(m1), m_(m1 + m2), rows_(size_t(n + m1 + m2)), right_(rows_.size()),
        ready_(rows_.size(), 0), inverse_(rows_.size()), solved_(rows_.size()) {}

  Results run() {
    regroup();
    readMatrix("M", 0, 0, n_);
    readMatrix("A_phi", n_, 0, n_);
    readMatrix("A_psi", n_ + m1_, 0, n_);
    readVector("Q", 0);
    readVector("b_phi", n_);
    readVector("b_psi", n_ + m1_);
    const std::vector<Row> given = rows_;
    eliminate(0, n_);
    eliminate(n_, n_ + m_);
    substitute();
    return results(given);
  }

private:
  using Row = std::map<long, Node *>; // by column; what is not there is zero

  // Products that share most, as in other straight-line code.
  void regroup() {
    std::vector<Node *> values;
    for (const auto &[name, array] : simulate_.arrays)
      if (name != "phi" && name != "phi_dot" && name != "psi")
        for (const Write &write : array->writes) values.push_back(write.value);
    if (graph_.simplifying) regrouping_ = std::make_unique<Regrouping>(graph_, values);
  }

  // Elements of a result, by number.
  Row elements(const std::string &name) {
    Row all;
    auto found = simulate_.arrays.find(name);
    if (found == simulate_.arrays.end()) return all;
    for (const Write &write : found->second->writes) {
      if (write.loop || !write.index->isConstant()) throw Unsuitable{"an element of the equations depends on a loop", write.index->loc};
      Node *value = regrouping_ ? (*regrouping_)(write.value) : write.value, *&element = all[write.index->offset];
      element = element ? graph_.add(element, value) : value;
    }
    return all;
  }

  void readMatrix(const std::string &name, long row, long column, long columns) {
    for (auto &[place, value] : elements(name)) {
      const long i = row + place / columns, j = column + place % columns;
      if (!value->is(0)) rows_[size_t(i)][j] = rows_[size_t(j)][i] = value;
    }
  }

  void readVector(const std::string &name, long row) {
    for (auto &[place, value] : elements(name)) right_[size_t(row + place)] = value;
  }

  Node *product(Node *a, Node *b) {
    if (++products_ > mostProducts) throw Unsuitable{"the solution of the equations in straight-line code is too long", {}};
    return a->isNumber() || b->isNumber() ? graph_.mul(a, b) : graph_.plainProduct(a, b);
  }

  // to - a b, where what is zero is null.
  void subtract(Node *&to, Node *a, Node *b) {
    if (!a || !b || a->is(0) || b->is(0)) return;
    Node *term = graph_.neg(product(a, b));
    to = !to || to->is(0) ? term : graph_.plainSum(to, term);
  }

  // Of those that are left.
  long cheapest(const std::set<long> &left) const {
    auto rank = [this](long k) { return std::make_tuple(rows_[size_t(k)].size(), ready_[size_t(k)], k); };
    return *std::min_element(left.begin(), left.end(), [&](long a, long b) { return rank(a) < rank(b); });
  }

  void eliminate(long begin, long end) {
    std::set<long> left;
    for (long k = begin; k < end; ++k) {
      left.insert(left.end(), k);
      entry_.push_back(diagonal(k));
    }
    while (!left.empty()) {
      const long k = cheapest(left);
      left.erase(k);
      take(k);
    }
  }

  Node *diagonal(long k) const {
    auto found = rows_[size_t(k)].find(k);
    if (found == rows_[size_t(k)].end()) throw Unsuitable{"a pivot is zero at all states", {}};
    return found->second;
  }

  Node *oneOver(Node *pivot) {
    const size_t known = graph_.size();
    Node *inverse = graph_.recip(pivot);
    if (graph_.size() > known) inverse->judged = true;
    return inverse;
  }

  // Eliminates unknown k: of the others those whose equations have it change.
  void take(long k) {
    Row row = rows_[size_t(k)];
    Node *inverse = inverse_[size_t(k)] = oneOver(diagonal(k));
    row.erase(k);
    for (auto &[i, a] : row) {
      Node *factor = product(a, inverse);
      rows_[size_t(i)].erase(k);
      for (auto &[j, b] : row)
        if (j >= i) {
          Node *&element = rows_[size_t(i)][j];
          subtract(element, factor, b);
          rows_[size_t(j)][i] = element;
        }
      subtract(right_[size_t(i)], factor, right_[size_t(k)]);
      ready_[size_t(i)] = std::max(ready_[size_t(i)], ready_[size_t(k)] + 1);
    }
    rows_[size_t(k)] = row;
    order_.push_back(k);
  }

  // The unknowns, last first. Those of rows are -lambda.
  void substitute() {
    for (size_t at = order_.size(); at-- > 0;) {
      const size_t k = size_t(order_[at]);
      Node *sum = right_[k];
      for (auto &[j, a] : rows_[k]) subtract(sum, a, solved_[size_t(j)]);
      solved_[k] = sum ? product(sum, inverse_[k]) : graph_.number(0);
    }
  }

  Results results(const std::vector<Row> &given) {
    Results made;
    made.grouped = true;
    std::vector<Node *> qdd(solved_.begin(), solved_.begin() + n_), lambda, force, inverse, growth;
    for (long r = 0; r < m_; ++r) lambda.push_back(graph_.neg(solved_[size_t(n_ + r)]));
    for (long i = 0; i < n_; ++i) {
      Node *sum = nullptr;
      for (auto &[j, a] : given[size_t(i)])
        if (j >= n_) subtract(sum, a, solved_[size_t(j)]);
      force.push_back(sum ? sum : graph_.number(0));
    }
    std::set<Node *> known;
    for (long k = 0; k < n_ + m_; ++k) {
      Node *of = inverse_[size_t(k)];
      if (k < n_ && known.insert(of).second) inverse.push_back(of);
      if (k >= n_ || oneOver(entry_[size_t(k)]) != of) growth.push_back(product(entry_[size_t(k)], of));
    }
    put(made, "qdd", qdd), put(made, "lambda", lambda), put(made, "Qc", force);
    put(made, "inverse", inverse), put(made, "growth", growth);
    return made;
  }

  void put(Results &made, const std::string &name, const std::vector<Node *> &values) {
    Array *array = made.arrays[name] = graph_.array(name, long(values.size()));
    for (size_t i = 0; i < values.size(); ++i) graph_.write(array, nullptr, graph_.integer(long(i)), values[i]);
  }

  Graph &graph_;
  const Results &simulate_;
  const long n_, m1_, m_;
  std::unique_ptr<Regrouping> regrouping_;
  std::vector<Row> rows_; // symmetric; of what is eliminated, the row as it was then
  std::vector<Node *> right_;
  std::vector<long> ready_;     // how many pivots, one after the other, come before
  std::vector<Node *> entry_;   // a pivot before others of its kind were eliminated
  std::vector<Node *> inverse_; // of pivots
  std::vector<Node *> solved_;
  std::vector<long> order_;
  long products_ = 0;
};

} // namespace

Results eliminated(Graph &graph, const Results &simulate, long n, long m1, long m2) {
  return Elimination(graph, simulate, n, m1, m2).run();
}

} // namespace tlgen
