// How much a function does.
#ifndef TLGEN_OPERATIONS_H
#define TLGEN_OPERATIONS_H

namespace tlgen {

// How much is to be done, all iterations counted where their number is known.
struct Operations {
  long values = 0; // different ones, each counted once
  long adds = 0, products = 0, reciprocals = 0;
  long repeated = 0;   // of the adds and products, those in loops
  long functions = 0;  // of math.h or of the user, at so many arguments; the sine and cosine of one are one
  long vectors = 0;    // on rows: sums of a term each, eight columns at a time
  long iterations = 0; // of loops
};

} // namespace tlgen

#endif
