/* What a test program is told: parameters and points, as text on the command line or in a file. */
#ifndef TLGEN_SELFTEST_INPUT_H
#define TLGEN_SELFTEST_INPUT_H

#include "tlgen/selftest.h"

typedef struct input {
  const tlgen_selftest *test;
  char **texts; /* of all --params and --point and of the lines of files, as "params .." and "point .." */
  int ntexts;
  int asked;                  /* how many of them are points */
  void *params, *quad_params; /* null where the model has none */
  int n;                      /* coordinates */
  double **points;            /* 2n+1 numbers each: q, qd, t */
  int npoints;
} input;

/* Adds a text behind the word "params" or "point". */
void input_add(input *in, const char *word, const char *text);

/* Adds the lines of a file; # begins a comment. False, with a message on stderr, where it cannot be read or a line begins otherwise. */
int input_read(input *in, const char *path);

/* Makes params and points of the texts. False, with a message on stderr that names what is missing, unknown, or no number. */
int input_resolve(input *in);

/* An example of the options that this model wants, on stderr. */
void input_example(const tlgen_selftest *test);

/* count zeros of that size; ends the program where there is no memory. */
void *input_memory(size_t count, size_t size);

void input_free(input *in);

#endif
