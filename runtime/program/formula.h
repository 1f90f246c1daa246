/* Formulas of a user: numbers, the coordinates q[i], velocities qd[i], time t and parameters of a model, + - * / ^, functions of
 * math.h. */
#ifndef PROGRAM_FORMULA_H
#define PROGRAM_FORMULA_H

#include "model.h"

typedef struct formula formula;

/* What a formula is evaluated at. */
typedef struct formula_point {
  const model *m;
  int n;
  const double *q, *qd; /* n each; null where there is no state yet: then a formula that reads them is NaN */
  double t;
  double x, y, k; /* of a drawing: the point before, and the number of this one */
} formula_point;

/* What names a formula may use. */
typedef enum formula_names {
  FORMULA_CONSTANTS, /* pi alone */
  FORMULA_STATE,     /* and t, q, qd, the coordinates' and velocities' own names, parameters */
  FORMULA_DRAWING    /* and x, y, k */
} formula_names;

/* Null after writing to error (size bytes) what is wrong and where. m may be null for FORMULA_CONSTANTS. To be freed by formula_free.
 */
formula *formula_parse(const char *text, formula_names names, const model *m, char *error, size_t size);
double formula_value(const formula *f, const formula_point *at);
void formula_free(formula *f);

/* A number with its unit: "1.5", "pi/4", "75 deg", "75deg". Returns 0, or -1 with error filled. */
int formula_number(const char *text, double *value, char *error, size_t size);

#endif
