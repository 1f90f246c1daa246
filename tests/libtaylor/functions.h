/* The elementary functions of jets by name, for the tests that treat them all alike. */
#ifndef TEST_FUNCTIONS_H
#define TEST_FUNCTIONS_H

#include "taylor/taylor.h"
#ifdef TEST_LANES
#include "through_lanes.h"
#endif

/* Of one jet, of two, or of one jet and a constant. */
typedef struct jet_function {
  const char *name; /* as in reference_function.h */
  void (*one)(tl_ctx *cx, tl_real *c, const tl_real *a);
  void (*two)(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
  void (*constant)(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
} jet_function;

/* c = f(a), f(a,b) or f(a,b[0]). */
void jet_apply(const jet_function *f, tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);

extern const jet_function jet_functions[];
extern const int njet_functions;

/* A shape with its tables, a context, and room for jets in frames, all on the heap; fails the program where there is no memory. */
typedef struct jet_space {
  tl_shape shape;
  tl_ctx cx;
  void *table;
  tl_real *memory;
} jet_space;

void jet_space_init(jet_space *space, tl_spec spec, size_t njet);
void jet_space_free(jet_space *space);

#endif
