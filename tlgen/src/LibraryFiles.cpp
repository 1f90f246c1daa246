// What of the library a program needs, by the names in its text.
#include "LibraryFiles.h"

#include <cctype>
#include <map>
#include <set>

namespace tlgen {
namespace {

bool isWord(char ch) { return isalnum(static_cast<unsigned char>(ch)) || ch == '_'; }

// The text without comments, and strings and characters as empty ones.
std::string codeOf(const std::string &text) {
  std::string s;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "/*") == 0) {
      i = text.find("*/", i + 2) + 1;
      s += ' ';
    } else if (text.compare(i, 2, "//") == 0) {
      i = text.find('\n', i) - 1;
    } else if ((text[i] == '"' || text[i] == '\'') && s.find_last_of('\n') != std::string::npos &&
               s.compare(s.find_last_of('\n') + 1, 8, "#include") != 0) {
      const char quote = text[i];
      for (++i; text[i] != quote; ++i) i += text[i] == '\\';
      s += "\"\"";
    } else {
      s += text[i];
    }
  }
  return s;
}

// What exports are not made for.
bool isOff(const std::string &condition) {
  for (const char *off : {"TL_REAL_LANES", "EOM_HAVE_LAPACKE", "TL_VECTORS", "__cplusplus"})
    if (condition.compare(0, std::string(off).size(), off) == 0) return true;
  return false;
}

// The lines that the preprocessor would leave there, those of other conditions included.
std::string linesOf(const std::string &code) {
  std::string s;
  std::vector<bool> open; // of each condition around the line
  auto isOpen = [&] {
    for (bool o : open)
      if (!o) return false;
    return true;
  };
  for (size_t at = 0, end; at < code.size(); at = end + 1) {
    end = std::min(code.find('\n', at), code.size());
    const std::string line = code.substr(at, end - at);
    auto rest = [&](const std::string &directive) {
      const bool is = line.compare(0, directive.size(), directive) == 0;
      return is ? line.substr(std::min(line.size(), line.find_first_not_of(' ', directive.size()))) : std::string();
    };
    const bool ifndef = !rest("#ifndef").empty();
    const std::string condition = !rest("#ifdef").empty() ? rest("#ifdef") : rest("#if ");
    if (ifndef || !condition.empty()) {
      open.push_back(ifndef || !isOff(condition));
    } else if (line.compare(0, 5, "#else") == 0 || line.compare(0, 5, "#elif") == 0) {
      if (!open.back() || isOff(rest("#elif"))) open.back() = line.compare(0, 5, "#else") == 0 || !isOff(rest("#elif"));
    } else if (line.compare(0, 6, "#endif") == 0) {
      open.pop_back();
    } else if (isOpen()) {
      s += line + "\n";
    }
  }
  return s;
}

std::set<std::string> wordsOf(const std::string &code) {
  std::set<std::string> words;
  for (size_t i = 0; i < code.size();) {
    size_t end = i;
    while (end < code.size() && isWord(code[end])) ++end;
    if (end > i) words.insert(code.substr(i, end - i));
    i = end + 1;
  }
  return words;
}

std::vector<std::string> includesOf(const std::string &lines) {
  std::vector<std::string> names;
  const std::string directive = "#include ";
  for (size_t at = 0; (at = lines.find(directive, at)) != std::string::npos;) {
    at += directive.size() + 1;
    names.push_back(lines.substr(at, lines.find_first_of("\">\n", at) - at));
  }
  return names;
}

// The name that a declaration outside of functions gives to something that other files see; empty for others.
std::string definedName(const std::string &declaration) {
  const std::set<std::string> words = wordsOf(declaration);
  if (words.count("static") || words.count("typedef")) return "";
  size_t end = declaration.find_first_of("(=[");
  if (end == std::string::npos) return ""; // struct x {
  while (end > 0 && !isWord(declaration[end - 1])) --end;
  size_t start = end;
  while (start > 0 && isWord(declaration[start - 1])) --start;
  return declaration.substr(start, end - start);
}

// Functions and objects that a C file defines for others.
std::set<std::string> definitionsIn(const std::string &lines) {
  std::set<std::string> names;
  std::string declaration;
  int depth = 0;
  bool inDirective = false;
  for (size_t i = 0; i < lines.size(); ++i) {
    const char ch = lines[i];
    if (ch == '#' && (i == 0 || lines[i - 1] == '\n')) inDirective = true;
    if (ch == '\n' && i > 0 && lines[i - 1] != '\\') inDirective = false;
    if (inDirective) continue;
    if (ch == '{' && depth++ == 0) names.insert(definedName(declaration)), declaration.clear();
    if (ch == '}' && --depth == 0) declaration.clear();
    if (depth == 0 && ch != '}') declaration = ch == ';' ? "" : declaration + ch;
  }
  names.erase("");
  return names;
}

bool endsWith(const std::string &s, const std::string &end) {
  return s.size() >= end.size() && s.compare(s.size() - end.size(), end.size(), end) == 0;
}

class Closure {
public:
  Closure() {
    for (const LibraryFile &file : libraryFiles()) {
      const size_t slash = file.path.find('/');
      if (slash == std::string::npos || (file.path.compare(0, 8, "include/") && file.path.compare(0, 4, "src/"))) continue;
      byInclude_[file.path.substr(slash + 1)] = &file;
      if (!endsWith(file.path, ".c")) continue;
      for (const std::string &name : definitionsIn(linesOf(codeOf(file.text)))) definer_[name] = &file;
    }
  }

  void take(const std::string &text, bool isHeader) {
    const std::string lines = linesOf(codeOf(text));
    for (const std::string &name : includesOf(lines)) {
      auto known = byInclude_.find(name);
      if (known != byInclude_.end()) take(*known->second);
    }
    if (isHeader) return; // it declares more than it uses
    for (const std::string &word : wordsOf(lines)) {
      auto known = definer_.find(word);
      if (known != definer_.end()) take(*known->second);
    }
  }

  std::vector<LibraryFile> files() const {
    std::vector<LibraryFile> all;
    for (const LibraryFile &file : libraryFiles())
      if (taken_.count(file.path)) all.push_back(file);
    return all;
  }

private:
  void take(const LibraryFile &file) {
    if (taken_.insert(file.path).second) take(file.text, endsWith(file.path, ".h"));
  }

  std::map<std::string, const LibraryFile *> byInclude_, definer_;
  std::set<std::string> taken_;
};

} // namespace

std::set<std::string> namesDefinedIn(const std::string &text) { return definitionsIn(linesOf(codeOf(text))); }

std::vector<LibraryFile> neededFiles(const std::vector<std::string> &text) {
  Closure closure;
  for (const std::string &t : text) closure.take(t, false);
  return closure.files();
}

} // namespace tlgen
