/* Derivatives of a motion by initial values and parameters, as --sensitivity names them, followed beside it. */
#ifndef PROGRAM_DERIVATIVES_H
#define PROGRAM_DERIVATIVES_H

#include "eom/trajectory.h"
#include "method.h"
#include "series.h"

enum { DERIVATIVES_MOST = 32 };

typedef struct derivatives {
  int count;                       /* of names; 0: none is asked for, and nothing else is filled */
  char name[DERIVATIVES_MOST][64]; /* initial values before parameters */
  int component[DERIVATIVES_MOST]; /* of initial values: of y */
  int parameter[DERIVATIVES_MOST]; /* of parameters: of sys->motion->parameter, in the order of their columns */
  eom_system *sys;
  eom_sensitivity columns;
  double *z; /* columns.dim: (y, S) at the start; where the motion ended */
  double *work;
} derivatives;

/* Reads names separated by commas. text null: none. Returns 0, or -1 after a message; then there is nothing to close. */
int derivatives_open(derivatives *d, const setup *s, const method *how, const char *text);
void derivatives_close(derivatives *d);

/* One column of a series for each derivative, component by component. Returns 0, or -1 after a message. */
int derivatives_add_columns(const derivatives *d, const setup *s, series *rows);

/* z at the start of the motion: unit vectors, on constraints the nearest that these allow; for a parameter how the start that was
 * given, brought onto the constraints, changes with it. Errors of eom_project, after a message. */
eom_status derivatives_start(derivatives *d, const setup *s);

/* The derivatives in d->z, a line for each component. */
void derivatives_print(const derivatives *d, const setup *s);

#endif
