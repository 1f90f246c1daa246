// Values of a loop's iterations as another loop, or what comes after, sees them.
#ifndef TLGEN_TAPES_H
#define TLGEN_TAPES_H

#include "Graph.h"

namespace tlgen {

class Tapes {
public:
  // recompute: values are made again where that takes no function; otherwise all are read from tapes.
  explicit Tapes(Graph &graph, bool recompute = true) : graph_(&graph), recompute_(recompute) {}

  // The value of a node of another loop, in the iteration that `there` gives: for the index of each of the node's loops a node here.
  // Values that depend on what iterations carry are read from a tape where making them again takes a function; all others are made
  // again from these. there remembers what was made.
  Node *at(Node *node, Graph::Replacement &there);

  // Whether the value depends on what iterations of its loop carry.
  bool followsCarried(Node *node);

private:
  bool carriedOn(const Node *node) const;
  bool mustTape(Node *node);
  Array *tape(Node *node);
  Node *place(const Loop *loop);

  Graph *graph_;
  bool recompute_;
  std::map<Node *, Array *> tapes_;
  std::map<Node *, bool> follows_;
};

} // namespace tlgen

#endif
