/* A model from a shared object, and the values of its parameters. */
#ifndef PROGRAM_MODEL_H
#define PROGRAM_MODEL_H

#include "eom/description.h"

#include <stdbool.h>

typedef struct model {
  const char *path; /* as the user wrote it */
  void *object;     /* of dlopen */
  const eom_description *description;
  void *params; /* the parameter struct, zeros at first; null where the model has none */
  bool *set;    /* of each parameter, whether the user gave it a value */
} model;

/* Returns 0, or -1 after a message that says what the file is not. */
int model_open(model *m, const char *path);
void model_close(model *m);

/* Whether there are forces that do not derive from the Lagrangian, so that the energy need not stay. */
bool model_has_forces(const model *m);

/* The row of the table with that name of the given length; null where there is none. */
const eom_parameter *model_parameter(const model *m, const char *name, size_t length);

/* The parameter's name most like a mistyped one; null where none is near. */
const char *model_nearest(const model *m, const char *name);

/* How many numbers a parameter has: 1 for one that is no array, 0 for one that a text cannot set. */
int parameter_count(const eom_parameter *p);

/* Number i of a parameter. Beyond its end: NaN. */
double parameter_value(const model *m, const eom_parameter *p, long i);

/* Returns null, or what is wrong with the value for this parameter. */
const char *parameter_store(model *m, const eom_parameter *p, int i, double value);

#endif
