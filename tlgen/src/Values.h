// What is known of numbers and pointers at one point of a program: which may have a value, and which values.
//
// Everything errs towards "may": a state describes at least all that a run of the program could meet there.
#ifndef TLGEN_VALUES_H
#define TLGEN_VALUES_H

#include "Program.h"

#include <climits>
#include <memory>

namespace tlgen {

// The integers from lo to hi; all of a type's where nothing is known.
struct Range {
  long lo = LONG_MIN, hi = LONG_MAX;

  static Range of(long n) { return {n, n}; }
  bool exact() const { return lo == hi; }
  bool isWhole() const { return lo == LONG_MIN && hi == LONG_MAX; }
  bool holds(long n) const { return lo <= n && n <= hi; }
  bool operator==(const Range &o) const { return lo == o.lo && hi == o.hi; }
};

// The smallest range around both; with widen the whole one where b is not inside a.
Range hull(const Range &a, const Range &b, bool widen = false);
// a op b for + - * / % << >> & | ^; whole where it could leave the 64-bit integers or is not known.
Range arithmetic(const std::string &op, const Range &a, const Range &b);
// {1, 1}, {0, 0} or {0, 1} for < > <= >= == !=.
Range comparison(const std::string &op, const Range &a, const Range &b);
// The range after a conversion to an integer type.
Range converted(const Range &r, const Type *type);

struct Value {
  bool varied = false;            // depends on coordinates, velocities or time
  Range range;                    // of an integer
  bool anywhere = true;           // a pointer that may point to anything; else
  std::map<int, Range> targets{}; // to what it may point: objects, and how many leaves behind their begin

  static Value number(const Range &r) { return {false, r, true, {}}; }
  static Value pointer(int object, const Range &offset) { return {false, {}, false, {{object, offset}}}; }
  bool operator==(const Value &o) const {
    return varied == o.varied && range == o.range && anywhere == o.anywhere && targets == o.targets;
  }
};

Value joined(const Value &a, const Value &b, bool widen = false);
// The pointer moved by that many leaves.
Value moved(const Value &pointer, const Range &leaves);

// A leaf: one number or pointer of an object, in the order of memory.
struct Cell {
  bool assigned = true; // on some path
  Value value{};
  bool operator==(const Cell &o) const { return assigned == o.assigned && value == o.value; }
};
using Cells = std::vector<Cell>;

Cell joined(const Cell &a, const Cell &b, bool widen = false);

struct Object {
  Cells cells;      // one per leaf, or, repeating, of the first element for them all
  long length = -1; // leaves; -1 where it is not known

  bool isSummary() const { return length != static_cast<long>(cells.size()); }
};

// Of length leaves (-1: not known) that begin with these cells and repeat them.
Object repeated(const Cells &cells, long length);
// Of count elements (-1: not known), all like this one.
Object arrayOf(const Cells &element, long count);
// With these leaves, as a summary of period leaves where they are many.
Object whole(Cells cells, long period);

// How sure it is that the program gets to a point once its model function is called.
enum class Reached { Perhaps, ByInputs, Surely }; // ByInputs: only comparisons of varied numbers stand before it

struct State {
  bool live = false;
  Reached reached = Reached::Surely;
  std::map<int, std::shared_ptr<const Object>> objects{};

  // Takes in what another state allows too; true where that is more than before.
  bool include(const State &other, bool widen = false);
  // After an unknown effect: anything may be assigned, with any value.
  void forget();
};

} // namespace tlgen

#endif
