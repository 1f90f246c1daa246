// The parsed sources as one body of code.
#include "Source.h"
#include "Paths.h"

#include "clang/AST/ASTContext.h"
#include "clang/Basic/SourceManager.h"

#include <algorithm>

namespace tlgen {

std::string pathOf(const clang::SourceManager &sm, const clang::PresumedLoc &loc) {
  const clang::FileEntry *entry = loc.getFileID().isValid() ? sm.getFileEntryForID(loc.getFileID()) : nullptr;
  return fromHere(loc.getFilename(), entry ? entry->tryGetRealPathName().str() : "");
}

Source::Source(const std::vector<clang::ASTUnit *> &units, Diagnostics &diags) : units_(units), diags_(diags) {
  for (const clang::ASTUnit *unit : units)
    for (const clang::Decl *decl : unit->getASTContext().getTranslationUnitDecl()->decls()) {
      const auto *variable = llvm::dyn_cast<clang::VarDecl>(decl);
      if (variable && variable->hasInit() && variable->isExternallyVisible()) constants_.emplace(variable->getNameAsString(), variable);
      const auto *function = llvm::dyn_cast<clang::FunctionDecl>(decl);
      if (!function || !function->doesThisDeclarationHaveABody()) continue;
      definitions_.push_back(function);
      auto known = byName_.emplace(function->getNameAsString(), function);
      const clang::FunctionDecl *first = known.first->second;
      if (known.second || !function->isExternallyVisible()) continue;
      if (first->isExternallyVisible() && place(first) != place(function)) // not one from a common header
        report("defined-twice", function->getASTContext(), function->getLocation(), "'" + function->getNameAsString() + "'");
      known.first->second = function;
    }
}

const clang::FunctionDecl *Source::find(const std::string &name) const {
  auto it = byName_.find(name);
  return it == byName_.end() ? nullptr : it->second;
}

const clang::FunctionDecl *Source::definition(const clang::FunctionDecl *declared) const {
  const clang::FunctionDecl *here = nullptr;
  if (declared->hasBody(here)) return here;
  const clang::FunctionDecl *elsewhere = find(declared->getNameAsString());
  return elsewhere && elsewhere->isExternallyVisible() ? elsewhere : nullptr;
}

size_t Source::unitOf(const clang::Decl *decl) const {
  size_t i = 0;
  while (&units_[i]->getASTContext() != &decl->getASTContext()) ++i;
  return i;
}

std::vector<std::string> Source::systemHeaders(size_t unit) const {
  const clang::SourceManager &sm = units_[unit]->getSourceManager();
  std::vector<std::string> names;
  for (unsigned i = 0; i < sm.local_sloc_entry_size(); ++i) {
    const clang::SrcMgr::SLocEntry &entry = sm.getLocalSLocEntry(i);
    if (!entry.isFile() || entry.getFile().getIncludeLoc().isInvalid()) continue;
    clang::SourceLocation from = entry.getFile().getIncludeLoc();
    if (entry.getFile().getFileCharacteristic() == clang::SrcMgr::C_User || sm.isInSystemHeader(from)) continue;
    llvm::StringRef text =
        sm.getBufferData(sm.getFileID(from)).substr(sm.getFileOffset(from)).take_until([](char ch) { return ch == '>'; });
    std::string name = text.take_front() == "<" ? text.drop_front().str() : "";
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

const clang::VarDecl *Source::definition(const clang::VarDecl *declared) const {
  if (const clang::VarDecl *here = declared->getInitializingDeclaration()) return here;
  auto found = constants_.find(declared->getNameAsString());
  bool same = found != constants_.end() && declared->isExternallyVisible() &&
              found->second->getType().getCanonicalType().getAsString() == declared->getType().getCanonicalType().getAsString();
  return same ? found->second : nullptr;
}

std::string Source::place(const clang::FunctionDecl *function) {
  return function->getLocation().printToString(function->getASTContext().getSourceManager());
}

void Source::report(const char *id, const clang::ASTContext &context, clang::SourceLocation at, const std::string &what) const {
  const clang::SourceManager &sm = context.getSourceManager();
  clang::PresumedLoc loc = sm.getPresumedLoc(sm.getExpansionLoc(at));
  if (loc.isValid())
    diags_.add(id, pathOf(sm, loc), loc.getLine(), loc.getColumn(), what);
  else
    diags_.add(id, "", 0, 0, what);
}

} // namespace tlgen
