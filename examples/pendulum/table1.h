/* The paper's Table 1 beside what its own scheme gives and beside the exponents. */
#ifndef PENDULUM_TABLE1_H
#define PENDULUM_TABLE1_H

#include "run.h"

enum { TABLE1_LINKS = 6 };

typedef struct table1_request {
  int links;           /* the table goes from N = 1 to this, at most TABLE1_LINKS */
  run_request each;    /* for every run; its links and its scheme apart */
  const char *csv;     /* the table as a file, null for none */
  const char *plot;    /* the maximal exponents as a figure, null for none */
  const char *figures; /* an existing folder for all figures and the rows of each run, null for none */
} table1_request;

/* Computes, prints, and writes. Returns an exit status. */
int table1(const table1_request *ask);

#endif
