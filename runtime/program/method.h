/* How a motion is followed: the method, its tolerances or step, and how constraints are held, from options. */
#ifndef PROGRAM_METHOD_H
#define PROGRAM_METHOD_H

#include "eom/trajectory.h"
#include "host/options.h"
#include "setup.h"

enum { METHOD_OPTIONS = 6 };

typedef struct method {
  const char *name;        /* null: the first that there is */
  double rtol, atol, step; /* tolerances below zero: not given */
  bool free;               /* no projection */
  double baumgarte;        /* 1/s; 0: none */
  const eom_trajectory_method *found;
} method;

extern const method method_default;

/* Rows of a command's table, with what each means there. */
option method_name(const char **name, const char *help);
option method_rtol(double *rtol, const char *help);
option method_atol(double *atol, const char *help);
option method_step(double *step, const char *help);

/* Writes the rows of METHOD_OPTIONS options at table. */
void method_options(method *m, option *table);

/* The method of that name. Exits with EXIT_USAGE, after a message with the names that there are, where there is none. */
const eom_trajectory_method *method_find(const char *given_by, const char *name);

/* Of a fixed step, or 0, and tolerances, negative where they are not given: fills these in or refuses what does not fit together. Exits
 * with EXIT_USAGE then. */
void method_complete_tolerances(double step, double *rtol, double *atol);

/* Fills found, and refuses what does not fit together: exits with EXIT_USAGE. */
void method_complete(method *m);

/* Refuses a fixed step, s, that a time between t0 and t_end does not change by. 0: none. Returns 0, or -1 after a message. */
int method_check_step(double step, double t0, double t_end);

/* Options for the system and for the trajectory: SUNDIALS' methods want absolute tolerances above zero, so that rtol alone is refused.
 */
eom_options method_system_options(const method *m, unsigned needs);
eom_trajectory_options method_trajectory_options(const method *m, const setup *s);

/* The methods with a line about each, for a help text; static. */
const char *method_list(void);

#endif
