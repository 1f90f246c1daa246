/* A way of computing the numbers of a model that is held against the reference. */
#ifndef FUZZ_CONTENDER_H
#define FUZZ_CONTENDER_H

#include "numbers.h"

#include "eom/model.h"

#include <stddef.h>

/* Fills the groups that it has and makes the others absent; leaves a message in text, which is empty before, where it refuses the
 * point. */
typedef void fuzz_compute(const eom_model *model, const void *params, const fuzz_point *p, fuzz_numbers *numbers, char *text,
                          size_t size);

typedef struct fuzz_contender {
  const char *name;
  fuzz_compute *compute;
} fuzz_contender;

fuzz_compute contender_calls;   /* the runtime on jet functions */
fuzz_compute contender_motion;  /* the motion functions, one by one */
fuzz_compute contender_runtime; /* the runtime on motion functions, and on jets where one is missing */

/* The motion functions for these parameters; null where the model has none. */
const eom_motion *contender_find_motion(const eom_model *model, const void *params);

#endif
