// memcpy, memmove and memset of whole objects as the loop over their elements that they stand for.
#ifndef TLGEN_COPYLOOP_H
#define TLGEN_COPYLOOP_H

#include "Program.h"

namespace tlgen {

// The statement that copies count elements: a pointer to an array counts its innermost elements, from null means zeros. With overlap it
// starts at the end that is safe.
Stmt *copyLoop(Program &program, const Loc &loc, Expr *to, Expr *from, Expr *count, bool overlap);

} // namespace tlgen

#endif
