/* A Lyapunov run on disk: its terms, the rows of its history and its image (eom/lyapunov.h).
 *
 * Terms are all that the bits of a run depend on, as lines "name = value": the model, its parameters, the start, options. */
#ifndef PROGRAM_CHECKPOINT_H
#define PROGRAM_CHECKPOINT_H

#include "eom/lyapunov.h"
#include "series.h"

/* Puts the file in place whole, or leaves the one that is there. Returns 0, or -1 after a message. */
int checkpoint_write(const char *path, const char *terms, const eom_lyapunov *ly, const series *rows);

/* Whether the file is there; exits with EXIT_USAGE, after a message, where it is no checkpoint and so not to be replaced. */
bool checkpoint_there(const char *path);

/* The terms in the file, to be freed; null where there is no file. Returns 0, or -1 after a message. */
int checkpoint_terms(const char *path, char **terms);

/* The number that the term of that name has; 0 where terms is null or has no such line. */
double checkpoint_term(const char *terms, const char *name);

/* Takes the run and its rows from the file; where there is none, both stay as they are: a run begins. Returns 0, or -1 after a message
 * that names the term that differs. */
int checkpoint_read(const char *path, const char *terms, eom_lyapunov *ly, series *rows);

#endif
