/* Andrews' squeezing mechanism as it stands among the examples, with the published parameters. */
#include "../../../examples/models/andrews.c"

static const andrews *published(void) {
  static andrews p;
  p = andrews_parameters();
  return &p;
}
