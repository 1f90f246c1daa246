/* The context of an evaluation: shape, workspace and status. One per thread; nothing in the library is global. */
#ifndef TAYLOR_CONTEXT_H
#define TAYLOR_CONTEXT_H

#include "taylor/real.h"
#include "taylor/shape.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Every operation that can fail, by the name it has in a report: seed for tl_const and tl_seed, add for tl_shift, sub for tl_neg and
 * tl_rsub, scale for tl_axpy, mul for tl_muladd, div for tl_rdiv and tl_divc, compose for tl_apply and tl_apply_n, frame for the
 * workspace. */
/* clang-format off */
#define TL_FUNCTIONS(X)                                                                                                                \
  X(seed) X(copy) X(add) X(sub) X(scale) X(mul) X(div) X(compose) X(sqrt) X(cbrt) X(exp) X(expm1) X(exp2) X(log) X(log1p) X(log2)      \
  X(log10) X(sin) X(cos) X(tan) X(asin) X(acos) X(atan) X(atan2) X(sinh) X(cosh) X(tanh) X(asinh) X(acosh) X(atanh) X(pow) X(hypot)    \
  X(fabs) X(fmin) X(fmax) X(fdim) X(fma) X(copysign) X(erf) X(erfc) X(tgamma) X(lgamma) X(floor) X(ceil) X(trunc) X(round) X(rint)     \
  X(fmod) X(remainder) X(scalbn) X(float) X(frame)
/* clang-format on */

typedef enum tl_fn {
  TL_FN_none,
#define TL_X(name) TL_FN_##name,
  TL_FUNCTIONS(TL_X)
#undef TL_X
} tl_fn;

/* Failure kinds, bits of tl_status.bits. TL_OK is no bit. */
enum {
  TL_OK = 0,
  TL_DOMAIN = 1,    /* the value does not exist: log(-1), acos(2), 1/0 */
  TL_SINGULAR = 2,  /* the value exists, a needed derivative does not: sqrt at 0, acos at 1, fabs at 0, fmin at a tie, floor at 3 */
  TL_NONFINITE = 4, /* a coefficient overflowed, or an operand was not finite */
  TL_NO_SPACE = 8   /* the workspace is too small, or a rule of the user has too many coefficients */
};

/* What went wrong: all kinds so far, and function and source line of the first. */
typedef struct tl_status {
  unsigned bits;
  tl_fn function;   /* the first that failed; TL_FN_none while bits is TL_OK */
  int lane;         /* the first in which it did, where tl_real has lanes; else 0 */
  int line;         /* value of tl_ctx.line at that moment: the line in the source that tlgen read, 0 where unknown */
  const char *file; /* value of tl_ctx.file: that source's name, null where the model has only one */
} tl_status;

typedef struct tl_ctx {
  const tl_shape *shape;
  tl_status status;
  int line;         /* set by generated code before each operation that can fail */
  const char *file; /* set with it where the model has several sources; a static string */
  tl_real *scratch; /* TL_NSCRATCH jets for the elementary functions */
  tl_real *top;     /* first free number of the frame stack */
  tl_real *end;     /* one past the last */
} tl_ctx;

#define TL_NSCRATCH 8

/* Numbers (tl_real) of workspace for a context with room for njet jets in frames. */
size_t tl_ctx_size(const tl_shape *shape, size_t njet);

/* Starts a context in memory (nreal numbers). Sets status TL_NO_SPACE where even the scratch jets do not fit; then it is of no use. */
void tl_ctx_init(tl_ctx *cx, const tl_shape *shape, tl_real *memory, size_t nreal);

/* Forgets all failures. */
void tl_ctx_clear(tl_ctx *cx);

/* Records a failure; the first one keeps function and line. */
void tl_fail(tl_ctx *cx, unsigned bits, tl_fn function);
void tl_fail_in_lane(tl_ctx *cx, unsigned bits, tl_fn function, int lane);

/* A frame of njet jets on the stack, filled with NaN so that one which is read before it is written sets TL_NONFINITE; or null with
 * status TL_NO_SPACE. tl_pop gives the same number back. */
tl_real *tl_push(tl_ctx *cx, size_t njet);
void tl_pop(tl_ctx *cx, size_t njet);

/* Names for messages; static strings. tl_status_text names the most severe kind set. */
const char *tl_fn_name(tl_fn function);
const char *tl_status_text(unsigned bits);

#ifdef __cplusplus
}
#endif

#endif
