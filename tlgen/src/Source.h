// The parsed sources as one body of code: functions by name across translation units, and places. One of the files that see Clang.
#ifndef TLGEN_SOURCE_H
#define TLGEN_SOURCE_H

#include "Diagnostics.h"

#include "clang/AST/Decl.h"
#include "clang/Frontend/ASTUnit.h"

#include <map>
#include <string>
#include <vector>

namespace tlgen {

// The file of a place, as messages name it: one that a #line names stays as it is.
std::string pathOf(const clang::SourceManager &sm, const clang::PresumedLoc &loc);

class Source {
public:
  Source(const std::vector<clang::ASTUnit *> &units, Diagnostics &diags);

  // All functions with a body, in the order of the files.
  const std::vector<const clang::FunctionDecl *> &definitions() const { return definitions_; }
  // The definition with that name, or null.
  const clang::FunctionDecl *find(const std::string &name) const;
  // The definition of a declared function, here or in another translation unit; null where there is none.
  const clang::FunctionDecl *definition(const clang::FunctionDecl *declared) const;
  // The declaration of a variable that gives it its value, here or in another translation unit; null where there is none.
  const clang::VarDecl *definition(const clang::VarDecl *declared) const;

  // The number of the source, from 0, whose reading found the declaration.
  size_t unitOf(const clang::Decl *decl) const;
  // The system headers that a source and its own headers include, as written between < and >, each once.
  std::vector<std::string> systemHeaders(size_t unit) const;

  // Reports a fault at a place of the source.
  void report(const char *id, const clang::ASTContext &context, clang::SourceLocation at, const std::string &what) const;

private:
  std::vector<clang::ASTUnit *> units_;
  static std::string place(const clang::FunctionDecl *function);

  std::vector<const clang::FunctionDecl *> definitions_;
  std::map<std::string, const clang::FunctionDecl *> byName_;
  std::map<std::string, const clang::VarDecl *> constants_; // with external linkage
  Diagnostics &diags_;
};

} // namespace tlgen

#endif
