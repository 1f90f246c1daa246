/* Tables of the folder of results, and curves of their rows. */
#include "report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_SIZE = 4096 };

table report_table(const char *folder, const char *name) {
  char path[PATH_SIZE];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return table_read(path);
}

report_curve report_points(const table *t, const report_key *keys, int nkey, const char *x, const char *y) {
  report_curve z = {.x = malloc(((size_t)t->rows + 1) * sizeof(double)), .y = malloc(((size_t)t->rows + 1) * sizeof(double))};
  const int cx = table_column(t, x), cy = table_column(t, y);
  for (int row = 0; row < t->rows && z.x != NULL && z.y != NULL; row++) {
    bool fits = true;
    for (int k = 0; k < nkey; k++) fits = fits && strcmp(table_cell(t, row, keys[k].column), keys[k].value) == 0;
    if (!fits) continue;
    z.x[z.count] = table_number(t, row, cx);
    z.y[z.count++] = table_number(t, row, cy);
  }
  return z;
}

void report_free(report_curve *c) {
  free(c->x);
  free(c->y);
  *c = (report_curve){NULL, NULL, 0};
}
