/* Jet expressions as nested calls, for models written by hand: every result is a new jet of the frame stack. */
#ifndef TEST_PEN_H
#define TEST_PEN_H

#include "taylor/taylor.h"

typedef struct pen {
  tl_ctx *cx;
  size_t used; /* jets taken; pen_lift gives them back */
} pen;

#define PEN_FRAME 96 /* jets that any model here may take */

typedef const tl_real *jet;

static inline tl_real *pen_new(pen *p) {
  tl_real *c = tl_push(p->cx, 1);
  if (c) p->used++;
  return c;
}

/* Where the frame is full the context has its status, and the operands serve as harmless results. */
#define PEN_UNARY(name, call)                                                                                                          \
  static inline jet name(pen *p, jet a) {                                                                                              \
    tl_real *c = pen_new(p);                                                                                                           \
    if (!c) return a;                                                                                                                  \
    call;                                                                                                                              \
    return c;                                                                                                                          \
  }
#define PEN_BINARY(name, function)                                                                                                     \
  static inline jet name(pen *p, jet a, jet b) {                                                                                       \
    tl_real *c = pen_new(p);                                                                                                           \
    if (!c) return a;                                                                                                                  \
    function(p->cx, c, a, b);                                                                                                          \
    return c;                                                                                                                          \
  }
PEN_BINARY(add, tl_add)
PEN_BINARY(sub, tl_sub)
PEN_BINARY(mul, tl_mul)
PEN_BINARY(quo, tl_div)
PEN_UNARY(sine, tl_sin(p->cx, c, a))
PEN_UNARY(cosine, tl_cos(p->cx, c, a))
PEN_UNARY(root, tl_sqrt(p->cx, c, a))
PEN_UNARY(square, tl_mul(p->cx, c, a, a))

static inline jet times(pen *p, tl_real x, jet a) {
  tl_real *c = pen_new(p);
  if (!c) return a;
  tl_scale(p->cx, c, a, x);
  return c;
}

/* a + x. */
static inline jet plus(pen *p, jet a, tl_real x) {
  tl_real *c = pen_new(p);
  if (!c) return a;
  tl_shift(p->cx, c, a, x);
  return c;
}

static inline void pen_result(pen *p, tl_real *out, jet a) { tl_copy(p->cx, out, a); }

static inline void pen_lift(pen *p) { tl_pop(p->cx, p->used); }

/* Jet i of an array of jets. */
static inline jet at(const pen *p, jet a, int i) { return a + (size_t)i * (size_t)p->cx->shape->ncoef; }
static inline tl_real *row(const pen *p, tl_real *a, int i) { return a + (size_t)i * (size_t)p->cx->shape->ncoef; }

#endif
