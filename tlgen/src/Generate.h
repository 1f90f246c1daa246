// One run of the tool: sources in, files out.
#ifndef TLGEN_GENERATE_H
#define TLGEN_GENERATE_H

#include "Options.h"

namespace tlgen {

// Exit status: 0 written, 1 refused or not writable (messages on stderr, no file).
int generate(const Options &options);

} // namespace tlgen

#endif
