/* What the parts of the page share: tables of the folder of results, curves of their rows, sections. */
#ifndef PRECISION_REPORT_H
#define PRECISION_REPORT_H

#include "host/page.h"
#include "table.h"

/* A file of the folder of results; without rows where there is none. To be freed. */
table report_table(const char *folder, const char *name);

/* The points of rows, count each, to be freed by report_free. */
typedef struct report_curve {
  double *x, *y;
  int count;
} report_curve;

/* Rows that have this text in this column. */
typedef struct report_key {
  int column;
  const char *value;
} report_key;

/* Two columns of the rows that have all keys, in their order. */
report_curve report_points(const table *t, const report_key *keys, int nkey, const char *x, const char *y);
void report_free(report_curve *c);

/* Sections of the page; nothing where the folder has no rows of theirs. */
void report_sensitivity(page *p, const char *folder);
void report_cost(page *p, const char *folder);
void report_lyapunov(page *p, const char *folder);

#endif
