// Which form of a motion function is faster: an estimate from what it does.
//
// Registers pay for every number by itself; rows pay for eight columns at once, and for loops around them. What both share, the
// solution of M qdd = Q and the copying of results, is left out: it does not decide.
#ifndef TLGEN_FORMCOST_H
#define TLGEN_FORMCOST_H

#include "Operations.h"

#include <vector>

namespace tlgen {

// Nanoseconds; bench/cost measures them. Machines differ in all of them by about the same factor, which does not decide either.
struct FormCost {
  double operation = 0.15; // a sum or product of two numbers in straight-line code
  double repeated = 0.1;   // the same in a loop's body, which has few numbers at a time
  double reciprocal = 1.5; // a division
  double function = 13;    // of math.h, or sine and cosine together
  double vector = 0.69;    // a term of a sum of rows, eight columns
  double iteration = 0.5;  // of a loop, with what it carries
  double form = 2;         // of a function in rows: what loops cost before they begin, and after

  double estimate(const Operations &operations, bool rows) const;
};

struct FormCostConstant {
  const char *name; // of --cost
  double FormCost::*value;
};

const std::vector<FormCostConstant> &formCostConstants();

// Coordinates up to which registers can be faster at all; above, they are not even made in order to be counted.
const long MOST_IN_REGISTERS = 8;

// Coordinates up to which there are functions for many states at once, which are straight-line code.
const long MOST_IN_LANES = 16;

} // namespace tlgen

#endif
