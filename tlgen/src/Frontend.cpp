// Runs Clang over the source files.
#include "Frontend.h"
#include "Paths.h"
#include "Source.h"

#include "clang/Basic/Diagnostic.h"
#include "clang/Basic/SourceManager.h"
#include "clang/Tooling/CompilationDatabase.h"
#include "clang/Tooling/JSONCompilationDatabase.h"
#include "clang/Tooling/Tooling.h"
#include "llvm/Support/FileSystem.h"

namespace tlgen {
namespace {

namespace tooling = clang::tooling;

// Clang's own errors become located messages; most warnings are the business of the user's compiler.
class Collector : public clang::DiagnosticConsumer {
public:
  explicit Collector(Diagnostics &diags) : diags_(diags) {}
  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic &info) override {
    clang::DiagnosticConsumer::HandleDiagnostic(level, info);
    if (level < clang::DiagnosticsEngine::Error) return;
    llvm::SmallString<128> text;
    info.FormatDiagnostic(text);
    std::string file;
    unsigned line = 0, column = 0;
    if (info.hasSourceManager() && info.getLocation().isValid()) {
      clang::PresumedLoc loc = info.getSourceManager().getPresumedLoc(info.getLocation());
      if (loc.isValid()) file = pathOf(info.getSourceManager(), loc), line = loc.getLine(), column = loc.getColumn();
    }
    diags_.add(idOf(info.getID()), file, line, column, text.str().str());
  }

private:
  static const char *idOf(unsigned clangId) {
    std::string option = clang::DiagnosticIDs::getWarningOptionForDiag(clangId).str();
    if (option == "uninitialized" || option == "sometimes-uninitialized") return "uninitialized";
    return option == "array-bounds" ? "index-range" : option == "unsequenced" ? "unsequenced" : "syntax";
  }

  Diagnostics &diags_;
};

std::unique_ptr<tooling::CompilationDatabase> makeDatabase(const Options &o, Diagnostics &diags) {
  if (o.compileCommands.empty()) return std::make_unique<tooling::FixedCompilationDatabase>(".", o.compilerArgs);
  std::string error;
  auto database = tooling::CompilationDatabase::loadFromDirectory(o.compileCommands, error);
  if (!database) diags.add("no-file", o.compileCommands + "/compile_commands.json", 0, 0, "compilation database");
  return database;
}

// An assert.h whose assert computes nothing, as with NDEBUG, but leaves its condition to be looked at.
const char *const ownHeaders = "/tlgen-headers", *const ownAssertName = "/tlgen-headers/assert.h";
const char *const ownAssert = R"(#undef assert
#define assert(condition) ((void)sizeof((condition) ? 1 : 0))
#ifndef static_assert
#define static_assert _Static_assert
#endif
)";

// The name of the source as Clang shall print it, from whatever folder it is compiled.
tooling::ArgumentsAdjuster absoluteSource(const std::string &source) {
  return [path = tooling::getAbsolutePath(source)](const tooling::CommandLineArguments &args, llvm::StringRef file) {
    tooling::CommandLineArguments changed;
    for (const std::string &arg : args) changed.push_back(arg == file ? path : arg);
    return changed;
  };
}

tooling::ArgumentsAdjuster ownArguments(const Options &o) {
  std::vector<std::string> before = {"-xc", "-D__TLGEN__=1", "-DNDEBUG", "-ferror-limit=0", "-Wno-everything"};
  // Of Clang's warnings those that mean a wrong number.
  for (const char *fault : {"uninitialized", "array-bounds", "unsequenced", "return-type", "implicit-function-declaration"})
    before.push_back(std::string("-Werror=") + fault);
  before.insert(before.end(), {"-isystem", ownHeaders});
  if (llvm::sys::fs::is_directory(TLGEN_RESOURCE_DIR)) before.push_back("-resource-dir=" TLGEN_RESOURCE_DIR);
  auto adjuster = tooling::combineAdjusters(tooling::getClangStripOutputAdjuster(), tooling::getClangStripDependencyFileAdjuster());
  adjuster = tooling::combineAdjusters(adjuster, tooling::getInsertArgumentAdjuster(before, tooling::ArgumentInsertPosition::BEGIN));
  if (!o.compileCommands.empty() && !o.compilerArgs.empty())
    adjuster =
        tooling::combineAdjusters(adjuster, tooling::getInsertArgumentAdjuster(o.compilerArgs, tooling::ArgumentInsertPosition::END));
  return adjuster;
}

// The key of the source manager's table is a pointer up to LLVM 17.
template <class Entry> std::string fileName(const Entry &entry) {
  if constexpr (std::is_pointer_v<Entry>)
    return fromHere(entry->getName().str(), entry->tryGetRealPathName().str());
  else
    return fromHere(entry.getName().str(), entry.getFileEntry().tryGetRealPathName().str());
}

void collectFiles(const clang::SourceManager &sm, std::set<std::string> &files) {
  for (auto it = sm.fileinfo_begin(); it != sm.fileinfo_end(); ++it) {
    std::string name = fileName(it->first);
    if (name.find(ownHeaders) == std::string::npos) files.insert(name);
  }
}

} // namespace

Frontend::Unit &Frontend::unit(const std::string &source, const Options &o) {
  std::vector<std::string> key = {source, o.compileCommands};
  key.insert(key.end(), o.compilerArgs.begin(), o.compilerArgs.end());
  auto [place, isNew] = units_.try_emplace(key);
  Unit &u = place->second;
  if (!isNew) return u;
  auto database = makeDatabase(o, u.diags);
  if (!llvm::sys::fs::is_regular_file(source)) u.diags.add("no-file", source, 0, 0, "source file");
  if (u.diags.hasErrors()) return u;
  tooling::ClangTool tool(*database, {source});
  Collector collector(u.diags);
  tool.setDiagnosticConsumer(&collector);
  tool.setPrintErrorMessage(false);
  tool.mapVirtualFile(ownAssertName, ownAssert);
  tool.clearArgumentsAdjusters();
  tool.appendArgumentsAdjuster(tooling::getClangSyntaxOnlyAdjuster());
  tool.appendArgumentsAdjuster(absoluteSource(source));
  tool.appendArgumentsAdjuster(ownArguments(o));
  std::vector<std::unique_ptr<clang::ASTUnit>> trees;
  bool failed = tool.buildASTs(trees) != 0 || trees.empty();
  if (failed && !u.diags.hasErrors()) u.diags.add("syntax", source, 0, 0, "Clang could not read the file");
  if (trees.empty() || u.diags.has("syntax")) return u; // what Clang only promoted from a warning leaves a tree to look at
  collectFiles(trees[0]->getSourceManager(), u.files);
  u.tree = std::move(trees[0]);
  return u;
}

Parsed Frontend::parse(const Options &o, Diagnostics &diags) {
  Parsed parsed;
  for (const std::string &source : o.sources) {
    Unit &u = unit(source, o);
    diags.add(u.diags);
    parsed.files.insert(u.files.begin(), u.files.end());
    if (u.tree) parsed.units.push_back(u.tree.get());
  }
  if (parsed.units.size() < o.sources.size()) parsed.units.clear();
  return parsed;
}

} // namespace tlgen
