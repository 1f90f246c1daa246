// The machine that runs a function on symbols, for Trace.cpp and its parts: memory holds nodes of a graph and pointers.
//
// An object is a row of leaves, one per number or pointer in it, in the order of memory. Inputs (coordinates, parameters, constant
// tables) are not held: reading them makes Leaf nodes. All other objects have a cell per leaf. Pointers are known at all times, up to
// indices and choices of run time. What a path of execution knows is a State; where paths meet again their states are merged.
#ifndef TLGEN_TRACER_H
#define TLGEN_TRACER_H

#include "Trace.h"
#include "Values.h"

#include <functional>

namespace tlgen::symbols {

struct Pointer;
using PointerRef = std::shared_ptr<const Pointer>;

// Where a pointer points: fixed + the sum of stride times index leaves behind the begin of an object. NULL where there is no object.
struct Pointer {
  static const int null = -1;
  int object = null;
  long fixed = 0;
  std::map<long, Node *> indices; // by stride
  Node *condition = nullptr;      // of run time: yes where it holds, no elsewhere; the members above mean nothing then
  PointerRef yes, no;
};

// A number (real, integer or truth value) or pointer in memory. Lost: its value is not known here, and must not be asked for.
struct Cell {
  enum Kind { Unset, Number, Address, Lost } kind = Unset;
  Node *node = nullptr;
  PointerRef pointer;

  bool same(const Cell &o) const;
};
using Cells = std::vector<Cell>;

// Inside of kept loops, an element of an object whose offset depends on their iteration numbers, or, over a loop that is done, one per
// iteration of that; the cell may depend on its number too.
struct Element {
  Node *at;         // Affine: leaves behind the begin
  const Loop *over; // null: one element
  size_t level;     // how many kept loops were around when it was written
  Cell cell;
  const Array *array; // that the cell reads; null: none
};
using Elements = std::vector<Element>;

struct Object {
  enum Kind { Storage, Coordinates, Parameters, Constant } kind = Storage;
  size_t depth = 0;                   // Storage: of the frame that it belongs to
  std::string text;                   // C text, with % for indices; of Storage the name
  std::vector<Node *> indices;        // in that text
  const Type *type = nullptr;         // of the object, or of an element
  bool unbounded = false;             // an array of type, of unknown length
  Slot::Kind slot = Slot::Q;          // Coordinates
  const Variable *variable = nullptr; // Constant
};

// The conditions of run time under which a path of execution is taken.
struct Path {
  const Path *outer;
  Node *condition;
  const Guard *guard;
  size_t length;
};

struct State {
  bool live = false;
  const Path *path = nullptr;
  std::map<int, std::shared_ptr<const Cells>> objects;
  std::map<int, Elements> elements; // newer ones last
};

// What is to be known of a cell that a kept loop changes, or of an element whose offset does not depend on the loop.
struct Mark {
  enum Kind {
    Steps,   // an integer or pointer that moves by a constant
    Carried, // a real
    Lost     // something else, which an iteration writes before it reads it
  } kind;
  Cell before, start; // before the loop, and as an iteration begins
  long step;          // leaves, of a pointer
  Node *carried;
};

// By object and offset.
using ElementPlace = std::pair<int, Node *>;
struct ByElementPlace {
  bool operator()(const ElementPlace &a, const ElementPlace &b) const {
    return std::make_pair(a.first, a.second->id) < std::make_pair(b.first, b.second->id);
  }
};

// A loop that is being kept: what one iteration finds and leaves, found out in several passes.
struct Kept {
  Loop *loop = nullptr;
  int pass = 0;
  State before;
  std::map<std::pair<int, long>, Mark> cells; // by object and cell
  std::map<ElementPlace, Mark, ByElementPlace> elements;
  std::map<int, std::vector<Node *>> written;                          // offsets of elements that depend on the loop, by object
  std::map<ElementPlace, std::vector<Node *>, ByElementPlace> earlier; // what was written there 1, 2.. iterations before
};

// Thrown where a comparison of a loop's iteration number with a constant changes its result at that number.
struct Split {
  size_t level; // of the loop: how many kept loops are around it
  long at;
};

bool hasEffects(const Expr *e);
long factorOf(const Node *n, const Loop *loop); // of the loop's iteration number
int bitsOf(const Type *type);                   // an integer one

class Tracer {
public:
  Tracer(Graph &graph, const Program &program, const Model &model, const TraceOptions &options)
      : graph_(graph), program_(program), model_(model), options_(options), before_(graph.size()) {}

  Traced run(const ModelFunction &f);

private:
  struct Jumps { // of a loop or switch around
    std::vector<State> breaks, continues;
    bool isSwitch = false;
  };
  struct Entry { // how a switch gets to its cases; null: default
    const Stmt *label;
    State state;
  };
  struct Frame {
    std::vector<State> returned;
    std::map<std::string, std::vector<State>> gotos;
    std::vector<Jumps> jumps;
    std::vector<std::vector<Entry>> switches;
    int result = -1; // the object that holds what it returns
  };

  // Trace.cpp: model functions, statements and calls
  Cells argument(const ModelFunction &f, size_t i);
  long count(const Count &c) const;
  Node *resultCell(int object, size_t i);
  Array *rows(int object, const std::string &name);
  void exec(const Stmt *s);
  void execBlock(const Stmt *s);
  void endScope(const Stmt *block);
  void execIf(const Stmt *s);
  void execSwitch(const Stmt *s);
  void execCase(const Stmt *s);
  void declare(const Variable *v, const Expr *init);
  void jump(const Stmt *s);
  Cells call(const Expr *e);
  void runBody(const Function *f, const std::vector<Cells> &args);
  size_t pending() const;
  void dropObjects(size_t depth);

  // TraceLoop.cpp: loops
  void execLoop(const Stmt *s);
  void runLoop(const Stmt *s);
  bool unroll(const Stmt *s, long limit);
  void round(const Stmt *s);
  bool keep(const Stmt *s, long limit);
  void passes(const Stmt *s, Kept &mine);
  void start(Kept &mine);
  void iterate(const Stmt *s, Kept &mine);
  void condition(const Stmt *s, Kept &mine);
  Node *tripsOf(Node *condition, const Loop *loop);
  bool settle(Kept &mine, const State &begin);
  bool settle(Kept &mine, Mark &mark, const Cell &now);
  Mark classify(Kept &mine, const Cell &start, const Cell &now);
  bool settleElements(Kept &mine);
  void finish(Kept &mine);
  Cell after(const Mark &mark, const Loop *loop);
  void checkOverlaps(const Kept &mine);
  void leave(int object, const Element &e, Loop *loop);
  Element tape(int object, const Element &e, Loop *loop);
  void spread(int object, const Element &e, Loop *loop);
  [[noreturn]] void endless(const Stmt *s, Node *condition);

  // TraceExpression.cpp: the values of expressions
  Cells eval(const Expr *e);
  Cell cell(const Expr *e) { return eval(e)[0]; }
  Node *number(const Expr *e);
  PointerRef pointer(const Expr *e);
  Node *truth(const Expr *e);
  Node *truth(const Cell &c, const Type *type);
  Cells load(const Expr *e);
  Cell literal(const Expr *e);
  void name(const Expr *left, const Cells &cells);
  void name(const std::string &variable, const Cells &cells);
  Cells castOf(const Expr *e);
  Node *unary(const Expr *e);
  Cell binary(const Expr *e);
  Cell pointerBinary(const Expr *e);
  PointerRef advanced(const PointerRef &p, Node *by, bool back, const Type *element);
  Node *difference(const Pointer &a, const Pointer &b, long size);
  Node *comparePointers(const std::string &op, const Pointer &a, const Pointer &b);
  bool isGiven(const Pointer &p) const;
  Node *isNull(const Pointer &p);
  void decide(const Expr *condition, State &yes, State &no);
  void branch(Node *condition, const std::function<void()> &yes, const std::function<void()> &no);
  Node *logical(const Expr *e);
  Cells conditional(const Expr *e);
  Cells assign(const Expr *e);
  Cells step(const Expr *e);
  Cell demanded(const Cell &c, const Type *type);
  Cells fill(const Type *type, const Expr *e);
  PointerRef place(const Expr *e);
  long leaves(const Type *type);

  // TraceArithmetic.cpp: operations and functions
  Node *convert(Node *n, const Type *from, const Type *to);
  Node *rounded(Node *n);
  Range bounds(const Node *n);
  Range boundsOf(const Node *n);
  long extreme(const Node *n, bool largest);
  Node *arithmetic(const std::string &op, Node *a, Node *b, const Type *type);
  Node *realArithmetic(const std::string &op, Node *a, Node *b, const Type *type);
  Node *integerArithmetic(const std::string &op, Node *a, Node *b, const Type *type);
  Node *compare(const std::string &op, Node *a, Node *b, const Type *type);
  void splitAt(const std::string &op, Node *difference);
  Node *mathCall(const Expr *e);
  Node *test(const Expr *e, const std::vector<Node *> &args);

  // TraceMemory.cpp: objects, what is in them, and the merging of paths
  int object(size_t depth, const void *key, const std::string &name, const Type *type);
  int newObject(Object o);
  int constant(const Variable *v);
  PointerRef to(int object) const;
  PointerRef moved(const PointerRef &p, long stride, Node *index);
  PointerRef moved(const PointerRef &p, long fixed);
  PointerRef choice(Node *condition, const PointerRef &yes, const PointerRef &no);
  Node *offset(const Pointer &p);
  bool sameOffset(const Pointer &a, const Pointer &b);
  Cells read(const PointerRef &p, long size, const Type *type);
  void write(const PointerRef &p, const Cells &cells);
  void writeWhere(Node *condition, const Pointer &p, const Cells &cells);
  Cells readStored(const Pointer &p, long size);

  // TraceElement.cpp: elements whose offsets depend on iteration numbers
  Cell element(int object, Node *at);
  void setElement(int object, Node *at, const Cell &cell);
  Cell writtenBefore(int object, Node *at, Node *written, Kept &loop, bool &found);
  Cell uniform(const Cells &cells, Node *at, int object);
  Node *uniform(const std::vector<Node *> &nodes, Node *number);
  Array *snapshot(const std::vector<Node *> &nodes, const std::string &name);
  Cell substituted(const Cell &c, const Loop *loop, Node *number);
  Elements mergedElements(Node *condition, const State &yes, const State &no, int object);
  bool mayMeet(Node *a, Node *b);
  bool apart(Node *a, Node *b);
  void checkConcrete(int object, long at);
  bool isTentative() const;
  void checkIndex(Node *index, long length);
  [[noreturn]] void irregular(const std::string &why) const { unsuitable(why); }

  Cells readInput(const Pointer &p, long size);
  Cell inputLeaf(const Object &o, const Pointer &p);
  struct LeafText {
    std::string text;
    std::vector<Node *> indices;
    const Type *type;
    long length = 1;
  };
  LeafText leafText(const Object &o, const Pointer &p);
  Node *memberLeaf(const LeafText &leaf, const Object &o);
  std::vector<std::pair<Node *, long>> candidates(const Pointer &p, long length, long size);
  void define(int id, Cells cells) { // a new object
    state_.elements.erase(id);
    store(id, std::move(cells));
  }
  void free(int id) {
    state_.elements.erase(id);
    state_.objects.erase(id);
  }
  void store(int id, Cells cells) { state_.objects[id] = std::make_shared<const Cells>(std::move(cells)); }
  Cell merged(Node *condition, const Cell &yes, const Cell &no);
  Cells merged(Node *condition, const Cells &yes, const Cells &no);
  State merged(const State &a, const State &b);
  State mergeAll(const std::vector<State> &states);
  const Path *under(Node *condition);
  void take(const Path *path);
  void take(State state);

  bool isVaried(Node *n);
  std::string dependence(Node *n) const;
  [[noreturn]] void unsuitable(const std::string &why) const { throw Unsuitable{why, graph_.loc}; }
  void at(const Loc &loc) { graph_.loc = loc; }
  void checkSize();
  void unrolls(const Stmt *loop, const std::string &why);

  static const long maxSteps = 4000000; // a few seconds
  static const int maxForks = 64;       // iterations that may end by a value of run time
  static const int maxPasses = 12;      // over a kept loop
  static const int surveyed = 2;        // passes: the first finds what moves, the second what is written at moving places
  static const size_t maxDepth = 400;
  static const long maxLeaves = 1 << 20;

  Graph &graph_;
  const Program &program_;
  const Model &model_;
  const TraceOptions &options_;
  const size_t before_; // nodes before this function
  std::vector<Object> objects_;
  std::map<std::pair<size_t, const void *>, int> ids_;
  std::map<std::pair<std::string, std::vector<Node *>>, int> targets_; // of pointers in inputs
  std::map<int, Cells> constants_;
  std::map<const Record *, long> records_; // their leaves
  std::deque<Path> paths_;
  std::deque<Frame> frames_; // references stay good
  std::unordered_map<const Node *, bool> varied_;
  std::unordered_map<const Node *, Range> bounds_;
  State state_;
  long dof_ = -1;            // -1: not known
  std::vector<Kept *> kept_; // outermost first
  std::map<std::vector<Node *>, Array *> snapshots_;
  size_t choices_ = 0; // of run time, so far
  bool splits_ = true; // comparisons may split loops
  std::vector<Node *> assigned_;
  std::vector<Unsuitable> unrolled_; // loops that were not kept
  long steps_ = 0;
};

} // namespace tlgen::symbols

#endif
