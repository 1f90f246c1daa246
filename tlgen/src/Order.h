// What a set of values needs, in an order in which it can be computed.
#ifndef TLGEN_ORDER_H
#define TLGEN_ORDER_H

#include "Graph.h"

#include <set>
#include <unordered_set>

namespace tlgen {

// One thing to do in a loop's body, or outside of all loops: a node, or an inner loop as a whole.
struct Step {
  Node *node = nullptr;
  Loop *loop = nullptr;
};

// The nodes and loops that the given nodes need, with everything that reaches them through carried values and arrays, and with the
// conditions that they are computed under.
class Needed {
public:
  explicit Needed(const std::vector<Node *> &nodes);

  bool has(const Node *node) const { return known_.count(node) != 0; }
  bool has(const Loop *loop) const { return loops_.count(loop) != 0; }
  bool has(const Array *array) const { return arrays_.count(array) != 0; }
  // Whether what the carried value is at the end of an iteration is needed.
  bool has(const Loop *loop, size_t carried) const { return carries_.count({loop, carried}) != 0; }

  // In the order of making.
  const std::vector<Node *> &nodes() const { return nodes_; }
  // The steps of a loop's body (null: outside of all), in order.
  const std::vector<Step> &steps(const Loop *loop) const;

private:
  void add(Node *node);
  void add(Loop *loop);
  void sort();

  std::vector<Node *> todo_, nodes_;
  std::unordered_set<const Node *> known_;
  std::set<const Loop *, ById> loops_;
  std::set<const Array *, ById> arrays_;
  std::set<std::pair<const Loop *, size_t>> carries_;
  std::map<const Loop *, std::vector<Step>> steps_;
};

} // namespace tlgen

#endif
