/* Checkpoints: the numbers of a run at a mark as bytes, and back.
 *
 *   8 bytes   "eomLyap2": what it is, and the version of what follows
 *   8         length of the whole, bytes
 *   8         hash of what must be the same at both ends: model, sizes, number type, options
 *   8         hash of the derivative and the energy at the state: parameters, and the bits that a program computes
 *   ..        time, state, and what else a run has gathered, in the order of exchange_all
 *   8         hash of all bytes before
 * Integers are of 8 bytes, least byte first; numbers are the bytes of their IEEE format in that order. Hashes are FNV-1a of 64 bits,
 * which notices each change of one byte. */
#include "lyapunov.h"

#include "eom/assemble.h"

#include <stdint.h>
#include <string.h>

static const char magic[] = "eomLyap2";
enum { WORD = 8, HEAD = 4 * WORD };

/* Bytes of a number that say something: C's long double may be filled up. */
#define REAL_BYTES (TL_MANT_DIG == 64 ? (size_t)10 : sizeof(tl_real))

/* ---- bytes ---- */

static uint64_t hash_bytes(uint64_t hash, const unsigned char *bytes, size_t count) {
  for (size_t i = 0; i < count; i++) hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
  return hash;
}

static const uint64_t no_hash = UINT64_C(14695981039346656037);

/* Bytes that are counted, written, read, or hashed, one after the other. */
typedef struct stream {
  enum { COUNT, WRITE, READ, HASH } mode;
  unsigned char *at;
  size_t count;
  uint64_t hash;
} stream;

static bool first_byte_is_least(void) {
  const uint16_t one = 1;
  unsigned char first;
  memcpy(&first, &one, 1);
  return first == 1;
}

/* Passes an object of that many bytes, least byte first in the stream. */
static void pass(stream *s, void *object, size_t bytes) {
  unsigned char *own = object;
  for (size_t i = 0; i < bytes; i++) {
    unsigned char *byte = first_byte_is_least() ? own + i : own + bytes - 1 - i;
    if (s->mode == WRITE) s->at[s->count] = *byte;
    if (s->mode == READ) *byte = s->at[s->count];
    if (s->mode == HASH) s->hash = hash_bytes(s->hash, byte, 1);
    s->count++;
  }
}

static void pass_word(stream *s, uint64_t *x) { pass(s, x, WORD); }

static void pass_long(stream *s, long *x) {
  uint64_t word = (uint64_t)(int64_t)*x;
  pass_word(s, &word);
  if (s->mode == READ) *x = (long)(int64_t)word;
}

static void pass_int(stream *s, int *x) {
  long wide = *x;
  pass_long(s, &wide);
  if (s->mode == READ) *x = (int)wide;
}

static void pass_reals(stream *s, tl_real *x, size_t count) {
  for (size_t i = 0; i < count; i++) pass(s, x + i, REAL_BYTES);
}

/* ---- what a run is ---- */

static void pass_text(stream *s, const char *text) {
  for (; *text; text++) {
    char c = *text;
    pass(s, &c, 1);
  }
  char end = '\0';
  pass(s, &end, 1);
}

/* Everything that the bits to come depend on, but for the parameters' values and the state. */
static uint64_t identity(const eom_lyapunov *ly) {
  stream s = {.mode = HASH, .hash = no_hash};
  const eom_system *sys = ly->sys;
  eom_lyapunov_options o = ly->options;
  int sizes[] = {sys->n,       sys->m1, sys->m2, ly->d, ly->k, (int)o.scheme, (int)o.product, TL_MANT_DIG, ly->it.controlled != NULL,
                 o.taylor != 0};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) pass_int(&s, &sizes[i]);
  pass_text(&s, sys->model->name);
  pass_text(&s, o.method->name);
  tl_real numbers[] = {o.interval, o.h, o.control.h_min, o.control.h_max};
  pass_reals(&s, numbers, sizeof numbers / sizeof *numbers);
  if (ly->it.controlled) {
    pass_reals(&s, ly->work->rtol, (size_t)ly->work->dim);
    pass_reals(&s, ly->work->atol, (size_t)ly->work->dim);
  }
  return s.hash;
}

/* The derivative and the energy at (t, z), as this program computes them. */
static uint64_t dynamics(const eom_lyapunov *ly, tl_real t, const tl_real *z) {
  stream s = {.mode = HASH, .hash = no_hash};
  eom_system *sys = ly->sys;
  tl_real *zdot = ly->work->scratch;
  const int d = 2 * sys->n;
  if (eom_lyapunov_rates((eom_lyapunov *)ly, t, z, z + d, zdot, zdot + d) == EOM_OK) pass_reals(&s, zdot, (size_t)ly->work->dim);
  if (eom_energy(sys, z, z + sys->n, t) == EOM_OK) pass_reals(&s, &sys->energy, 1);
  return s.hash;
}

/* The time and the state first: restore looks at them before it takes the rest. */
static void exchange_state(stream *s, tl_real *t, tl_real *z, int dim) {
  pass_reals(s, t, 1);
  pass_reals(s, z, (size_t)dim);
}

static void exchange_integrator(stream *s, eom_integrator *it) {
  tl_real *const numbers[] = {&it->t0, &it->h, &it->log_error};
  long *const counts[] = {&it->steps, &it->rejected, &it->failed, &it->evaluations};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) pass_reals(s, numbers[i], 1);
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) pass_long(s, counts[i]);
}

static void exchange_rest(stream *s, eom_lyapunov *ly) {
  const size_t k = (size_t)ly->k;
  tl_real *const numbers[] = {
      &ly->t0, &ly->energy0, &ly->energy, &ly->energy_error, &ly->work->span, &ly->work->log_volume_0, &ly->work->log_volume};
  long *const counts[] = {&ly->marks, &ly->qrs, &ly->block_marks, &ly->block_fill};
  for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) pass_reals(s, numbers[i], 1);
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) pass_long(s, counts[i]);
  exchange_integrator(s, &ly->it);
  exchange_integrator(s, &ly->tangents);
  pass_reals(s, ly->work->mark.carry, 2 * (size_t)ly->sys->n);
  pass_int(s, &ly->nblock);
  if (ly->options.scheme == EOM_LYAPUNOV_DISCRETE) pass_reals(s, ly->rho, k);
  pass_reals(s, ly->block, k * EOM_LYAPUNOV_BLOCKS);
  pass_reals(s, ly->block_start, k);
}

/* ---- both ways ---- */

size_t eom_lyapunov_image_bytes(const eom_lyapunov *ly) {
  stream s = {.mode = COUNT, .count = HEAD};
  exchange_state(&s, ly->work->mark.z, ly->work->mark.z, ly->work->dim);
  exchange_rest(&s, (eom_lyapunov *)ly);
  return s.count + WORD;
}

void eom_lyapunov_save(const eom_lyapunov *ly, void *image) {
  stream s = {.mode = WRITE, .at = image};
  uint64_t length = eom_lyapunov_image_bytes(ly), who = identity(ly), how = dynamics(ly, ly->t, ly->work->mark.z);
  tl_real t = ly->t;
  memcpy(image, magic, WORD);
  s.count = WORD;
  pass_word(&s, &length);
  pass_word(&s, &who);
  pass_word(&s, &how);
  exchange_state(&s, &t, ly->work->mark.z, ly->work->dim);
  exchange_rest(&s, (eom_lyapunov *)ly);
  uint64_t sum = hash_bytes(no_hash, image, s.count);
  pass_word(&s, &sum);
}

static uint64_t word_at(const void *image, size_t place) {
  stream s = {.mode = READ, .at = (unsigned char *)image, .count = place};
  uint64_t word = 0;
  pass_word(&s, &word);
  return word;
}

static bool is_whole(const void *image, size_t bytes) {
  if (!image || bytes < HEAD + WORD || memcmp(image, magic, WORD) != 0) return false;
  return word_at(image, WORD) == bytes && word_at(image, bytes - WORD) == hash_bytes(no_hash, image, bytes - WORD);
}

eom_status eom_lyapunov_restore(eom_lyapunov *ly, const void *image, size_t bytes) {
  if (!is_whole(image, bytes)) return EOM_BAD_CHECKPOINT;
  if (bytes != eom_lyapunov_image_bytes(ly) || word_at(image, 2 * WORD) != identity(ly)) return EOM_OTHER_CHECKPOINT;
  eom_lyapunov_work *w = ly->work;
  stream s = {.mode = READ, .at = (unsigned char *)image, .count = HEAD};
  tl_real t = TL_C(0.0);
  exchange_state(&s, &t, w->mark.z, w->dim);
  eom_status status = eom_lyapunov_hold_rows(ly, t, w->mark.z);
  if (status != EOM_OK || dynamics(ly, t, w->mark.z) != word_at(image, 3 * WORD)) {
    eom_lyapunov_keep_mark(ly); /* the run is at its last mark */
    status = eom_lyapunov_hold_rows(ly, ly->t, ly->it.y);
    return status == EOM_OK ? EOM_OTHER_CHECKPOINT : status;
  }
  exchange_rest(&s, ly);
  ly->t = ly->it.t = ly->it.t_before = ly->tangents.t = ly->tangents.t_before = t;
  eom_lyapunov_put_mark(ly);
  w->t_qr = t;
  eom_lyapunov_keep_mark(ly);
  return EOM_OK;
}
