// Paths of files as messages and make rules name them.
#ifndef TLGEN_PATHS_H
#define TLGEN_PATHS_H

#include <string>

namespace tlgen {

// The path relative to the working directory where it is inside of that, otherwise as it is.
std::string fromHere(const std::string &path);

// A file that was opened as name in some folder, and whose absolute path is known (or empty): the name where it holds here too.
std::string fromHere(const std::string &name, const std::string &absolute);

// A path as make reads it.
std::string makePath(const std::string &path);

} // namespace tlgen

#endif
