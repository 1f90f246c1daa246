// Keeps the user's names and those that the output needs apart.
#ifndef TLGEN_NAMES_H
#define TLGEN_NAMES_H

#include "Program.h"

namespace tlgen {

// Renames the variables whose names the output wants for itself, with underscores behind, and fills Program::names.
void separateNames(Program &program, const std::string &model);

// True where a function of the output may not have that name: the printed description, libtaylor or the C library has it.
bool reservedFunctionName(const std::string &name, const std::string &model);

// True for the name of a C file, "model.c".
bool isSource(const std::string &file);

} // namespace tlgen

#endif
