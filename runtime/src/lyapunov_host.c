/* Runs of Lyapunov exponents in memory from malloc. */
#include "eom/lyapunov.h"

#include <stdlib.h>

/* Options that eom_lyapunov_bytes refuses are those that eom_lyapunov_init does. */
eom_status eom_lyapunov_create(eom_lyapunov **out, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y) {
  *out = NULL;
  const size_t bytes = eom_lyapunov_bytes(sys, options);
  if (bytes == 0) return EOM_BAD_OPTION;
  eom_lyapunov *ly = malloc(sizeof(eom_lyapunov) + bytes);
  if (!ly) return EOM_NO_MEMORY;
  const eom_status status = eom_lyapunov_init(ly, sys, options, t, y, ly + 1, bytes);
  if (status == EOM_OK)
    *out = ly;
  else
    free(ly);
  return status;
}

void eom_lyapunov_destroy(eom_lyapunov *ly) { free(ly); }
