/* Programs that are checked in one process each, one after the other; a batch's file lists them. */
#ifndef FUZZ_BATCH_H
#define FUZZ_BATCH_H

typedef struct fuzz_program {
  int (*run)(int argc, char **argv);     /* the main of the program's test, under a name of its own */
  int (*rounded)(int argc, char **argv); /* the same in double: see rounding.h */
  char *name, *params;                   /* its arguments; params is the text of the parameters, empty where there are none */
} fuzz_program;

/* Runs each in a child with a limit of time. A line "PROGRAM FAULT .." for those that do not end well. Always 0. */
int fuzz_batch(const fuzz_program *programs, int count);

#endif
