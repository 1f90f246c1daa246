// The command line of tlgen.
#ifndef TLGEN_OPTIONS_H
#define TLGEN_OPTIONS_H

#include "EmitAdjoint.h"

#include <map>
#include <string>
#include <vector>

namespace tlgen {

struct FunctionOption {
  std::string name;
  std::string rows; // after the colon; empty where not said
};

struct ArgOption {
  std::string role;
  int index; // place in a list of names
};

// One model.
struct Options {
  std::vector<std::string> sources;
  std::string model, dof, output, compileCommands;
  std::string lagrangian, force, dissipation;
  std::vector<FunctionOption> holonomic, nonholonomic;
  std::vector<FunctionOption> recursion; // rows: the depth
  std::vector<FunctionOption> rules;     // rows: the function that fills the Taylor coefficients
  std::map<std::string, ArgOption> args; // by parameter name
  std::vector<std::string> compilerArgs; // after --
  MotionOptions motion;
  std::string exportFolder, exportReal; // of --export
  std::vector<std::string> carried;     // likewise: files of the user's
  bool needsGiven = false, needsAll = false;
  bool depfile = false, selftest = false, report = false;

  // The file beside the output with another ending: header() is FILE.h for FILE.c.
  std::string header() const { return output.substr(0, output.size() - 2) + ".h"; }
  std::string depFile() const { return output + ".d"; }
  // The test program's part for source number k, from 0.
  std::string selftestFile(size_t k) const;
};

// One run of the tool.
struct Run {
  std::vector<Options> models;
  std::string modelsFile; // --models: where the models were read from
  std::string sarif;
  bool werror = false, cmake = false;
};

enum class Command { Generate, Done, Fail };

// Reads the command line, and the file of models that it names. Done: --help, --version or --explain was answered on stdout. Fail: a
// message went to stderr.
Command parseOptions(int argc, const char *const *argv, Run &run);

} // namespace tlgen

#endif
