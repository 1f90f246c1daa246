/* Output files that are there whole or not at all. */
#ifndef HOST_OUTPUT_H
#define HOST_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

/* A file being written: a temporary beside the target, renamed to it at the end. A target that is no plain file (a pipe, /dev/stdout)
 * is written to directly. */
typedef struct output {
  FILE *file;
  const char *target; /* as the user wrote it */
  char *final;        /* where it points to: the file to replace; null where it is written to directly */
  char *temporary;    /* null likewise */
} output;

/* Each of these returns 0, or -1 after a message that names the target and the cause. After -1 nothing of the output is left behind
 * and the output is closed. */
int output_open(output *o, const char *target);
int output_flush(output *o);  /* hands what was printed to the system, so that a full disk shows at once */
int output_commit(output *o); /* closes the file and puts it in place */

/* Whether a file can be made there, found out before there is anything to write. Changes nothing. Returns 0, or -1 after a message. */
int output_check(const char *target);

/* Whether two paths, of files that need not be there yet, lead to the same file. */
bool output_same(const char *a, const char *b);

/* Whether writing the target would destroy a plain file that is read. */
bool output_replaces(const char *target, const char *input);

/* Prints a number with as many digits as give the same double again, and a line of such numbers with commas between them. */
void output_number(output *o, double x);
void output_row(output *o, const double *row, int width);

/* Closes and removes the temporary. Does nothing to an output that is closed. */
void output_discard(output *o);

#endif
