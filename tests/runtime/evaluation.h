/* A system with the caller's memory for one kind of evaluation. */
#ifndef TEST_EVALUATION_H
#define TEST_EVALUATION_H

#include "close.h"

#include "eom/system.h"

#include <stdlib.h>

typedef struct evaluation {
  eom_system *sys;
  void *memory;
  size_t bytes; /* as many as the evaluation needs */
} evaluation;

/* bytes_of: eom_minimal_bytes and the like. options null: the defaults. */
static inline evaluation evaluation_start(const eom_model *model, const void *params, const eom_options *options,
                                          size_t (*bytes_of)(const eom_system *)) {
  evaluation e;
  assert_int_equal(eom_system_create(&e.sys, model, params, options), EOM_OK);
  e.bytes = bytes_of(e.sys);
  e.memory = malloc(e.bytes);
  assert_non_null(e.memory);
  return e;
}

static inline void evaluation_stop(evaluation *e) {
  free(e->memory);
  eom_system_destroy(e->sys);
}

#endif
