// The calls emitter: a whole model as one C file and its header.
#ifndef TLGEN_EMITCALLS_H
#define TLGEN_EMITCALLS_H

#include "Activity.h"
#include "EmitAdjoint.h"

namespace tlgen {

struct EmittedModel {
  std::string source, header;
  std::string sizes; // of EOM_SYSTEM_BYTES (eom/bytes.h); empty where they are no constants
};

// What of a model is printed: all of it; without names and comments for programs that show it to people; or its motion functions alone.
enum class Content { Whole, Model, Motion };

// motion: the model's motion functions, printed beside these. headerName: how the source includes its header. The text depends on
// nothing but the arguments. Frames without a bound are reported.
EmittedModel emitCalls(const Program &program, const Model &model, const Activity &activity, const MotionText &motion,
                       Diagnostics &diags, const std::string &headerName, Content content = Content::Whole);

} // namespace tlgen

#endif
