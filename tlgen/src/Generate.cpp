// One run of the tool, as a ladder: each step that leaves errors behind ends it.
#include "Generate.h"

#include "EmitCalls.h"
#include "Frontend.h"
#include "Lower.h"
#include "Names.h"
#include "Output.h"

#include <csignal>
#include <filesystem>
#include <iostream>

namespace tlgen {
namespace {

std::string depRule(const std::string &target, const std::set<std::string> &files) {
  std::string s = target + ":";
  for (const std::string &file : files) {
    s += " \\\n ";
    for (char ch : file) s += ch == ' ' ? "\\ " : std::string(1, ch);
  }
  return s + "\n";
}

// True, with a message, where an output is one of the files that were read, by whatever path.
bool overwrites(const std::set<std::string> &read, const std::vector<std::string> &outputs) {
  for (const std::string &out : outputs)
    for (const std::string &file : read) {
      std::error_code none;
      if (!std::filesystem::equivalent(file, out, none) || none) continue;
      std::cerr << "tlgen: -o: " << out << " is a source; it would be overwritten\nTry 'tlgen --help'.\n";
      return true;
    }
  return false;
}

int refuse(const Diagnostics &diags) {
  diags.print(std::cerr);
  return 1;
}

} // namespace

int generate(const Options &options) {
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows past the limit is a write error like any other
  Diagnostics diags;
  std::set<std::string> files;
  auto units = parseSources(options, diags, files);
  if (diags.hasErrors()) return refuse(diags);
  std::string header = options.output.substr(0, options.output.size() - 2) + ".h";
  if (overwrites(files, {options.output, header})) return 2;
  Source source(units, diags);
  Match match = matchModel(source, options, diags);
  auto functions = checkSubset(source, match);
  if (diags.hasErrors()) return refuse(diags);

  Program program;
  Model model;
  lower(source, match, functions, options.model, program, model);
  separateNames(program, model.name);
  Activity activity(program, model, diags);
  if (diags.hasErrors()) return refuse(diags);

  EmittedModel text = emitCalls(program, model, activity, diags, header.substr(header.find_last_of('/') + 1));
  if (diags.hasErrors()) return refuse(diags);
  diags.print(std::cerr);
  std::vector<std::pair<std::string, std::string>> out = {{options.output, text.source}, {header, text.header}};
  if (options.depfile) out.push_back({options.output + ".d", depRule(options.output, files)});
  return writeFiles(out) ? 0 : 1;
}

} // namespace tlgen
