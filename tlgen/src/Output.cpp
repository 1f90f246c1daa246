// Writes each file beside its place first, and moves all of them there once every one is complete.
#include "Output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

namespace tlgen {

static bool writeWhole(const std::string &path, const std::string &text) {
  std::FILE *file = std::fopen(path.c_str(), "wb");
  if (!file) return false;
  bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  good = std::fflush(file) == 0 && good;
  int error = errno;
  good = std::fclose(file) == 0 && good;
  if (!good && error) errno = error;
  return good;
}

bool writeFiles(const std::vector<std::pair<std::string, std::string>> &files) {
  auto part = [](const std::string &path) { return path + ".part"; };
  auto removeParts = [&] {
    for (const auto &file : files) std::remove(part(file.first).c_str());
    return false;
  };
  for (const auto &file : files)
    if (!writeWhole(part(file.first), file.second)) {
      std::cerr << "tlgen: cannot write " << file.first << ": " << std::strerror(errno) << "; nothing was changed\n";
      return removeParts();
    }
  for (const auto &file : files)
    if (std::rename(part(file.first).c_str(), file.first.c_str()) != 0) {
      std::cerr << "tlgen: cannot write " << file.first << ": " << std::strerror(errno) << '\n';
      return removeParts();
    }
  return true;
}

} // namespace tlgen
