// Runs Clang over the source files and hands back their trees. One of the files that see Clang.
#ifndef TLGEN_FRONTEND_H
#define TLGEN_FRONTEND_H

#include "Diagnostics.h"
#include "Options.h"

#include "clang/Frontend/ASTUnit.h"

#include <map>
#include <memory>
#include <set>

namespace tlgen {

// The sources of one model.
struct Parsed {
  std::vector<clang::ASTUnit *> units; // in the order of the sources
  std::set<std::string> files;         // every file that was read
};

// Reads each source once for the same compiler arguments, however many models are made of it. The trees live as long as this object.
class Frontend {
public:
  // Without units where a source is not C; diags says why, and which of the rest is known to be wrong.
  Parsed parse(const Options &options, Diagnostics &diags);

private:
  struct Unit {
    std::unique_ptr<clang::ASTUnit> tree; // null where it is not C
    Diagnostics diags;
    std::set<std::string> files;
  };
  Unit &unit(const std::string &source, const Options &options);
  std::map<std::vector<std::string>, Unit> units_; // by source and compiler arguments
};

} // namespace tlgen

#endif
