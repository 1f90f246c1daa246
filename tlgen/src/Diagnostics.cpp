// Collected messages about the user's source.
#include "Diagnostics.h"

#include <algorithm>
#include <cassert>
#include <ostream>
#include <tuple>

namespace tlgen {

const std::vector<DiagnosticKind> &allDiagnostics() {
  static const std::vector<DiagnosticKind> kinds = {
#define X(id, severity, why, instead) {#id, Severity::severity, why, instead},
#include "Diagnostics.def"
#undef X
  };
  return kinds;
}

const DiagnosticKind *findDiagnostic(const std::string &id) {
  for (const DiagnosticKind &k : allDiagnostics())
    if (id == k.id) return &k;
  return nullptr;
}

void Diagnostics::add(const char *id, const std::string &file, unsigned line, unsigned column, const std::string &what) {
  const DiagnosticKind *kind = findDiagnostic(id);
  assert(kind && "an id outside Diagnostics.def");
  for (const Message &m : messages_)
    if (m.kind == kind && m.file == file && m.line == line && m.column == column && m.what == what) return;
  if (kind->severity == Severity::Error) ++errors_;
  messages_.push_back({file, line, column, kind, what});
}

void Diagnostics::add(const char *id, const Program &program, const Loc &loc, const std::string &what) {
  add(id, loc.file >= 0 ? program.paths[static_cast<size_t>(loc.file)] : "", loc.line, loc.column, what);
}

void Diagnostics::print(std::ostream &out) const {
  std::vector<Message> sorted = messages_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Message &a, const Message &b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  });
  for (const Message &m : sorted) {
    if (m.file.empty())
      out << "tlgen: ";
    else
      out << m.file << ':';
    if (m.line) out << m.line << ':' << m.column << ':';
    if (!m.file.empty()) out << ' ';
    out << (m.kind->severity == Severity::Error ? "error: " : "warning: ") << m.what << ": " << m.kind->why << " [" << m.kind->id
        << "]\n"
        << "  instead: " << m.kind->instead << '\n';
  }
}

} // namespace tlgen
