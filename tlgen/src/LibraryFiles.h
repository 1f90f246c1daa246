// The sources of libtaylor and of the runtime's core, and what else an export carries: files inside of tlgen, put there by its build.
#ifndef TLGEN_LIBRARYFILES_H
#define TLGEN_LIBRARYFILES_H

#include <set>
#include <string>
#include <vector>

namespace tlgen {

struct LibraryFile {
  std::string path; // in an export: "include/taylor/real.h", "src/step.c", "footprint.py"
  std::string text;
};

// In the order of their paths.
const std::vector<LibraryFile> &libraryFiles();

// The files that these sources need and no others: headers that they include, and C files with the functions that they call, and so on.
// text: C; its own includes count too.
std::vector<LibraryFile> neededFiles(const std::vector<std::string> &text);

// Functions and objects that C defines for other files.
std::set<std::string> namesDefinedIn(const std::string &text);

} // namespace tlgen

#endif
