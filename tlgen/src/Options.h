// The command line of tlgen.
#ifndef TLGEN_OPTIONS_H
#define TLGEN_OPTIONS_H

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

struct Options {
  std::vector<std::string> sources;
  std::string model, dof, output, compileCommands;
  std::string lagrangian, force;
  std::vector<FunctionOption> holonomic, nonholonomic;
  std::vector<FunctionOption> recursion; // rows: the depth
  std::map<std::string, ArgOption> args; // by parameter name
  std::vector<std::string> compilerArgs; // after --
  bool depfile = false;
};

enum class Command { Generate, Done, Fail };

// Reads the command line. Done: --help, --version or --explain was answered on stdout. Fail: a message went to stderr.
Command parseOptions(int argc, const char *const *argv, Options &options);

} // namespace tlgen

#endif
