// A value of straight-line code as a sum of products.
#ifndef TLGEN_MULTIPLYOUT_H
#define TLGEN_MULTIPLYOUT_H

#include "Graph.h"

namespace tlgen {

// The same value, its products of sums multiplied out, down to functions, reciprocals and what is no arithmetic; a square of a sine is
// one less that of the cosine, so that what these add up to goes. Null where the terms would be too many.
Node *multipliedOut(Graph &graph, Node *value);

} // namespace tlgen

#endif
