/* A model from a shared object, and the values of its parameters. */
#include "model.h"

#include "eom/motion.h"
#include "host/message.h"
#include "host/nearest.h"

#include <dlfcn.h>
#include <errno.h>
#include <link.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Behind the parameter struct: what a function reads there that goes past the end of an array is no number, not the end of the program.
 */
enum { MARGIN = 1 << 16 };

static int no_model(const char *path, const char *what) {
  complain("%s: %s", path, what);
  complain("a model is made by taylor_add_model(NAME .. SHARED) or by hand:\n"
           "  tlgen model.c --model NAME --lagrangian L --dof N -o NAME_tl.c\n"
           "  cc -O2 -shared -fPIC -DEOM_SHARED_MODEL $(pkg-config --cflags libtaylor) NAME_tl.c -o NAME.so -lm");
  return -1;
}

/* Nothing but the first members is looked at where they are not as this program has them. */
static int check_version(const char *path, const eom_description *d) {
  const bool other = d->version != EOM_DESCRIPTION_VERSION;
  if (!other && d->model_size == sizeof(eom_model) && (d->motion_size == 0 || d->motion_size == sizeof(eom_motion))) return 0;
  if (other && (d->version & 255u) != (EOM_DESCRIPTION_VERSION & 255u))
    complain("%s: its numbers have %u bytes, those of this program %u; compile it without -DTL_REAL", path, d->version & 255u,
             EOM_DESCRIPTION_VERSION & 255u);
  else
    complain("%s: it was compiled with another version of the library; run tlgen and the compiler of this one again", path);
  return -1;
}

/* Memory of the parameters: the struct in zeros, then NaN. */
static void *new_params(size_t size) {
  const size_t whole = (size + sizeof(double) - 1) / sizeof(double) * sizeof(double);
  double *memory = calloc(1, whole + MARGIN);
  if (memory != NULL)
    for (size_t i = whole / sizeof(double); i < (whole + MARGIN) / sizeof(double); i++) memory[i] = (double)NAN;
  return memory;
}

static int describe(model *m) {
  const eom_description *(*shared)(void);
  void *symbol = dlsym(m->object, "eom_shared_model");
  if (symbol == NULL) return no_model(m->path, "a shared object, but not one of a model: it does not export eom_shared_model");
  memcpy(&shared, &symbol, sizeof shared); /* ISO C has no cast from an object to a function */
  m->description = shared();
  if (m->description == NULL) return no_model(m->path, "its eom_shared_model gives no model");
  if (check_version(m->path, m->description) != 0) return -1;
  if (m->description->model->params_size > 0) m->params = new_params(m->description->model->params_size);
  m->set = calloc((size_t)m->description->nparameter + 1, sizeof *m->set);
  if (m->set != NULL && (m->params != NULL || m->description->model->params_size == 0)) return 0;
  complain("%s: not enough memory for its parameters", m->path);
  return -1;
}

/* Whether all of it is there that its header announces: the loader maps what is missing, and to touch that ends the program. What is no
 * such file at all is for the loader to refuse. */
static bool is_whole(FILE *file) {
  ElfW(Ehdr) head;
  ElfW(Phdr) part;
  struct stat info;
  if (fstat(fileno(file), &info) != 0 || fread(&head, sizeof head, 1, file) != 1 || memcmp(head.e_ident, ELFMAG, SELFMAG) != 0)
    return true;
  const size_t size = (size_t)info.st_size;
  if (head.e_shoff > size || (size_t)head.e_shnum * head.e_shentsize > size - head.e_shoff || head.e_phoff > size ||
      fseek(file, (long)head.e_phoff, SEEK_SET) != 0)
    return false;
  for (int i = 0; i < head.e_phnum && head.e_phentsize == sizeof part; i++)
    if (fread(&part, sizeof part, 1, file) != 1 || part.p_offset > size || part.p_filesz > size - part.p_offset) return false;
  return true;
}

static int check_whole(const char *path) {
  FILE *file = fopen(path, "rb");
  if (file == NULL) return complain("%s: %s", path, strerror(errno)), -1;
  const bool whole = is_whole(file);
  fclose(file);
  return whole ? 0 : no_model(path, "it has been cut short");
}

int model_open(model *m, const char *path) {
  *m = (model){.path = path};
  if (check_whole(path) != 0) return -1;
  char *whole = realpath(path, NULL); /* a name without a folder would be looked for among the system's libraries */
  m->object = whole != NULL ? dlopen(whole, RTLD_NOW | RTLD_LOCAL) : NULL;
  free(whole);
  if (m->object == NULL) {
    const char *why = dlerror();
    return no_model(path, why != NULL ? why : "it cannot be loaded");
  }
  if (describe(m) == 0) return 0;
  model_close(m);
  return -1;
}

void model_close(model *m) {
  free(m->params);
  free(m->set);
  if (m->object != NULL) dlclose(m->object);
  *m = (model){.path = m->path};
}

bool model_has_forces(const model *m) {
  const eom_model *is = m->description->model;
  return is->force.jet != NULL || is->dissipation.jet != NULL;
}

const eom_parameter *model_parameter(const model *m, const char *name, size_t length) {
  for (int i = 0; i < m->description->nparameter; i++) {
    const eom_parameter *p = &m->description->parameter[i];
    if (strlen(p->name) == length && memcmp(p->name, name, length) == 0) return p;
  }
  return NULL;
}

const char *model_nearest(const model *m, const char *name) {
  const char *found = NULL;
  for (int i = 0; i < m->description->nparameter; i++) found = nearer(name, found, m->description->parameter[i].name);
  return found;
}

int parameter_count(const eom_parameter *p) { return p->number == EOM_NUMBER_NONE ? 0 : p->count > 0 ? p->count : 1; }

/* Each way that a number is stored: its type in C, the kind and the size of the table's row. */
#define STORED(X)                                                                                                                      \
  X(double, EOM_NUMBER_REAL)                                                                                                           \
  X(float, EOM_NUMBER_REAL)                                                                                                            \
  X(int8_t, EOM_NUMBER_INTEGER)                                                                                                        \
  X(int16_t, EOM_NUMBER_INTEGER)                                                                                                       \
  X(int32_t, EOM_NUMBER_INTEGER)                                                                                                       \
  X(int64_t, EOM_NUMBER_INTEGER)                                                                                                       \
  X(uint8_t, EOM_NUMBER_UNSIGNED)                                                                                                      \
  X(uint16_t, EOM_NUMBER_UNSIGNED)                                                                                                     \
  X(uint32_t, EOM_NUMBER_UNSIGNED)                                                                                                     \
  X(uint64_t, EOM_NUMBER_UNSIGNED)                                                                                                     \
  X(bool, EOM_NUMBER_BOOL)

double parameter_value(const model *m, const eom_parameter *p, long i) {
  if (i < 0 || i >= parameter_count(p)) return (double)NAN;
  const char *at = (const char *)m->params + p->offset + (size_t)i * p->size;
#define X(type, kind)                                                                                                                  \
  if (p->number == kind && p->size == sizeof(type)) {                                                                                  \
    type value;                                                                                                                        \
    memcpy(&value, at, sizeof value);                                                                                                  \
    return (double)value;                                                                                                              \
  }
  STORED(X)
#undef X
  return (double)NAN;
}

/* The largest number that fits, and whether negative ones do. */
static const char *unfit(const eom_parameter *p, double value) {
  if (!isfinite(value)) return "it is not finite";
  if (p->number == EOM_NUMBER_REAL) return p->size == sizeof(float) && fabs(value) > 3.4e38 ? "it is too large for a float" : NULL;
  if (value != floor(value)) return "it must be a whole number";
  if (p->number == EOM_NUMBER_BOOL) return value != 0.0 && value != 1.0 ? "it must be 0 or 1" : NULL;
  const int bits = 8 * (int)p->size - (p->number == EOM_NUMBER_INTEGER);
  if (value >= ldexp(1.0, bits)) return "it is too large for the type of this member";
  if (value < (p->number == EOM_NUMBER_INTEGER ? -ldexp(1.0, bits) : 0.0)) return "it is too small for the type of this member";
  if (p->most > 0 && value > p->most) {
    static char text[96];
    snprintf(text, sizeof text, "it may be %d at most: with more the model would leave its arrays", p->most);
    return text;
  }
  return NULL;
}

const char *parameter_store(model *m, const eom_parameter *p, int i, double value) {
  if (parameter_count(p) == 0) return "this member cannot be set by a text: it is a pointer or no number";
  const char *wrong = unfit(p, value);
  if (wrong != NULL) return wrong;
  char *at = (char *)m->params + p->offset + (size_t)i * p->size;
#define X(type, kind)                                                                                                                  \
  if (p->number == kind && p->size == sizeof(type)) {                                                                                  \
    const type stored = (type)value;                                                                                                   \
    memcpy(at, &stored, sizeof stored);                                                                                                \
    m->set[p - m->description->parameter] = true;                                                                                      \
    return NULL;                                                                                                                       \
  }
  STORED(X)
#undef X
  return "this member has a type of an unknown size";
}
