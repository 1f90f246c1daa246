// A model function as values: what it computes, with neither variables nor memory. The adjoint emitter works on this.
//
// A node is a pure function of its arguments and exists once (two requests for the same value give the same node). A loop that is kept
// gives nodes of its own: its iteration number and what it carries from one iteration to the next. Arrays hold what iterations leave
// behind. A node belongs to the innermost loop that its arguments vary in, so nothing is computed more often than it must be.
#ifndef TLGEN_GRAPH_H
#define TLGEN_GRAPH_H

#include "Program.h"

#include <functional>
#include <unordered_map>

namespace tlgen {

struct Array;
struct Loop;
struct Node;

// Where inputs of a function live: an array that the function is called with, a member of the parameters, or a constant table.
struct Slot {
  enum Kind {
    Q,
    Qd,
    T,
    Qdd,       // accelerations, of the needs that are given them
    Lambda,    // multipliers, likewise
    Direction, // w of a tangent: args {row of 2n, column}
    Member,    // of the parameter struct, or a constant of the source
  } kind = Q;
  std::string text;                   // Member: a C expression with a % for each index, "p->length[%]"
  bool integer = false;               // Member: of integer type
  long length = 0;                    // elements in all
  const Variable *variable = nullptr; // Member: a constant of the source
};

// Conditions of the source under which a node is computed in the source, all of them together.
struct Guard {
  const Guard *outer;        // null: none
  Node *holds;               // the conjunction, outer's included
  const Guard *of = nullptr; // the guard that this is one of other values of; null: none
};

struct Node {
  enum Op {
    Number,      // value
    Affine,      // an integer: offset + sum of terms (coefficient times a loop's iteration number)
    Leaf,        // element args (indices) of slot
    Carried,     // carried number which of loop of, as an iteration begins
    Final,       // the same after the last iteration
    Read,        // element args[0] of array
    Add,         // args[0] + args[1]
    Mul,         // args[0] * args[1]; a Number comes first
    Recip,       // 1 / args[0]; text: see recip
    Math,        // text(args), a function of math.h or of taylor/power.h; which: see sign
    Taylor,      // derivative number which, from 0, of the external function text at args
    Convert,     // (text)args[0]: an integer type
    Integer,     // args[0] text args[1]: / and % of integers that are not Affine
    Compare,     // args[0] text args[1]: < or <= or ==
    Not,         // of a truth value
    Conjunction, // of truth values
    Disjunction,
    Select // args[0] ? args[1] : args[2]
  };
  explicit Node(Op kind) : op(kind) {}

  Op op;
  double value = 0;
  long offset = 0;
  std::vector<std::pair<Loop *, long>> terms; // by the loops' numbers
  std::string text;
  std::vector<Node *> args;
  const Slot *slot = nullptr;
  Array *array = nullptr;
  Loop *of = nullptr;
  int which = 0;

  // Not part of what the node is:
  int id = 0;           // in the order of making; arguments come first
  Loop *loop = nullptr; // the innermost loop it varies in, null outside of all
  bool fixed = false;   // arithmetic on parameters alone, the same at all times
  bool judged = false;  // a Recip that has a value only where the test of the results allows it
  const Guard *guard = nullptr;
  Loc loc;          // of the source that first asked for it
  std::string name; // of the variable that first held it; may be empty

  bool isNumber() const { return op == Number; }
  bool is(double v) const { return op == Number && value == v; }
  bool isConstant() const { return op == Affine && terms.empty(); }
};

// What an iteration hands to the next.
struct Carry {
  Node *init; // outside the loop
  Node *in;   // the Carried node
  Node *out;  // its value at the end of the iteration
};

struct Loop {
  int id;
  Loop *outer;
  Node *trips;       // Affine in outer loops, or Convert etc. where only known at run time; null: while condition holds
  Node *condition;   // while loops: a node of this loop, tested as an iteration begins
  bool down = false; // iterations run from the last number to 0
  Node *index;       // the iteration number
  std::vector<Carry> carried;

  bool within(const Loop *other) const { return !other || this == other || (outer && outer->within(other)); }
};

// value becomes element index of the array, or is added to it where the array is summed.
struct Write {
  Loop *loop; // null: once, outside of all loops
  Node *index, *value;
};

// Numbers that iterations leave behind. Written in full (or cleared, where summed) before it is read outside of the writing loops; a
// read inside a writing loop sees the element of another, earlier iteration.
struct Array {
  int id;
  std::string name;
  long length;
  bool summed = false;  // elements start at zero and writes add
  bool tape = false;    // of a loop without outer ones: element i is what Write's value is in iteration i
  Loop *home = nullptr; // the loop in each iteration of which it is filled anew; null: once
  std::vector<Write> writes;
};

// True for values of integer type, truth values included.
bool isInteger(const Node *n);

// The function that the source has in the place of this one: what a Recip or a sign is the derivative of, "div" of a plain Recip.
std::string sourceFunction(const Node *n);

// True for what the generated code computes on reals: sums, products, reciprocals and functions.
bool isOperation(const Node *n);

// In the order of making, of what has an id: addresses are others in every run, and generated code must not be.
struct ById {
  template <class T> bool operator()(const T *a, const T *b) const { return a->id < b->id; }
};

//
// Sums and products, and what is printed, stand in the order of making. C++ leaves open which argument of a call is made first, so that
// no two arguments of one call may make nodes: the output would depend on the compiler of tlgen.
class Graph {
public:
  // Values. Constants are folded, products keep one Number in front, x*1, x*0, x+0 and double negation go away, products of the same
  // factors are the same, and equal terms of sums are taken together or cancel (Sums.cpp).
  Node *number(double value);
  Node *integer(long value) { return affine(value, {}); }
  Node *affine(long offset, std::vector<std::pair<Loop *, long>> terms);
  Node *leaf(const Slot *slot, std::vector<Node *> indices = {});
  Node *add(Node *a, Node *b);
  Node *sub(Node *a, Node *b) { return add(a, neg(b)); }
  Node *neg(Node *a) { return mul(number(-1), a); }
  Node *mul(Node *a, Node *b);
  Node *scale(double k, Node *a) { return mul(number(k), a); }
  // of: the function that has this as its derivative and no value but where a is positive; empty where any a but 0 will do.
  Node *recip(Node *a, const std::string &of = "");
  Node *div(Node *a, Node *b) { return mul(a, recip(b)); }
  Node *math(const std::string &function, std::vector<Node *> args);
  Node *sign(Node *a, const std::string &of);  // copysign(1, a), in a derivative of that function: it has no value at 0
  Node *power(Node *x, Node *exponent, int k); // the k-th derivative of pow in x
  Node *taylor(const std::string &function, int order, std::vector<Node *> args);
  Node *convert(const std::string &type, Node *a);          // "tl_real" makes a number of an integer
  Node *integerOp(const std::string &op, Node *a, Node *b); // + - * stay Affine where they can
  Node *compare(const std::string &op, Node *a, Node *b);   // all six operators
  Node *logicalNot(Node *a);
  Node *logicalAnd(Node *a, Node *b);
  Node *logicalOr(Node *a, Node *b);
  Node *select(Node *condition, Node *a, Node *b);

  // Loops and arrays.
  Loop *loop(Loop *outer, Node *trips, bool down);
  Node *carry(Loop *loop, Node *init); // a new carried value; its out is to be set with setOut
  void setOut(Node *carried, Node *out) { carried->of->carried[size_t(carried->which)].out = out; }
  Node * final(Loop *loop, int which);
  Array *array(const std::string &label, long length);
  void write(Array *array, Loop *loop, Node *index, Node *value) { array->writes.push_back({loop, index, value}); }
  Node *read(Array *array, Node *index);
  // The sums of a value over the iterations so far, for each of a loop's, in an array that equal sums of all such loops share. The loop
  // has a constant number of iterations, and the value does not depend on what these carry.
  Array *runningSums(Node *value, const Loop *loop);

  // The same value with other nodes in the place of some, arguments rebuilt as needed.
  // An index of a loop in by stands for the loop's number wherever it occurs. by remembers what was rebuilt.
  using Replacement = std::unordered_map<Node *, Node *>;
  Node *replace(Node *node, Replacement &by);
  Node *rebuild(Node *node, std::vector<Node *> args); // the same operation on other arguments
  // Sums and products as they stand.
  Node *plainSum(Node *a, Node *b);
  Node *plainProduct(Node *a, Node *b);

  // Off: operations are made anew each time that they are asked for; they are left as they are asked for, but for constants, which are
  // folded.
  bool sharing = true, simplifying = true;

  // What new nodes are made for.
  const Guard *guard = nullptr;
  Loc loc;
  std::string name;
  // Sets guard and place for the time that it lives.
  struct Making {
    Making(Graph &of, const Guard *under, Loc at) : graph_(of), guard_(of.guard), loc_(of.loc) {
      graph_.guard = under;
      graph_.loc = at;
    }
    ~Making() {
      graph_.guard = guard_;
      graph_.loc = loc_;
    }

  private:
    Graph &graph_;
    const Guard *guard_;
    Loc loc_;
  };
  const Guard *under(const Guard *outer, Node *condition, const Guard *of = nullptr); // outer and condition
  // The same conditions of other values: other(node) stands for each node. An operation under both is a node under each.
  const Guard *remade(const Guard *of, const std::function<Node *(Node *)> &other);
  static bool covers(const Guard *outer, const Guard *inner); // whether inner holds only where outer does

  const Slot *slot(Slot s); // the one of that kind and text
  const std::deque<Loop> &loops() const { return loops_; }
  const std::deque<Array> &arrays() const { return arrays_; }
  size_t size() const { return nodes_.size(); }

  // A product as number times the rest; the rest is null for a number itself.
  struct Scaled {
    double factor;
    Node *rest;
  };
  static Scaled scaled(Node *n);
  // The factors of a product, and the terms of a sum (negated sums taken apart); false where there are too many terms to look at.
  static void factorsOf(Node *n, std::vector<Node *> &to);
  static bool terms(Node *n, double factor, std::vector<Scaled> &to);

private:
  Node *make(Node n);
  Node *find(const std::string &key) const;
  static int rank(const Node *n);
  Node *scaledNode(const Scaled &s);
  Node *mergedSum(Node *a, Node *b);
  Node *factoredSum(const Scaled &a, const Scaled &b);
  static std::vector<Node *> movingFactors(Node *product);
  Scaled joined(const Scaled &a, const Scaled &b, const std::vector<Node *> &moving);
  bool takeTogether(std::vector<Scaled> &terms, size_t left, bool fixedApart);
  bool multiplyOut(std::vector<Scaled> &terms);
  bool joinSquares(std::vector<Scaled> &terms);

  std::deque<Node> nodes_;
  std::unordered_multimap<std::string, Node *> known_;
  std::deque<Loop> loops_;
  std::deque<Array> arrays_;
  std::deque<Slot> slots_;
  std::deque<Guard> guards_;
  std::map<std::pair<Node *, bool>, Loop *> adding_; // by trips and direction
  std::map<Node *, Array *> sums_;                   // by the value in that loop
};

// Derivatives of elementary functions.

// d math / d args[argument], built from the node itself and its arguments; null where tlgen has no formula.
Node *derivative(Graph &graph, Node *math, size_t argument);

// The condition under which the function has no value or no derivative at its arguments (sqrt: x <= 0); null where there is none.
Node *outsideDomain(Graph &graph, Node *math);

} // namespace tlgen

#endif
