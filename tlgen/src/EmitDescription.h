// The constant that describes a model's parameters and coordinates to programs that know nothing else of it (eom/description.h).
#ifndef TLGEN_EMITDESCRIPTION_H
#define TLGEN_EMITDESCRIPTION_H

#include "Program.h"

namespace tlgen {

// For the end of the model's .c file. motion: whether that has motion functions.
std::string emitDescription(const Program &program, const Model &model, bool motion);

} // namespace tlgen

#endif
