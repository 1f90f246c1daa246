// A model function as a graph of values: its C is run once on symbols, with the sizes that are known when code is generated.
//
// Control flow that depends on constants is run as it stands; where it depends on values of run time both ways are run and merged with
// Select. Loops are unrolled, or kept where keepLoops asks for it and the loop is regular: see TraceLoop.cpp.
#ifndef TLGEN_TRACE_H
#define TLGEN_TRACE_H

#include "Graph.h"

namespace tlgen {

struct TraceOptions {
  std::map<std::string, long> sizes; // integer members of the parameter struct with known values
  bool keepLoops = false;
  long minTrips = 4;       // shorter loops are unrolled
  size_t maxNodes = 60000; // of one function
  size_t maxChoices = 500; // of run time in it
};

// What no graph can be made of: the reason as a sentence for the user, and the place. Thrown by trace().
struct Unsuitable {
  std::string why;
  Loc loc;
  bool large = false;                    // it is only too large
  const char *id = "adjoint-unsuitable"; // of the message where no form can be printed
};

struct Traced {
  Node *value = nullptr;            // of a Lagrangian or dissipation function
  Array *rows = nullptr;            // of the others: element i is row i; rows of a force that are never written are 0
  std::vector<Node *> assigned;     // numbers that the source gives to variables, in all iterations of loops
  std::vector<Unsuitable> unrolled; // with keepLoops: which loops were not kept, and why
};

// What the parameter struct is called in the texts of slots.
extern const char *const TRACE_PARAMS;

Traced trace(Graph &graph, const Program &program, const Model &model, const ModelFunction &function, const TraceOptions &options);

} // namespace tlgen

#endif
