// C from a graph: a schedule's values as statements on scalars, loops and arrays.
#ifndef TLGEN_PRINTGRAPH_H
#define TLGEN_PRINTGRAPH_H

#include "PrintC.h"
#include "Schedule.h"

namespace tlgen {

// The places of the source where an elementary function may fail, numbered from 1 over all functions of a model.
class Sites {
public:
  struct Site {
    std::string function; // of math.h; "div" for a division, "compose" for one with a rule of the user
    Loc loc;
  };
  size_t number(const Node *node); // may be a new one
  const std::vector<Site> &all() const { return sites_; }

private:
  std::vector<Site> sites_;
};

// Prints the body of one function.
class GraphPrinter {
public:
  // taken: names that the body may not give to its own variables. lanes: what depends on the state is tl_lanes, parameters are numbers;
  // then printing throws Unsuitable where that cannot be.
  GraphPrinter(Schedule &schedule, const Program &program, Sites &sites, std::set<std::string> taken, bool lanes = false);

  // Where the array is: an lvalue with one % for the index, or, for a matrix of so many columns, two for row and column.
  void bind(const Array *a, const std::string &lvalue, long columns = 0);
  // Prints what an iteration of the loop, or (start) what is before it, does to rows in memory; by default nothing.
  using PrintRows = std::function<std::string(const Loop *loop, bool start, int indent)>;
  void setRows(PrintRows rows) { rows_ = std::move(rows); }
  // A value as text, where it stands in the code that is being printed.
  std::string text(const Node *n) { return show(n).text.s; }
  // A name for a variable that has none yet: the wish, or that with a number.
  std::string fresh(const std::string &wish);
  // The statements of a phase, after those of the phases before.
  std::string phase(size_t number);
  // Declarations that go before the first phase: arrays, and what remembers failures. To be asked for last.
  std::string declarations() const;
  // The end: returns the number of a site that failed. Empty where none can.
  std::string returnSite() const;
  // Numbers of caller's memory that the arrays take, from work on.
  long workspace() const { return workspace_; }
  // Numbers of all arrays, the caller's or not.
  long kept() const;

private:
  // A value as it is to be written where it is used.
  struct Shown {
    Text text;
    std::set<const Node *> carried; // what it says of carried values, which hold it only until they are updated
  };
  std::string block(const Loop *loop, int indent);
  std::string item(const Item &item, int indent);
  std::string value(const Node *n, int indent);
  std::string loopText(Loop *loop, int indent);
  std::string updates(const Loop *loop, int indent);
  std::string update(const Carry &carry, const std::string &name, const Shown &to);
  std::string batch(const Batch &b, int indent);
  std::string check(const Check &c, int indent);
  std::string clear(const Array *a, int indent);
  std::string external(const Node *n, int indent);
  Text derivativeOf(const Node *n);
  std::string quote(const Loc &loc, int indent);

  Shown show(const Node *n);
  Shown compute(const Node *n);
  Shown sum(const Node *n);
  Shown product(const Node *n);
  Shown call(const Node *n);
  static Text functionText(const std::string &name, const std::string &args, bool lanes);
  Shown both(const std::string &op, const Node *a, const Node *b);
  Shown choice(const Node *n);
  Shown combine(const std::string &op, const Node *a, const Node *b, bool integers = false);
  Text real(const Node *n);
  bool inLanes(const Node *n);
  void requireLanes(const Node *n);
  Text filled(const Node *n);
  std::string type(const Node *n);
  std::string number() const { return lanes_ ? "tl_lanes" : "tl_real"; }
  Text affine(const Node *n);
  std::string leaf(const Node *n);
  std::string element(const Array *a, const Node *index);
  std::string result(const Node *n);
  std::string fill(const std::string &text, const std::vector<Text> &indices);
  std::string index(const Node *n) { return show(n).text.s; }

  bool mustBeNamed(const Node *n, const Shown &shown) const;
  std::string arrayName(const Array *a);

  struct Binding {
    std::string lvalue;
    long columns;
  };

  Schedule &schedule_;
  const Program &program_;
  Sites &sites_;
  std::set<std::string> taken_;
  const bool lanes_;
  std::unordered_map<const Node *, bool> inLanes_;
  Blocks blocks_;
  std::unordered_map<const Node *, Shown> shown_;
  std::unordered_map<const Loop *, std::string> indexNames_;
  std::map<std::pair<const Loop *, size_t>, std::string> carriedNames_;
  std::unordered_map<const Array *, std::string> arrayNames_;
  std::vector<const Array *> declared_;
  std::map<std::string, const Variable *> tables_;                        // constants that are local to a function of the source
  std::map<std::pair<std::string, const Node *>, std::string> externals_; // by function and argument: their coefficients
  std::map<const Batch *, std::pair<std::string, std::string>> results_;  // sines and cosines, or values
  std::unordered_map<const Array *, Binding> bound_;
  PrintRows rows_;
  std::set<size_t> failing_; // sites
  std::set<std::pair<int, unsigned>> quotedBefore_;
  Loc quoted_;
  long workspace_ = 0;
  int temporaries_ = 0, carried_ = 0; // numbers of names
};

} // namespace tlgen

#endif
