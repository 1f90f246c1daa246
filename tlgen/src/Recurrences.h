// Taylor coefficients in time of the values of straight-line code along a motion, order by order.
//
// Where accelerations are values of q, qd and t, coefficient k of each value follows from coefficients up to k of its arguments, and
// that of an acceleration gives coefficients k + 1 of its velocity and k + 2 of its coordinate. What is summed up is in
// taylor/convolve.h.
#ifndef TLGEN_RECURRENCES_H
#define TLGEN_RECURRENCES_H

#include "Graph.h"

namespace tlgen {

class Recurrences {
public:
  // The accelerations, one per coordinate. Throws Unsuitable where there is no recurrence for a function, a value depends on a choice
  // by the state, or the code would be too long.
  Recurrences(Graph &graph, std::vector<Node *> accelerations);

  // Values of parameters alone that the recurrences take.
  const std::vector<Node *> &fixed() const { return fixed_; }

  // Statements that compute coefficients 0 of all values, and coefficients k >= 1, and those of the motion that follow. They use x: the
  // rows, fixed: the values above, q, qd, t: the state, k, place, first: see tl_series_between.
  std::string first() const;
  const std::string &later() const { return later_; }

  // The pairs of rows of which an order takes products: one number after the other, as tl_series_pair; where in x what is older begins.
  const std::vector<std::pair<long, long>> &pairs() const { return pairs_; }
  long older() const { return rows_ * rowLength + (onces_ + 3) / 4 * 4; }
  // How many numbers x has. The row of a coordinate.
  long workspace() const;
  std::string coordinate(const std::string &i) const { return "x + " + std::to_string(rowLength) + " * " + i; }

private:
  static const long rowLength = 32; // TL_SERIES_ROW

  struct Value {
    Node *node = nullptr;
    long place = 0;                                                  // in the order of computation
    long forward = -1;                                               // row; -1: none
    bool second = false;                                             // of a product
    long weighted = -1;                                              // forward, j times coefficient j
    long once = -1;                                                  // a number that is computed with coefficient 0
    std::string name() const { return "v" + std::to_string(place); } // of the coefficient under way
  };

  struct Power {
    Node *base;
    double exponent;
  };

  bool varies(const Node *n) const;
  static Power powerOf(Node *n);
  Node *prepared(Node *n);
  Node *onePlusSquare(Node *x) const;
  void add(Node *n);
  void addMath(Node *n);
  Value &value(const Node *n) { return values_.at(n); }
  const Value &value(const Node *n) const { return values_.at(n); }
  void needForward(const Node *n);
  void needSecond(const Node *n);
  void needWeighted(const Node *n);
  void needOnce(const Node *n);
  void needProduct(const Node *a, const Node *b);
  std::string row(long number) const;
  std::string between(long a, const Node *b);
  std::string fixedText(const Node *n) const;
  std::string operandText(const Node *n) const;
  std::string initial(const Value &v) const;
  std::string onceText(const Value &v) const;
  std::string general(const Value &v);
  std::string mathGeneral(const Value &v);
  std::string keep(const Value &v, bool first) const;
  std::string follow(const std::string &k) const;
  std::string makeLater();
  long state(const Node *leaf) const;
  std::string once(const Value &v) const;

  Graph &graph_;
  std::vector<Node *> accelerations_, fixed_;
  std::unordered_map<const Node *, size_t> fixedNumbers_;
  std::unordered_map<const Node *, Value> values_;
  std::vector<Node *> order_;
  mutable std::unordered_map<const Node *, bool> varies_;
  Graph::Replacement prepared_;
  long rows_ = 0, onces_ = 0;
  std::vector<std::pair<long, long>> pairs_;
  std::string later_;
};

} // namespace tlgen

#endif
