// What is kept of each iteration, and what is made again from it.
#include "Tapes.h"

namespace tlgen {
namespace {

bool isEndOfIteration(const Node *node) {
  for (const Carry &carry : node->loop->carried)
    if (carry.out == node) return true;
  return false;
}

long most(const Node *count) {
  long sum = count->offset;
  for (auto &[loop, factor] : count->terms)
    if (factor > 0) sum += factor * (most(loop->trips) - 1);
  return sum;
}

// Iterations at most, of the loop and those around it together.
long extent(const Loop *loop) { return loop ? most(loop->trips) * extent(loop->outer) : 1; }

} // namespace

Node *Tapes::at(Node *node, Graph::Replacement &there) {
  if (!node->loop) return node;
  auto known = there.find(node);
  if (known != there.end()) return known->second;
  if (node->op == Node::Affine) return graph_->replace(node, there);
  Node *here;
  if (mustTape(node)) {
    Node *index = graph_->replace(place(node->loop), there);
    here = graph_->read(tape(node), index);
  } else {
    std::vector<Node *> args;
    for (Node *arg : node->args) args.push_back(at(arg, there));
    const Guard *guard = graph_->remade(node->guard, [&](Node *of) { return at(of, there); });
    Graph::Making making(*graph_, guard, node->loc);
    here = graph_->rebuild(node, std::move(args));
  }
  return there[node] = here;
}

bool Tapes::carriedOn(const Node *node) const {
  return node->op == Node::Carried || node->op == Node::Final || (node->op == Node::Read && node->array->home);
}

bool Tapes::mustTape(Node *node) {
  if (!node->loop) return false;
  if (carriedOn(node)) return true;
  if (!recompute_) return node->op != Node::Number && !isInteger(node); // arrays hold reals only
  if (!followsCarried(node)) return false;
  return node->op == Node::Math || node->op == Node::Recip || node->op == Node::Taylor || isEndOfIteration(node);
}

bool Tapes::followsCarried(Node *node) {
  auto known = follows_.find(node);
  if (known != follows_.end()) return known->second;
  bool result = node->loop && carriedOn(node);
  for (Node *arg : node->args)
    if (!result) result = followsCarried(arg);
  return follows_[node] = result;
}

// The array that holds the value of node in every iteration of its loops.
Array *Tapes::tape(Node *node) {
  Array *&tape = tapes_[node];
  if (!tape) {
    tape = graph_->array("tape", extent(node->loop));
    tape->tape = !node->loop->outer;
    graph_->write(tape, node->loop, place(node->loop), node);
  }
  return tape;
}

// The place of an iteration in a tape.
Node *Tapes::place(const Loop *loop) {
  if (!loop->outer) return loop->index;
  Node *before = place(loop->outer);
  return graph_->integerOp("+", graph_->integerOp("*", graph_->integer(most(loop->trips)), before), loop->index);
}

} // namespace tlgen
