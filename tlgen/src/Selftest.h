// Prints a program that checks every derivative of a generated model against differences, in quad precision, of the user's own source.
#ifndef TLGEN_SELFTEST_H
#define TLGEN_SELFTEST_H

#include "Match.h"

#include <utility>

namespace tlgen {

// Path and text of each file: options.selftestFile(k) includes the k-th source as it stands and adapts the functions of the model that
// were found there; the first holds main. Reports members of the parameter struct that such a program could not be told.
std::vector<std::pair<std::string, std::string>> selftestFiles(const Source &source, const Match &match, const Options &options,
                                                               const Program &program, const Model &model, bool single,
                                                               Diagnostics &diags);

} // namespace tlgen

#endif
