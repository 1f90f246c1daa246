// Finds the functions of the model and what each of their parameters is. One of the files that see Clang.
#ifndef TLGEN_MATCH_H
#define TLGEN_MATCH_H

#include "Options.h"
#include "Source.h"

namespace tlgen {

struct Matched {
  Role role;
  const clang::FunctionDecl *function;
  std::vector<Arg> args; // one per parameter
  Count rows;            // forces: left to the number of coordinates
};

struct Match {
  Count dof;
  std::vector<Matched> functions; // Lagrangian first, then force, dissipation, holonomic and nonholonomic in the order given
  const clang::RecordDecl *params = nullptr;
  std::map<const clang::FunctionDecl *, Count> recursion; // how deep helpers that call themselves may go
  std::map<std::string, std::string> rules; // functions that fill Taylor coefficients, by what they are the derivatives of
};

// The function that fills the Taylor coefficients of an external one, by option or mark; empty where there is none.
std::string ruleOf(const clang::FunctionDecl *external, const Match &match);

// Reports what is missing or contradictory; the result is whole only where diags has no error afterwards.
Match matchModel(const Source &source, const Options &options, Diagnostics &diags);

} // namespace tlgen

#endif
