/* Rows of numbers over time, and what is made of them: CSV, NPZ and plots. */
#include "series.h"

#include "host/message.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static int no_memory(void) {
  complain("not enough memory for the rows; take fewer (a longer --every)");
  return -1;
}

int series_group_add(series *s, const char *name, int width) {
  const int columns = width > 0 ? width : 1;
  assert(s->groups < SERIES_MOST_GROUPS);
  char(*names)[64] = realloc(s->name, (size_t)(s->width + columns) * sizeof *names);
  if (names == NULL) return no_memory();
  s->name = names;
  series_group *g = &s->group[s->groups++];
  *g = (series_group){.first = s->width, .width = width};
  snprintf(g->name, sizeof g->name, "%s", name);
  for (int i = 0; i < columns; i++) {
    if (width > 0)
      snprintf(names[s->width + i], sizeof *names, "%s[%d]", name, i);
    else
      snprintf(names[s->width + i], sizeof *names, "%s", name);
  }
  s->width += columns;
  return 0;
}

double *series_row(series *s) {
  if (s->count == s->room) {
    const long room = s->room > 0 ? 2 * s->room : 256;
    double *rows = realloc(s->rows, (size_t)room * (size_t)s->width * sizeof *rows);
    if (rows == NULL) return no_memory(), NULL;
    s->rows = rows;
    s->room = room;
  }
  double *row = s->rows + s->count++ * s->width;
  memset(row, 0, (size_t)s->width * sizeof *row);
  return row;
}

void series_free(series *s) {
  free(s->name);
  free(s->rows);
  *s = (series){.groups = 0};
}

int series_csv(const series *s, const char *path) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  for (int i = 0; i < s->width; i++) fprintf(o.file, "%s%c", s->name[i], i + 1 < s->width ? ',' : '\n');
  for (long k = 0; k < s->count; k++) output_row(&o, s->rows + k * s->width, s->width);
  return output_commit(&o);
}

int series_npz(const series *s, npz *z) {
  for (int i = 0; i < s->groups; i++) {
    const series_group *g = &s->group[i];
    const long shape[] = {s->count, g->width};
    if (npz_add(z, g->name, s->rows + g->first, g->width > 0 ? 2 : 1, shape, s->width) != 0) return -1;
  }
  return 0;
}
