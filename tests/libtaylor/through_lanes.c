/* libtaylor's operations on a jet of one number, done on jets with lanes. The jet goes through one lane after the other; beside it, in
 * the other lanes, stands what the same operation was last done on without failing. */
#include "through_lanes.h"
#include "in_lanes.h"

#include <assert.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What an operation was last done on, in a shape. */
typedef struct neighbour {
  tl_number *numbers;
  int ncoef, curve, nvar, calls;
  long long n;
  lane_arguments arguments;
} neighbour;

static neighbour neighbours[LANE_OPERATIONS];

/* True where the operation would not overflow on the jets by any way: in lanes it may go another one than alone. */
static int is_moderate(int which, const tl_shape *s, const lane_arguments *arguments) {
  const tl_number large = 1 / TL_EPSILON;
  const int adds = which == LANE_TEST_muladd || which == LANE_TEST_axpy; /* the result is an operand too */
  for (int i = 0; i < IN_LANES_C + adds; i++)
    for (int k = 0; arguments->jet[i] && k < in_lanes_length(which, s, i); k++)
      if (!(arguments->jet[i][k] <= large && arguments->jet[i][k] >= -large)) return 0;
  return 1;
}

static int serves(const neighbour *it, const tl_shape *s, long long n) {
  return it->numbers && it->ncoef == s->ncoef && it->curve == s->curve && it->nvar == s->nvar && it->n == n;
}

/* A copy of the arguments. */
static neighbour copy_of(int which, const tl_shape *s, const lane_arguments *mine, long long n, int calls) {
  neighbour it = {.ncoef = s->ncoef, .curve = s->curve, .nvar = s->nvar, .calls = calls, .n = n, .arguments.x = mine->x};
  it.numbers = malloc(IN_LANES_JETS * (size_t)s->ncoef * sizeof *it.numbers);
  if (it.numbers == NULL) abort();
  for (int i = 0; i < IN_LANES_JETS; i++) {
    if (mine->jet[i] == NULL) continue;
    it.arguments.jet[i] = it.numbers + i * s->ncoef;
    memcpy(it.arguments.jet[i], mine->jet[i], (size_t)in_lanes_length(which, s, i) * sizeof *it.numbers);
  }
  return it;
}

static void run(tl_ctx *cx, int which, const lane_arguments *mine, long long n) {
  neighbour *last = &neighbours[which];
  neighbour own = copy_of(which, cx->shape, mine, n, last->calls + 1);
  const lane_arguments *others = serves(last, cx->shape, n) ? &last->arguments : &own.arguments;
  int function, line;
  if (others == &own.arguments) own.calls = 0; /* all lanes fail alike, and the first is said to */
  const unsigned bits = in_lanes(which, cx->shape, mine, others, n, own.calls % TEST_LANES, cx->line, &function, &line);
  if (bits == TL_OK && is_moderate(which, cx->shape, &own.arguments)) {
    free(last->numbers);
    *last = own;
  } else {
    free(own.numbers);
  }
  if (bits == TL_OK) return;
  assert(line == cx->line);
  tl_fail(cx, bits, (tl_fn)function);
}

/* The operations have operands that are not modified, which a lane_arguments does not say. */
#define JET(x) ((tl_real *)(uintptr_t)(x))

#define ONE(name)                                                                                                                      \
  void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a) {                                                                \
    run(cx, LANE_TEST_##name, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_C] = c}}, 0);                                 \
  }
#define TWO(name)                                                                                                                      \
  void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {                                              \
    run(cx, LANE_TEST_##name, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_B] = JET(b), [IN_LANES_C] = c}}, 0);          \
  }
#define CONSTANT(name)                                                                                                                 \
  void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {                                                     \
    run(cx, LANE_TEST_##name, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_C] = c}, .x = x}, 0);                         \
  }
#define BEFORE(name)                                                                                                                   \
  void through_lanes_##name(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a) {                                                     \
    run(cx, LANE_TEST_##name, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_C] = c}, .x = x}, 0);                         \
  }
#define WHOLE(name)                                                                                                                    \
  void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {                                                         \
    run(cx, LANE_TEST_##name, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_C] = c}}, n);                                 \
  }
LANE_TEST_ONE(ONE)
LANE_TEST_TWO(TWO)
LANE_TEST_CONSTANT(CONSTANT)
LANE_TEST_BEFORE(BEFORE)
LANE_TEST_WHOLE(WHOLE)

void through_lanes_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *e) {
  run(cx, LANE_TEST_fma,
      &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_B] = JET(b), [IN_LANES_E] = JET(e), [IN_LANES_C] = c}}, 0);
}
void through_lanes_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  run(cx, LANE_TEST_sincos, &(lane_arguments){.jet = {[IN_LANES_A] = JET(a), [IN_LANES_C] = sine, [IN_LANES_D] = cosine}}, 0);
}
void through_lanes_const(tl_ctx *cx, tl_real *c, tl_real x) {
  run(cx, LANE_TEST_const, &(lane_arguments){.jet = {[IN_LANES_C] = c}, .x = x}, 0);
}
void through_lanes_integer(tl_ctx *cx, tl_real *c, long long n) {
  run(cx, LANE_TEST_integer, &(lane_arguments){.jet = {[IN_LANES_C] = c}}, n);
}
void through_lanes_seed(tl_ctx *cx, tl_real *c, tl_real x, int i) {
  run(cx, LANE_TEST_seed, &(lane_arguments){.jet = {[IN_LANES_C] = c}, .x = x}, i);
}
