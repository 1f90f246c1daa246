// Paths of files as messages and make rules name them.
#include "Paths.h"

#include <filesystem>

namespace tlgen {

std::string fromHere(const std::string &path) {
  std::error_code none;
  std::string here = std::filesystem::current_path(none).string() + "/";
  return path.compare(0, here.size(), here) == 0 ? path.substr(here.size()) : path;
}

std::string fromHere(const std::string &name, const std::string &absolute) {
  std::error_code none;
  if (absolute.empty() || (name[0] != '/' && std::filesystem::equivalent(name, absolute, none))) return name;
  return fromHere(absolute);
}

std::string makePath(const std::string &path) {
  std::string s;
  for (char ch : path) {
    if (ch == ' ' || ch == '#') s += '\\';
    if (ch == '$') s += '$';
    s += ch;
  }
  return s;
}

} // namespace tlgen
