/* What is printed: the list of scenes, and the tables of runs. */
#ifndef HARD_CASES_REPORT_H
#define HARD_CASES_REPORT_H

#include "run.h"

void print_list(void);

/* A table of runs on standard output: its head, then a row for each. */
void print_head(bool markdown);
void print_run(const run *r, bool markdown);

/* Why a run did not get to its end, on standard error. */
void explain(const run *r);

/* Writes the run's outputs to FOLDER/NAME.csv. Returns 0, or -1 after a message. */
int write_rows(const char *folder, const run *r);

#endif
