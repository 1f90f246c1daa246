// One run of the tool, as a ladder: each step that leaves errors behind ends it.
#include "Generate.h"

#include "Export.h"
#include "Frontend.h"
#include "Lower.h"
#include "MemoryCheck.h"
#include "Names.h"
#include "Output.h"
#include "Paths.h"
#include "Sarif.h"
#include "Selftest.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>

namespace tlgen {
namespace {

std::string depRule(const std::string &target, const std::set<std::string> &files) {
  std::string s = makePath(target) + ":";
  for (const std::string &file : files) s += " \\\n " + makePath(file);
  return s + "\n";
}

using OutFiles = std::vector<std::pair<std::string, std::string>>; // path and text

int wrongOutput(const std::string &what) {
  std::cerr << "tlgen: " << what << "\nTry 'tlgen --help'.\n";
  return 2;
}

// True, with a message, where an output is one of the files that were read, by whatever path, or two outputs are one file.
bool overwrites(const Run &run, std::set<std::string> read) {
  read.insert(run.modelsFile);
  std::set<std::filesystem::path> written;
  auto taken = [&](const std::string &option, const std::string &out) {
    std::error_code none;
    for (const std::string &file : read)
      if (std::filesystem::equivalent(file, out, none) && !none)
        return wrongOutput(option + ": " + out + " is a source; it would be overwritten");
    if (!written.insert(std::filesystem::weakly_canonical(out, none)).second)
      return wrongOutput(option + ": " + out + " would be written twice");
    return 0;
  };
  for (const Options &o : run.models) {
    if (taken("-o", o.output) || taken("-o", o.header()) || (o.depfile && taken("-MD", o.depFile()))) return true;
    for (size_t k = 0; o.selftest && k < o.sources.size(); ++k)
      if (taken("--selftest", o.selftestFile(k))) return true;
  }
  return !run.sarif.empty() && taken("--sarif", run.sarif);
}

// What --export does to the disk besides writing files.
struct Folders {
  std::vector<std::string> stale, made;
  bool refused = false;

  // Takes back what was made.
  void unmake() const {
    std::error_code none;
    for (auto folder = made.rbegin(); folder != made.rend(); ++folder) std::filesystem::remove(*folder, none);
  }
  void removeStale() const {
    std::error_code none;
    for (const std::string &file : stale) std::filesystem::remove(file, none);
  }
};

// The files of an export, their folders made; none where it is refused.
OutFiles makeExport(const Options &options, const ExportFiles &files, std::string why, Folders &folders) {
  std::vector<std::string> stale;
  if (why.empty() && !canExport(options.exportFolder, files, stale, why)) folders.refused = true;
  if (why.empty() && !makeFolders(options.exportFolder, files, folders.made)) why = options.exportFolder + ": " + std::strerror(errno);
  folders.refused = !why.empty();
  if (folders.refused) return std::cerr << "tlgen: --export: " << why << '\n', OutFiles{};
  OutFiles out;
  for (const auto &file : files) out.push_back({options.exportFolder + "/" + file.first, file.second});
  for (const std::string &file : stale) folders.stale.push_back(options.exportFolder + "/" + file);
  return out;
}

// The files of one model; none on an error.
OutFiles makeModel(const Options &options, const Parsed &parsed, const std::string &modelsFile, Diagnostics &diags, std::string &report,
                   Folders &folders) {
  Source source(parsed.units, diags);
  Match match = matchModel(source, options, diags);
  auto functions = checkSubset(source, match);
  if (diags.hasErrors()) return {};

  Program program;
  Model model;
  lower(source, match, functions, options.model, program, model);
  MemoryCheck(program, model, diags).run();
  separateNames(program, model.name);
  Activity activity(program, model, diags);
  if (diags.hasErrors()) return {};

  std::string header = options.header();
  Diagnostics motionDiags;
  MotionText motion = emitAdjoint(program, model, options.motion, motionDiags);
  const bool exports = !options.exportFolder.empty();
  const Content content = exports ? exportContent(model, motion, options.motion.needs) : Content::Whole;
  EmittedModel text = emitCalls(program, model, activity, motion, diags, header.substr(header.find_last_of('/') + 1), content);
  if (options.report) report += motion.report;
  if (exports) {
    diags.add(motionDiags);
    if (diags.hasErrors()) return {};
    std::string why;
    const ExportFiles carried = readCarried(options.carried, why);
    const ExportFiles files =
        why.empty() ? exportFiles(program, model, motion, text, content, options.exportReal, carried, why) : ExportFiles{};
    return makeExport(options, files, why, folders);
  }
  OutFiles out = {{options.output, text.source}, {header, text.header}};
  std::set<std::string> files = parsed.files;
  if (!modelsFile.empty()) files.insert(modelsFile);
  if (options.depfile) out.push_back({options.depFile(), depRule(options.output, files)});
  bool single = text.source.find("tl_float(") != std::string::npos;
  if (options.selftest)
    for (auto &file : selftestFiles(source, match, options, program, model, single, diags)) out.push_back(std::move(file));
  if (!diags.hasErrors() || motionDiags.hasErrors()) diags.add(motionDiags); // no notes on what is not written
  return out;
}

} // namespace

int generate(const Run &run) {
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows past the limit is a write error like any other
  Frontend frontend;
  Diagnostics all;
  OutFiles out;
  std::set<std::string> read;
  std::string report;
  Folders folders;
  for (const Options &options : run.models) {
    Diagnostics diags;
    Parsed parsed = frontend.parse(options, diags);
    read.insert(parsed.files.begin(), parsed.files.end());
    if (!parsed.units.empty())
      for (auto &file : makeModel(options, parsed, run.modelsFile, diags, report, folders)) out.push_back(std::move(file));
    all.add(diags);
  }
  if (overwrites(run, read)) return 2;
  if (run.werror) all.promoteWarnings();
  if (run.cmake) all.speakCmake();
  all.print(std::cerr);
  if (all.hasErrors()) out.clear();
  const bool csv = std::any_of(run.models.begin(), run.models.end(), [](const Options &o) { return o.motion.reportAsCsv; });
  if (!all.hasErrors() && !report.empty()) std::cout << (csv ? reportHeader() : "") << report;
  if (!run.sarif.empty()) out.push_back({run.sarif, sarifText(all)});
  if (folders.refused) out.clear();
  const bool written = writeFiles(out) && !all.hasErrors() && !folders.refused;
  written ? folders.removeStale() : folders.unmake();
  return written ? 0 : 1;
}

} // namespace tlgen
