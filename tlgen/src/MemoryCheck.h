// Reads of what has no value and accesses beyond the end of an array, as far as they are sure: by running the model functions on what
// is known of their integers and pointers.
//
// uninitialized: a number or pointer is read that no path to the read can have assigned.
// index-range: an access that lies outside of its array whatever the unknown values are.
//
// Helpers are followed at each call with its arguments. Loops are run round by round while their condition is known, within maxRounds
// and maxLoopSteps; then, and where it is not known, all rounds are joined. A fault is reported where the program surely gets there, or
// where every pass over that place is one; for an index, only conditions on values that depend on q, qd or t may stand before it then.
// A helper that reads what has no value is the fault of the function that the variable belongs to, at the call.
//
// Not followed: members of the parameter struct but those whose values are given, and what they point to, calls deeper than maxDepth,
// objects of more than maxLeaves numbers, anything behind maxSteps steps. An array that lies in another (a row, a member) counts as one
// with its neighbours once a pointer to it is kept, because programs do walk over them. To copy a struct before all of it has values is
// no fault.
#ifndef TLGEN_MEMORYCHECK_H
#define TLGEN_MEMORYCHECK_H

#include "Diagnostics.h"
#include "Values.h"

#include <tuple>

namespace tlgen {

class MemoryCheck {
public:
  // sizes: what members of the parameter struct are, by their names.
  MemoryCheck(const Program &program, const Model &model, Diagnostics &diags, std::map<std::string, long> sizes = {})
      : program_(program), model_(model), diags_(diags), sizes_(std::move(sizes)) {}

  // Runs all model functions and reports what is found.
  void run();

private:
  // The storage of an lvalue. beyond: an index that leaves its own array, though perhaps not the whole object; empty where there is
  // none.
  struct Place {
    Value pointer;
    std::string beyond;
  };
  struct Jumps {
    State breaks, continues;
    bool isSwitch = false;
  };
  struct Choice { // a switch that is being run
    State entry;
    Value selector;
    bool known = false; // one of the cases is taken for sure
  };
  struct Frame {
    Loc call; // in the frame before
    State returned;
    Cells result;
    std::map<std::string, State> gotos;
    std::vector<Jumps> jumps;      // of the loops and switches around, outermost first
    std::vector<Choice> choices;   // of the switches around
    std::vector<size_t> diversion; // of each jump so far, what it leaves: see diverted()
  };
  struct Mark {
    Reached reached;
    size_t jumps;
  };
  struct Finding {
    const char *id;
    Loc loc;
    std::string what;
    bool sure = false, always = true;
    Reached reached = Reached::Perhaps;
  };

  // Model functions, statements and calls
  void runModel(const ModelFunction &f);
  Cells argument(const ModelFunction &f, size_t i);
  void checkRows(const ModelFunction &f, const Arg &arg);
  void exec(const Stmt *s);
  void execIf(const Stmt *s);
  void execSwitch(const Stmt *s);
  void execCase(const Stmt *s);
  void execLoop(const Stmt *s);
  void joinRounds(const Stmt *s, State &exit);
  void round(const Stmt *s);
  void jump(const Stmt *s);
  void declare(const Variable *v, const Expr *init);
  Cells call(const Expr *e);
  void runBody(const Function *f, const std::vector<Cells> &args);
  Mark mark() const { return {state_.reached, frames_.back().diversion.size()}; }
  void diverted(size_t level) { frames_.back().diversion.push_back(level); }
  void rejoin(const Mark &before, size_t level);
  void doubt(const Value &condition);

  // Expressions
  Cells eval(const Expr *e);
  Value value(const Expr *e) { return eval(e)[0].value; }
  Value binary(const Expr *e);
  Value operation(const std::string &op, const Expr *a, const Value &x, const Value &y, const Type *type);
  Value logical(const Expr *e);
  Cells conditional(const Expr *e);
  Cells assign(const Expr *e);
  Cells mathCall(const Expr *e);
  Cells load(const Expr *e);
  Cells fill(const Type *type, const Expr *e);
  Value converted(const Value &v, const Expr *e) const;
  Place place(const Expr *e);
  Place element(const Expr *e);
  Place member(const Expr *e);
  static Cells unknown(const Type *type, bool assigned = true);
  static long leaves(const Type *type);
  static Object holding(Cells cells, const Type *type);

  // Memory
  int object(size_t depth, const void *key, const std::string &name, const Type *type);
  int constant(const Variable *v);
  const Object *find(int id) const;
  void store(int id, Object o) { state_.objects[id] = std::make_shared<Object>(std::move(o)); }
  bool inside(const Place &p, long size, const Expr *e, std::vector<std::pair<int, Range>> &parts);
  Cells read(const Place &p, long size, const Expr *e);
  void write(const Place &p, const Cells &cells, const Expr *e);
  void demandValue(const Cell &cell, const Place &p, const Expr *e);
  std::string leafName(int id, const Range &offset) const;
  void visit(const char *id, const Expr *access, const Loc &loc, const std::string &name, const std::string &what, bool fault);
  bool over() const { return steps_ > maxSteps; }

  static const int maxRounds = 128;
  static const size_t maxDepth = 24;
  static const long maxLeaves = 4096; // of an object that is followed
  static const long maxLoopSteps = 20000;
  static const long maxSteps = 400000; // well below a second

  const Program &program_;
  const Model &model_;
  Diagnostics &diags_;
  const std::map<std::string, long> sizes_;
  struct Named {
    size_t depth; // of the frame that it belongs to
    std::string name;
    const Type *type;
  };
  std::vector<Named> named_;
  std::map<std::pair<size_t, const void *>, int> ids_;
  std::map<int, Object> constants_;
  std::vector<Frame> frames_;
  State state_;
  long steps_ = 0;
  std::map<std::tuple<const Expr *, int, unsigned, unsigned, std::string>, Finding> findings_; // accesses, and reads of variables
};

// The largest value of an integer member of the parameter struct with which no access is sure to leave its array, where larger ones
// are; 0 where none is known. Values that loops are not run for round by round are not tried.
long largestSize(const Program &program, const Model &model, const std::string &member);

} // namespace tlgen

#endif
