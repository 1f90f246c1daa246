// One run of the tool: sources in, files out.
#ifndef TLGEN_GENERATE_H
#define TLGEN_GENERATE_H

#include "Options.h"

namespace tlgen {

// Exit status: 0 written, 1 refused or not writable, 2 outputs that would overwrite something. Messages go to stderr, and to the file
// of
// --sarif; where the status is not 0 no other file is written.
int generate(const Run &run);

} // namespace tlgen

#endif
