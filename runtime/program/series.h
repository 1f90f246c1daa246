/* Rows of numbers over time, and what is made of them: CSV, NPZ and plots. */
#ifndef PROGRAM_SERIES_H
#define PROGRAM_SERIES_H

#include "host/npz.h"

enum { SERIES_MOST_GROUPS = 80 }; /* what every motion has, and OPTION_MOST_TEXTS columns of the user's own */

/* Columns that belong together: one array of the NPZ file. */
typedef struct series_group {
  char name[32];
  int first, width; /* width 0: one number a row; otherwise a vector */
} series_group;

typedef struct series {
  series_group group[SERIES_MOST_GROUPS];
  int groups;
  int width;
  char (*name)[64]; /* of each column */
  double *rows;
  long count, room;
} series;

/* Adds columns before the first row: width 0 for one column of the group's name, else `width` ones named by the caller in s->name.
 * Returns 0, or -1 after a message. */
int series_group_add(series *s, const char *name, int width);

/* A new row of zeros at the end; null after a message where there is no memory. */
double *series_row(series *s);
void series_free(series *s);

/* Each returns 0, or -1 after a message. */
int series_csv(const series *s, const char *path);
int series_npz(const series *s, npz *z);

#endif
