// Runs Clang over the source files and hands back their trees. One of the files that see Clang.
#ifndef TLGEN_FRONTEND_H
#define TLGEN_FRONTEND_H

#include "Diagnostics.h"
#include "Options.h"

#include "clang/Frontend/ASTUnit.h"

#include <memory>
#include <set>

namespace tlgen {

// The trees of all sources, in their order; empty on any error (then diags says why). files receives every file that was read.
std::vector<std::unique_ptr<clang::ASTUnit>> parseSources(const Options &options, Diagnostics &diags, std::set<std::string> &files);

} // namespace tlgen

#endif
