// The names of the analyses.
#include "Analyses.h"

namespace tlgen {

const std::vector<Analysis> &allAnalyses() {
  static const std::vector<Analysis> all = {
      {"activity", &Analyses::activity, "every value depends on every column of what is differentiated by"},
      {"demand", &Analyses::demand, "all coefficients of all values are computed, and the whole of M"},
      {"dead-code", &Analyses::deadCode, "what the source assigns is computed, whether a result needs it or not"},
      {"recompute", &Analyses::recompute, "the reverse sweep reads all that it needs of a loop from tapes, derivatives too"},
      {"views", &Analyses::views, "rows that a loop accumulates are stored in every iteration"},
      {"common", &Analyses::common, "equal computations are done each for itself"},
      {"algebra", &Analyses::algebra, "sums and products stay as they are written"},
      {"constant-mass", &Analyses::constantMass, "the mass matrix counts as one that depends on the state"},
      {"time", &Analyses::time, "the equations of motion count as ones that depend on t"}};
  return all;
}

} // namespace tlgen
