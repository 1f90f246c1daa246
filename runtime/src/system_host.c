/* Systems with memory from malloc, for hosts. */
#include "eom/system.h"

#include <stdint.h>
#include <stdlib.h>

/* The system itself at the front of one allocation. */
eom_status eom_system_create(eom_system **out, const eom_model *model, const void *params, const eom_options *options) {
  *out = NULL;
  eom_system probe;
  const eom_status status = eom_system_init(&probe, model, params, options, NULL, 0); /* NO_MEMORY where all else is well */
  if (status != EOM_NO_MEMORY) return status;
  const size_t bytes = eom_system_bytes(model, params, options);
  if (bytes == 0 || bytes > SIZE_MAX - sizeof(eom_system)) return EOM_NO_MEMORY;
  eom_system *sys = malloc(sizeof(eom_system) + bytes);
  if (!sys) return EOM_NO_MEMORY;
  const eom_status started = eom_system_init(sys, model, params, options, sys + 1, bytes);
  if (started == EOM_OK)
    *out = sys;
  else
    free(sys);
  return started;
}

void eom_system_destroy(eom_system *sys) { free(sys); }
