// A file of models: lines of words, as a shell would split them.
#ifndef TLGEN_MODELS_FILE_H
#define TLGEN_MODELS_FILE_H

#include <string>
#include <vector>

namespace tlgen {

struct ModelLine {
  unsigned number; // of its first line, from 1
  std::vector<std::string> words;
};

// The lines of the file that hold words. False where it cannot be read or a quote stays open; then error says why.
bool readModelsFile(const std::string &path, std::vector<ModelLine> &lines, std::string &error);

} // namespace tlgen

#endif
