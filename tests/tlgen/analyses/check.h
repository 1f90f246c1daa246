/* What check.c compares: variants of the same motion functions. */
#ifndef ANALYSES_CHECK_H
#define ANALYSES_CHECK_H

#include "eom/motion.h"

struct variant {
  const char *form, *without; /* "none": the one that the others of its form are compared with; it comes first */
  const eom_motion *motion;
};

extern const struct variant variants[];
extern const int nvariant;
extern const void *const motion_params;

#endif
