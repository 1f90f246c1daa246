// Collected messages about the user's source.
#include "Diagnostics.h"
#include "Paths.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <functional>
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

const char *nameOf(Severity severity) {
  static const char *const names[] = {"note", "warning", "error"};
  return names[static_cast<int>(severity)];
}

const DiagnosticKind *findDiagnostic(const std::string &id) {
  for (const DiagnosticKind &k : allDiagnostics())
    if (id == k.id) return &k;
  return nullptr;
}

bool Message::operator<(const Message &other) const {
  auto key = [](const Message &m) { return std::make_tuple(std::cref(m.file), m.line, m.column, m.kind, std::cref(m.what)); };
  return key(*this) < key(other);
}

void Diagnostics::add(const char *id, const std::string &file, unsigned line, unsigned column, const std::string &what) {
  const DiagnosticKind *kind = findDiagnostic(id);
  assert(kind && "an id outside Diagnostics.def");
  messages_.insert({fromHere(file), line, column, kind, what});
}

bool Diagnostics::has(const char *id) const {
  return std::any_of(messages_.begin(), messages_.end(), [&](const Message &m) { return std::string(id) == m.kind->id; });
}

void Diagnostics::add(const char *id, const Program &program, const Loc &loc, const std::string &what) {
  add(id, loc.file >= 0 ? program.paths[static_cast<size_t>(loc.file)] : "", loc.line, loc.column, what);
}

bool Diagnostics::hasErrors() const {
  return std::any_of(messages_.begin(), messages_.end(), [this](const Message &m) { return isError(m); });
}

std::string Diagnostics::words(const std::string &text) const {
  static const char *const keywords[][2] = {{"--lagrangian", "LAGRANGIAN"},
                                            {"--holonomic", "HOLONOMIC"},
                                            {"--nonholonomic", "NONHOLONOMIC"},
                                            {"--force", "FORCE"},
                                            {"--dissipation", "DISSIPATION"},
                                            {"--dof", "DOF"},
                                            {"--model", "MODEL"},
                                            {"--arg", "ARGS"},
                                            {"--recursion", "RECURSION"},
                                            {"--rule", "RULES"},
                                            {"--selftest", "SELFTEST"},
                                            {"--need", "NEEDS"},
                                            {"--size", "SIZES"},
                                            {"--parameter", "PARAMETERS"},
                                            {"after '--'", "as INCLUDE_DIRECTORIES and COMPILE_DEFINITIONS"}};
  std::string s = text;
  for (const auto &k : keywords)
    for (size_t at; cmake_ && (at = s.find(k[0])) != std::string::npos;) s.replace(at, std::strlen(k[0]), k[1]);
  return s;
}

void Diagnostics::print(std::ostream &out) const {
  for (const Message &m : messages_) {
    out << (m.file.empty() ? "tlgen" : m.file) << ':';
    if (m.line) out << m.line << ':' << m.column << ':';
    out << ' ' << nameOf(severity(m)) << ": " << text(m) << " [" << m.kind->id << "]\n"
        << "  instead: " << words(m.kind->instead) << '\n';
  }
}

} // namespace tlgen
