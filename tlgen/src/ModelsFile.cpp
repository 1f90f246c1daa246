// Splits the lines of a file of models into words.
#include "ModelsFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace tlgen {
namespace {

// Quotes of both kinds and backslashes as in a shell; # at the start of a word begins a comment. False where a quote stays open.
bool split(const std::string &line, std::vector<std::string> &words) {
  bool inWord = false;
  char quote = 0;
  std::string word;
  auto end = [&] {
    if (inWord) words.push_back(word);
    word.clear(), inWord = false;
  };
  for (size_t i = 0; i < line.size(); ++i) {
    char ch = line[i];
    if (!quote && !inWord && ch == '#') break;
    if (ch == quote)
      quote = 0;
    else if (ch == '\\' && quote != '\'' && i + 1 < line.size())
      word += line[++i], inWord = true;
    else if (quote)
      word += ch;
    else if (ch == '"' || ch == '\'')
      quote = ch, inWord = true;
    else if (ch == ' ' || ch == '\t' || ch == '\r')
      end();
    else
      word += ch, inWord = true;
  }
  end();
  return !quote;
}

} // namespace

bool readModelsFile(const std::string &path, std::vector<ModelLine> &lines, std::string &error) {
  std::ifstream in(path);
  unsigned number = 0;
  for (std::string text; std::getline(in, text);) {
    ModelLine line{++number, {}};
    for (std::string more; !text.empty() && text.back() == '\\' && std::getline(in, more); ++number)
      text.pop_back(), text += " " + more;
    if (!split(text, line.words)) return error = path + ":" + std::to_string(line.number) + ": a quote is not closed", false;
    if (!line.words.empty()) lines.push_back(line);
  }
  if (in.eof() && !in.bad()) return true;
  return error = "cannot read " + path + ": " + std::strerror(errno), false;
}

} // namespace tlgen
