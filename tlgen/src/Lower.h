// Turns Clang's tree of accepted functions into the intermediate program. The last of the files that see Clang.
#ifndef TLGEN_LOWER_H
#define TLGEN_LOWER_H

#include "Subset.h"

namespace tlgen {

// functions: as checkSubset ordered them, and without a fault. Fills program and model.
void lower(const Source &source, const Match &match, const std::vector<Instance> &functions, const std::string &modelName,
           Program &program, Model &model);

} // namespace tlgen

#endif
