/* The elementary functions of jets by name. */
#include "functions.h"

#include <stdlib.h>

#define ONE(name) {#name, tl_##name, NULL}
#define TWO(name) {#name, NULL, tl_##name}

const jet_function jet_functions[] = {
    ONE(sqrt),  ONE(cbrt), ONE(exp),  ONE(expm1),  ONE(exp2),   ONE(log),  ONE(log1p), ONE(log2), ONE(log10), ONE(sin),
    ONE(cos),   ONE(tan),  ONE(asin), ONE(acos),   ONE(atan),   ONE(sinh), ONE(cosh),  ONE(tanh), ONE(asinh), ONE(acosh),
    ONE(atanh), ONE(erf),  ONE(erfc), ONE(tgamma), ONE(lgamma), TWO(mul),  TWO(div),   TWO(pow),  TWO(hypot), TWO(atan2),
};
const int njet_functions = (int)(sizeof jet_functions / sizeof *jet_functions);

static void *allocate(size_t bytes) {
  void *memory = malloc(bytes ? bytes : 1);
  if (!memory) abort();
  return memory;
}

void jet_space_init(jet_space *space, tl_spec spec, size_t njet) {
  const size_t bytes = tl_shape_bytes(spec);
  space->table = allocate(bytes);
  if (tl_shape_init(&space->shape, spec, space->table, bytes) != 0) abort();
  const size_t nreal = tl_ctx_size(&space->shape, njet);
  space->memory = allocate(nreal * sizeof(tl_real));
  tl_ctx_init(&space->cx, &space->shape, space->memory, nreal);
}

void jet_space_free(jet_space *space) {
  free(space->memory);
  free(space->table);
}
