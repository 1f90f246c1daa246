// Collected messages about the user's source, each with a place and a stable id. Nothing is printed before the run ends.
#ifndef TLGEN_DIAGNOSTICS_H
#define TLGEN_DIAGNOSTICS_H

#include "Program.h"

#include <iosfwd>
#include <set>
#include <string>
#include <vector>

namespace tlgen {

enum class Severity { Note, Warning, Error };

struct DiagnosticKind {
  const char *id;
  Severity severity;
  const char *why;
  const char *instead;
};

// The kind with that id, or null.
const DiagnosticKind *findDiagnostic(const std::string &id);
const std::vector<DiagnosticKind> &allDiagnostics();

struct Message {
  std::string file; // relative to the working directory where it is inside of that; empty for a fault of the command line
  unsigned line, column;
  const DiagnosticKind *kind;
  std::string what;
  // The order of printing: by place, then by text.
  bool operator<(const Message &other) const;
};

// "error", "warning" or "note".
const char *nameOf(Severity severity);

class Diagnostics {
public:
  // Adds a message. what names the thing at fault; file is a path, empty for a fault of the command line.
  void add(const char *id, const std::string &file, unsigned line, unsigned column, const std::string &what);
  // The same at a place of the program.
  void add(const char *id, const Program &program, const Loc &loc, const std::string &what);
  // Adds the messages of another run over the same sources; what both found is found once.
  void add(const Diagnostics &other) { messages_.insert(other.messages_.begin(), other.messages_.end()); }
  // From now on messages call options by the keywords of taylor_add_model().
  void speakCmake() { cmake_ = true; }
  // From now on a warning counts as an error.
  void promoteWarnings() { promote_ = true; }

  Severity severity(const Message &m) const {
    return promote_ && m.kind->severity == Severity::Warning ? Severity::Error : m.kind->severity;
  }
  bool isError(const Message &m) const { return severity(m) == Severity::Error; }
  bool has(const char *id) const;
  bool hasErrors() const;
  std::string text(const Message &m) const { return words(m.what + ": " + m.kind->why); }
  // The text with its options as the caller of tlgen names them.
  std::string words(const std::string &text) const;
  const std::set<Message> &messages() const { return messages_; }
  // Prints all messages by file, line and column, each once:  file:line:col: error: what: why [id] and a line with the way out.
  void print(std::ostream &out) const;

private:
  std::set<Message> messages_;
  bool promote_ = false, cmake_ = false;
};

} // namespace tlgen

#endif
