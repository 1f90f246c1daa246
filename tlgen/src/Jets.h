// Coefficients in a motion shape: {1, s, s^2} times {1, tangents}, of the values of a graph, as values of the same graph.
//
// The tangents of a value are a sum over directions. Where columns are explicit, a direction is one column of the result. Otherwise it
// is a column that follows from iteration numbers, or a whole row in memory: the tangents of something that a loop carries or an array
// holds. So what a loop's body does to tangents comes down to a few rows with one factor each.
//
// Every loop is made anew, with what its carried values have in each coefficient; coefficients that stay zero are not there.
#ifndef TLGEN_JETS_H
#define TLGEN_JETS_H

#include "Analyses.h"
#include "Tapes.h"

#include <functional>
#include <set>
#include <tuple>

namespace tlgen {

class Needed;

const int POWERS = 3; // of s: 1, s, s^2

// Rows in memory begin so many numbers apart, or a multiple of it (TL_ROW_PAD of generated code).
const long ROW_PAD = 8;
inline long padded(long columns) { return (columns + ROW_PAD - 1) / ROW_PAD * ROW_PAD; }

// Tangents in memory: count rows of numbers, one number per column.
struct Row {
  int id;
  std::string name;
  long count;
  Loop *carriedBy; // the loop that carries it, null for tapes and results
  bool summed;     // starts at zero, and updates add
  bool result;     // a result of the function
  long given = 0;  // numbers between rows of a constant array called name; 0: made by updates
};

// A constant array that generated code holds, square, its rows stride numbers apart. Without activity the tangents of inputs are its
// rows and elements: numbers that are not looked at when code is generated.
struct Identity {
  std::string name;
  long stride;
};

struct Direction {
  int id;
  Node *column; // null for a row
  Row *row;
  Node *index;          // which of the rows; null where there is one
  Node *bound;          // columns from here on count as zero; null: none
  bool updated;         // of a carried row: as this iteration leaves it, but for single columns; not as it found it
  Node *from = nullptr; // columns before this one count as zero; null: none
};

using Tangents = std::map<const Direction *, Node *, ById>;

// row[index] = or += sum of factor * row + factors at single columns. Updates of a loop's body run in their order, column by column;
// single columns are added when all of the body's updates are done.
struct RowUpdate {
  Loop *loop; // null: outside of all
  Row *row;
  Node *index;        // null where there is one
  bool add;           // to what is there
  bool before;        // before the loop that carries the row begins: the row's first content (zero where there is no such update)
  Node *from, *bound; // columns that can be other than zero; null: all
  Tangents sum;
  bool fill = false; // single columns alone, each of them once
};

// The rows, and those that their content comes from.
std::set<const Row *> sourcesOf(std::set<const Row *> rows, const std::vector<RowUpdate> &updates);

// The coefficients of an input. tangents: column and value.
struct LeafJet {
  Node *s = nullptr, *s2 = nullptr; // null: zero
  std::vector<std::pair<Node *, Node *>> tangents[POWERS];
};

// factor times coefficient s^power of value.
struct Term {
  Node *value;
  int power;
  double factor;
};

// Something to be computed: element index of a result, once for each iteration of loop.
struct JetOutput {
  Loop *loop;
  Node *index;
  std::vector<Term> terms;
  Array *scalar = nullptr; // takes the sum of the coefficients without tangents
  Row *row = nullptr;      // takes the sums of the tangents
  Array *matrix = nullptr; // the same with explicit columns: element index * columns + column
  bool upper = false;      // columns below the index are not wanted
};

class Jets {
public:
  // inputs: the coefficients of a leaf, of leafs at the same indices. identity: of so many columns at least.
  Jets(Graph &graph, std::function<LeafJet(Node *)> inputs, int powers, long columns, bool explicitColumns,
       const Analyses &analyses = {}, const Identity &identity = {});

  Row *row(const std::string &name, long count);

  // Computes the outputs: leaves Writes in their arrays, and updates. besides: values to be computed that no output needs.
  void run(const std::vector<JetOutput> &outputs, const std::vector<Node *> &besides = {});

  // Of values outside of loops, and after run.
  Node *coefficient(Node *node, int power);
  const Tangents &tangents(Node *node, int power);

  // What results are wrong because of; null where there is no such thing. An input whose column is not constant, where columns are
  // explicit, or does not follow from iteration numbers, where they are not. A function without a formula for a derivative.
  const Node *unsuitable() const { return unsuitable_; }
  const Node *noFormula() const { return noFormula_; }

  const std::vector<RowUpdate> &updates() const { return updates_; }
  // Values that are to be computed though no output needs them.
  const std::set<Node *, ById> &kept() const { return kept_; }

private:
  struct Info {
    Node *c[POWERS] = {};
    Tangents t[POWERS];
    bool known[POWERS] = {};
  };
  // What of a carried value is not always zero.
  struct Present {
    bool c[POWERS] = {};
    bool t[POWERS] = {};
    std::set<const Direction *, ById> columns[POWERS]; // explicit ones

    void all(bool tangents) {
      for (int p = 0; p < POWERS; ++p) c[p] = true, t[p] = tangents;
    }
  };
  // A coefficient of a carried value, its whole row of tangents, or one explicit column of them.
  struct Place {
    size_t carried;
    int power;
    bool row;
    const Direction *column; // null: none
    bool operator<(const Place &o) const {
      auto key = [](const Place &p) { return std::make_tuple(p.carried, p.power, p.row, p.column ? p.column->id : -1); };
      return key(*this) < key(o);
    }
  };
  // What is known of a loop's carried values from one trial of its body to the next. What starts the same is taken for the same until
  // an iteration is seen to end with a difference.
  struct Trial {
    std::vector<Present> present; // by number of the carried value
    std::set<std::pair<Place, Place>> different;
    std::map<Place, Place> same;               // to an earlier place
    std::vector<std::pair<Place, Node *>> own; // places with a number (the Carried node) or row (null) of their own
    std::map<Place, Tangents> ends;            // of rows, as sums over rows that the iteration began with or has updated
  };
  // A part of the tangents of an array's elements: factor at a column, or times the first columns of a row.
  struct Part {
    Node *column; // null for a row
    Row *row;
    Node *bound;
    Node *factor;
  };
  struct Stored {          // an array of the source in memory
    Node *taped = nullptr; // of tapes: their coefficients are made again from this value's
    std::vector<Part> parts[POWERS];
    Array *c[POWERS] = {};
    Row *rows[POWERS] = {};                                  // general tangents
    std::vector<std::pair<Node *, Array *>> columns[POWERS]; // local ones: column as a function of iteration, and factors
    Node *bound[POWERS] = {};                                // of rows, as a function of iteration
    Array *wide[POWERS] = {};                                // explicit columns of arrays that are written in several places
    Loop *loop = nullptr;                                    // the loop that the functions of iteration refer to
  };

  const Direction *direction(Direction d);
  const Direction *column(Node *node) { return direction({0, node, nullptr, nullptr, nullptr, false}); }

  Node *value(Node *node) { return coefficient(node, 0); }
  const Guard *remade(const Guard *guard);
  Node *computeValue(Node *node);
  Node *computeHigher(Node *node, int power);
  Node *partial(Node *function, size_t argument);
  Tangents computeTangents(Node *node, int power);
  Tangents finalTangents(Node *node, int power);
  Tangents readTangents(Node *node, int power);
  // sum += factor * t, and sum += term in a direction; what cancels is not there.
  void accumulate(Tangents &sum, Node *factor, const Tangents &t);
  void accumulate(Tangents &sum, const Direction *direction, Node *term);
  void seed(Tangents &sum, const Node *leaf, Node *column, Node *factor);
  void seedAnywhere(Tangents &sum, Node *column, Node *factor);
  Node *wideIndex(Node *index, long column);

  void runRegion(Loop *loop);
  void storeBefore(Loop *loop, const Loop *inner);
  void storeWrites(Array *array, Loop *loop);
  void runLoop(Loop *loop);
  bool tryLoop(Loop *loop);
  bool note(Present &present, Node *value, int power);
  bool noteDifferences(const Loop *loop);
  void forget(const Loop *loop);
  bool innermost(const Loop *loop) const;
  void startCarried(Loop *loop, size_t k);
  Node *startNumber(Loop *loop, Place place, Node *init);
  void startRow(Loop *loop, Place place, const Tangents &init, Info &in);
  void finishCarried(Loop *loop, size_t k);
  const Direction *carriedRow(Loop *loop, size_t k, int power, bool updated);
  Tangents keepUpdated(Loop *loop, size_t k, int power, Tangents sum);
  void finishLoop(Loop *loop, size_t firstUpdate);
  void finishOutput(const JetOutput &output);
  Node *outputNumber(const JetOutput &output, const Direction *column);
  Tangents outputRow(const JetOutput &output);
  Node *number(Node *node, int power, const Direction *direction);
  const Carry *carriedTo(const JetOutput &output, const Term &term) const;
  void finishWrite(Array *array, const Write &write);
  Array *newArray(const Array *like, long length);
  void storeTangents(Stored &stored, Array *array, const Write &write, int power);
  bool splitTangents(Stored &stored, const Write &write, int power);
  Node *ownColumns(const Direction *direction, Loop *clone, Tangents &own) const;
  Node *tapedAt(const Stored &stored, Node *ofIteration, Node *index);
  void dropUnused();
  void keep(Node *node);
  void keepAll();
  void closeSums();
  struct ClosedSum;
  bool isClosed(const RowUpdate &update, ClosedSum &sum) const;
  const Row *tailOf(const ClosedSum &sum);
  void replaceSum(const Row *row, const ClosedSum &sum, const Row *tail);
  bool isReferred(const Row *row, const Loop *loop) const;
  void separateFills();
  Loop *fillLoop(Node *trips);
  void boundUpdates(Loop *clone, size_t firstUpdate);

  Graph &graph_;
  std::function<LeafJet(Node *)> inputs_;
  int powers_;
  long columns_;
  bool explicit_;
  Analyses analyses_;
  Identity identity_;
  Row *identityRow_ = nullptr;
  const Node *unsuitable_ = nullptr, *noFormula_ = nullptr;
  const Needed *needed_ = nullptr;
  const std::vector<JetOutput> *outputs_ = nullptr;
  std::unordered_map<Node *, Info> info_;
  std::map<const Loop *, Loop *> clones_;
  std::map<const Loop *, Trial> trials_;
  std::map<std::pair<const Loop *, std::pair<size_t, int>>, Row *> carriedRows_; // of new loops
  std::map<Node *, std::pair<Loop *, size_t>> outOf_;                            // end values of the loops under way -> carried
  std::map<const Array *, Stored> stored_;
  mutable Tapes tapes_;
  std::map<Node *, Loop *> fills_;                                      // by trips
  std::map<std::pair<const Loop *, Node *>, Graph::Replacement> taped_; // by the loop and the iteration there
  std::set<std::pair<const Array *, size_t>> written_;                  // writes that are in stored_
  std::map<std::string, Direction *> directions_;
  std::deque<Direction> allDirections_;
  std::deque<Row> rows_;
  std::vector<RowUpdate> updates_;
  std::set<Node *, ById> kept_;
};

} // namespace tlgen

#endif
