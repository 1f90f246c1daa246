// What the adjoint emitter finds out in order to leave work out. Each analysis can be switched off: then the general thing is done,
// which costs more and gives the same numbers.
#ifndef TLGEN_ANALYSES_H
#define TLGEN_ANALYSES_H

#include <string>
#include <vector>

namespace tlgen {

struct Analyses {
  bool activity = true;     // Varied, Jets: which values depend on what is differentiated by, and on which columns of it
  bool demand = true;       // Jets: which coefficients of which values results are made of
  bool deadCode = true;     // Needed: which values of the source results are made of
  bool recompute = true;    // Tapes: what another loop can make again of what a loop computed
  bool views = true;        // Jets: which rows of a tape are the first columns of a row that a loop carries
  bool common = true;       // Graph: which values are the same computation
  bool algebra = true;      // Graph, Regrouping: which terms of sums are equal or cancel, which factors products share
  bool constantMass = true; // Structure: whether the mass matrix is the same at all states
  bool time = true;         // Structure: whether t occurs in the equations of motion
};

struct Analysis {
  const char *name; // of --without
  bool Analyses::*on;
  const char *off; // what is done without it
};

const std::vector<Analysis> &allAnalyses();

} // namespace tlgen

#endif
