/* The elementary functions of jets by name. */
#include "functions.h"

#include <stdlib.h>

#define ONE(name) {#name, tl_##name, NULL, NULL}
#define TWO(name) {#name, NULL, tl_##name, NULL}

static void power_of_constant(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) { tl_rpow(cx, c, x, a); }

const jet_function jet_functions[] = {
    ONE(sqrt),
    ONE(cbrt),
    ONE(exp),
    ONE(expm1),
    ONE(exp2),
    ONE(log),
    ONE(log1p),
    ONE(log2),
    ONE(log10),
    ONE(sin),
    ONE(cos),
    ONE(tan),
    ONE(asin),
    ONE(acos),
    ONE(atan),
    ONE(sinh),
    ONE(cosh),
    ONE(tanh),
    ONE(asinh),
    ONE(acosh),
    ONE(atanh),
    ONE(erf),
    ONE(erfc),
    ONE(tgamma),
    ONE(lgamma),
    TWO(mul),
    TWO(div),
    TWO(pow),
    TWO(hypot),
    TWO(atan2),
    {"powc", NULL, NULL, tl_powc},
    {"rpow", NULL, NULL, power_of_constant},
};
const int njet_functions = (int)(sizeof jet_functions / sizeof *jet_functions);

void jet_apply(const jet_function *f, tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  if (f->one)
    f->one(cx, c, a);
  else if (f->two)
    f->two(cx, c, a, b);
  else
    f->constant(cx, c, a, b[0]);
}

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
