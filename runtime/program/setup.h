/* What every subcommand begins with: a model, its parameters and a start, from a text file and options. */
#ifndef PROGRAM_SETUP_H
#define PROGRAM_SETUP_H

#include "eom/project.h"
#include "eom/system.h"
#include "host/options.h"
#include "model.h"

enum { SETUP_OPTIONS = 6, SETUP_MOST_LINES = 16 };

/* How the text file and the options are written, for the help of each subcommand. */
extern const char setup_help[];

typedef struct setup {
  model model;
  int n;
  double t0;                    /* s */
  double *q, *qd;               /* n each, one behind the other: y = (q,qd) */
  double *given;                /* 2n: y before it was brought onto the constraints; null: it is as it was given */
  unsigned char *keep;          /* 2n flags: what stays as it is where a state is made consistent or moved to an equilibrium */
  bool any_kept[2];             /* of q, of qd */
  char *line[SETUP_MOST_LINES]; /* what "line =" says (see drawing.h) */
  int lines;
  eom_system *sys;
  bool any_size; /* given: parameters that leave no coordinates are no error; then n = 0, and there is no system and no state */
  /* as given */
  const char *file, *q_text, *qd_text, *t0_text, *keep_text;
  option_texts set;
} setup;

/* Rows of a command's table that follows a motion, with their help. */
option setup_t_end(double *t_end, const char *help);
option setup_every(double *every, const char *help);

/* Writes the rows of SETUP_OPTIONS options at table. */
void setup_options(setup *s, option *table);

/* Reads the command line of a subcommand: its model, the first operand, into s->model.path, then the options of the table (see
 * read_options). Exits with EXIT_USAGE, after a message, where there is no model. */
void setup_read(setup *s, int argc, char **argv, const option *table, int count, const manual *text);

/* Opens the model, reads the values and starts a system. Returns 0, or -1 after a message; then there is nothing to close. */
int setup_load(setup *s, const char *path, const eom_options *options);
void setup_close(setup *s);

/* The parameter of that name, which may be that of an element, "mass[1]": then *i is its index, else -1. Null where there is none. */
const eom_parameter *setup_parameter(const setup *s, const char *name, int *i);

/* How the start is brought onto the constraints: what stays as it is. */
eom_projection setup_projection(const setup *s);

/* Brings the start onto the constraints and prints what changed; prints nothing where there are none. Returns 0, or -1 after a message.
 */
int setup_consistent(setup *s);

/* Whether time itself occurs in the motion: the accelerations or the energy of the start are others at another time. */
bool setup_driven(const setup *s);

/* Prints the model, its parameters and the start in a few lines; which parameters were not given. */
void setup_print(const setup *s);

/* Says in one message what failed and at which of the user's functions. */
void complain_status(const eom_system *sys, eom_status status, const char *what);

/* The name of component i of y = (q,qd), of a coordinate's own name where it has one. Valid until the next call but three. */
const char *component_name(const setup *s, int i);

/* The component of y with that name, by index or by the coordinate's own name; -1 for none. Only where n is known. */
int component_named(const setup *s, const char *name);

#endif
