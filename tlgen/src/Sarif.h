// The messages of a run as SARIF 2.1.0, the format that editors and continuous integration read.
#ifndef TLGEN_SARIF_H
#define TLGEN_SARIF_H

#include "Diagnostics.h"

namespace tlgen {

// All messages of the run, and all ids of Diagnostics.def as rules. The same text for the same messages.
std::string sarifText(const Diagnostics &diags);

} // namespace tlgen

#endif
