// The messages of a run as SARIF 2.1.0.
#include "Sarif.h"

#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"

namespace tlgen {
namespace {

namespace json = llvm::json;

json::Object text(const std::string &s) { return json::Object{{"text", json::fixUTF8(s)}}; }

// A path as a URI: relative where the path is.
std::string uri(const std::string &path) {
  static const std::string plain = "/-._~";
  std::string s = path[0] == '/' ? "file://" : "";
  for (unsigned char ch : path) {
    if (std::isalnum(ch) || plain.find(static_cast<char>(ch)) != std::string::npos)
      s += static_cast<char>(ch);
    else
      s += {'%', "0123456789ABCDEF"[ch / 16], "0123456789ABCDEF"[ch % 16]};
  }
  return s;
}

json::Value rules(const Diagnostics &diags) {
  json::Array list;
  for (const DiagnosticKind &k : allDiagnostics())
    list.push_back(json::Object{{"id", k.id},
                                {"shortDescription", text(k.why)},
                                {"help", text(diags.words(k.instead))},
                                {"defaultConfiguration", json::Object{{"level", nameOf(k.severity)}}}});
  return list;
}

json::Value locations(const Message &m) {
  if (m.file.empty()) return json::Array{};
  json::Object place{{"artifactLocation", json::Object{{"uri", uri(m.file)}}}};
  if (m.line) place["region"] = json::Object{{"startLine", m.line}, {"startColumn", m.column}};
  return json::Array{json::Object{{"physicalLocation", std::move(place)}}};
}

json::Value results(const Diagnostics &diags) {
  json::Array list;
  for (const Message &m : diags.messages())
    list.push_back(json::Object{{"ruleId", m.kind->id},
                                {"ruleIndex", m.kind - allDiagnostics().data()},
                                {"level", nameOf(diags.severity(m))},
                                {"message", text(diags.text(m))},
                                {"locations", locations(m)}});
  return list;
}

} // namespace

std::string sarifText(const Diagnostics &diags) {
  json::Object driver{{"name", "tlgen"}, {"version", TLGEN_VERSION}, {"rules", rules(diags)}};
  json::Object run{{"tool", json::Object{{"driver", std::move(driver)}}},
                   {"invocations", json::Array{json::Object{{"executionSuccessful", !diags.hasErrors()}}}},
                   {"results", results(diags)}};
  json::Value log = json::Object{
      {"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}, {"runs", json::Array{std::move(run)}}};
  return llvm::formatv("{0:2}\n", log).str();
}

} // namespace tlgen
