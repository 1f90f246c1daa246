// From values to statements: which values of a graph some outputs need, in which loop each is computed, and in which order.
//
// Outputs come in phases, printed one after the other (what a solver needs, then what needs its solution). A value outside of loops
// is computed once, in the first phase that needs it; a loop runs again in each phase that still needs something of it, with that
// alone.
#ifndef TLGEN_SCHEDULE_H
#define TLGEN_SCHEDULE_H

#include "Jets.h"
#include "Operations.h"

#include <memory>
#include <set>

namespace tlgen {

// What is printed without a break: everything that these arrays hold and these updates of rows do. kept: values that are computed
// though nothing needs them.
struct Phase {
  std::vector<const Array *> arrays;
  std::vector<RowUpdate> updates;
  std::vector<Node *> kept = {};
  long columns = 0; // of the rows
};

// sin and cos, or another function of math.h, at many arguments by one statement.
struct Batch {
  int id;
  std::string function;     // "sincos", or the function's own name
  std::vector<Node *> args; // outside of loops: the arguments
  Loop *loop = nullptr;     // else the loop whose iterations fill
  Array *filled = nullptr;  // this array with arguments, null where they stand in
  Node *first = nullptr;    // a row of numbers from this leaf on
};

// Where a function of the batch stands in its results.
struct BatchPlace {
  const Batch *batch;
  Node *index;
};

// A function that may have no value or no derivative where it is computed.
struct Check {
  const Guard *guard;
  Node *outside; // true there
  Node *node;
};

struct Item {
  enum Kind {
    Value,    // node
    Repeat,   // loop
    Leave,    // what write writes into array
    Evaluate, // batch
    Test,     // check
    Clear,    // array
    Start,    // rows that loop carries, before it begins
    Rows,     // rows that an iteration of loop changes; null: outside of all loops
    Condition // of loop: whether there is another iteration
  } kind;
  Node *node = nullptr;
  Loop *loop = nullptr;
  Array *array = nullptr;
  const Write *write = nullptr;
  const Batch *batch = nullptr;
  const Check *check = nullptr;
};

// The statements of each loop's body in order; null: those outside of all loops.
using Blocks = std::unordered_map<const Loop *, std::vector<Item>>;

class Schedule {
public:
  Schedule(Graph &graph, std::vector<Phase> phases);
  ~Schedule();

  size_t phases() const { return phases_.size(); }
  // To be called for each phase in order.
  Blocks order(size_t phase);

  // True where a value has one user, in the same loop's body, so that it can be written where it is used.
  bool isUsedOnce(const Node *node) const;
  // True where the value is computed though nothing may need it.
  bool isKept(const Node *node) const { return kept_.count(node) > 0; }
  // Where the node is found in the results of a batch; null where it is in none.
  const BatchPlace *place(const Node *node) const;
  // True where the phase that was ordered last computes, or uses, that carried value of a loop.
  bool carries(const Loop *loop, size_t which) const;
  // Updates of rows by a loop's iterations, or (before) of rows that it carries, in the phase that was ordered last.
  std::vector<RowUpdate> updates(const Loop *loop, bool before) const;
  // The highest derivative that is needed of an external function at an argument: of a Taylor node.
  int highest(const Node *taylor) const { return highest_.at({taylor->text, taylor->args[0]}); }
  Operations operations() const { return operations_; }

private:
  struct Wanted;
  class Ordering;
  struct Use {
    int count = 0;
    bool deeper = false; // some user varies in a loop that the value does not vary in
  };
  std::set<const Node *> computing() const;
  void makeChecks();
  void makeBatches();
  void countUses();
  void countOperations(const Wanted &needed);
  Wanted need(size_t phase, bool all);
  void batchScalars(const std::vector<Node *> &nodes);
  bool batchInLoop(Node *node);
  void batchAlone(Node *node);

  Graph &graph_;
  std::vector<Phase> phases_;
  std::set<const Node *> kept_;
  std::vector<Check> checks_;
  std::deque<Batch> batches_;
  std::unordered_map<const Node *, BatchPlace> places_;
  std::map<long, Loop *> standIns_;                              // by trips
  std::map<std::pair<std::string, const Node *>, Batch *> rows_; // by function and argument
  std::unordered_map<const Node *, Use> uses_;
  std::unordered_map<const Node *, std::vector<size_t>> checksOf_;
  Operations operations_;
  std::map<std::pair<std::string, const Node *>, int> highest_;
  std::set<const Node *> doneNodes_;
  std::set<const Array *> doneArrays_;
  std::set<const Batch *> doneBatches_;
  std::set<const Check *> doneChecks_;
  std::unique_ptr<Wanted> now_; // of the phase ordered last
};

} // namespace tlgen

#endif
