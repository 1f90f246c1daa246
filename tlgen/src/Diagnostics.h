// Collected messages about the user's source, each with a place and a stable id. Nothing is printed before the run ends.
#ifndef TLGEN_DIAGNOSTICS_H
#define TLGEN_DIAGNOSTICS_H

#include "Program.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace tlgen {

enum class Severity { Warning, Error };

struct DiagnosticKind {
  const char *id;
  Severity severity;
  const char *why;
  const char *instead;
};

// The kind with that id, or null.
const DiagnosticKind *findDiagnostic(const std::string &id);
const std::vector<DiagnosticKind> &allDiagnostics();

class Diagnostics {
public:
  // Adds a message. what names the thing at fault; file is the path as the user gave it, empty for a fault of the command line.
  void add(const char *id, const std::string &file, unsigned line, unsigned column, const std::string &what);
  // The same at a place of the program.
  void add(const char *id, const Program &program, const Loc &loc, const std::string &what);
  bool hasErrors() const { return errors_ > 0; }
  // Prints all messages by file, line and column, each once:  file:line:col: error: what: why [id] and a line with the way out.
  void print(std::ostream &out) const;

private:
  struct Message {
    std::string file;
    unsigned line, column;
    const DiagnosticKind *kind;
    std::string what;
  };
  std::vector<Message> messages_;
  int errors_ = 0;
};

} // namespace tlgen

#endif
