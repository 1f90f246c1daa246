/* What a model's source says beyond its mechanics, for programs that know nothing else of it: names, types and places of its
 * parameters, and names of its coordinates. tlgen prints one constant eom_description per model; nothing in the library reads it. */
#ifndef EOM_DESCRIPTION_H
#define EOM_DESCRIPTION_H

#include "eom/model.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How the numbers of a parameter are stored. */
typedef enum eom_number {
  EOM_NUMBER_REAL,     /* float or double, by its size */
  EOM_NUMBER_INTEGER,  /* signed, */
  EOM_NUMBER_UNSIGNED, /* or not: of 1, 2, 4 or 8 bytes */
  EOM_NUMBER_BOOL,     /* _Bool */
  EOM_NUMBER_NONE      /* a pointer, or what else a text cannot set */
} eom_number;

/* One member of the parameter struct, those of structs inside it and elements of arrays of structs one by one. */
typedef struct eom_parameter {
  const char *name; /* behind the struct: "mass", "arm.length", "link[2].mass" */
  const char *text; /* the comment beside it in the source; null where there is none */
  eom_number number;
  size_t size;   /* bytes of one number */
  size_t offset; /* bytes from the beginning of the struct */
  int count;     /* of an array; 0 for a single number */
  int most;      /* of a single integer: with a larger one the model leaves its arrays; 0: not that tlgen knows */
} eom_parameter;

/* Rows of the table: a number, an array of numbers, and what is neither, of a struct type. kind is REAL, INTEGER, UNSIGNED or BOOL. */
#define EOM_MEMBER(type, member, kind, text) EOM_MEMBER_UP_TO(type, member, 0, kind, text)
#define EOM_MEMBER_UP_TO(type, member, most, kind, text)                                                                               \
  {#member, text, EOM_NUMBER_##kind, sizeof(((type *)NULL)->member), offsetof(type, member), 0, most}
#define EOM_MEMBER_ARRAY(type, member, count, kind, text)                                                                              \
  {#member, text, EOM_NUMBER_##kind, sizeof(((type *)NULL)->member[0]), offsetof(type, member), count, 0}
#define EOM_MEMBER_NONE(type, member, text) {#member, text, EOM_NUMBER_NONE, 0, offsetof(type, member), 0, 0}

/* Changes with the meaning of what a model is made of, and holds the size of a number. */
#define EOM_DESCRIPTION_VERSION (3u << 8 | (unsigned)sizeof(tl_real))

typedef struct eom_description {
  unsigned version;       /* EOM_DESCRIPTION_VERSION of the headers that the model was compiled with. Always the first member, */
  unsigned model_size;    /* and behind it the bytes of an eom_model */
  unsigned motion_size;   /* and of an eom_motion, 0 where the model has none: a program looks at nothing else where these differ */
  const eom_model *model; /* its parameters begin as zeros: there are no values in a struct's definition */
  const eom_parameter *parameter;
  int nparameter;
  const char *const *coordinate; /* n names, where the Lagrangian takes its coordinates one by one; null where they are an array */
  const char *const *velocity;   /* likewise of velocities */
} eom_description;

/* What a shared object exports whose generated source was compiled with -DEOM_SHARED_MODEL. */
const eom_description *eom_shared_model(void);

#ifdef __cplusplus
}
#endif

#endif
