// Writes the generated files: all of them whole, or none.
#ifndef TLGEN_OUTPUT_H
#define TLGEN_OUTPUT_H

#include <string>
#include <utility>
#include <vector>

namespace tlgen {

// files: path and text. On failure a message goes to stderr, no file is changed and no part of one is left behind.
bool writeFiles(const std::vector<std::pair<std::string, std::string>> &files);

} // namespace tlgen

#endif
