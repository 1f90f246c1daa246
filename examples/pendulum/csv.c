/* The rows of a run as comma-separated values. */
#include "csv.h"

int csv_begin(output *o, const char *path, int links) {
  if (output_open(o, path) != 0) return -1;
  fputs("t", o->file);
  static const char *const columns[] = {"lambda", "mean", "half_width"};
  for (int k = 0; k < 3; k++)
    for (int i = 1; i <= 2 * links; i++) fprintf(o->file, ",%s_%d", columns[k], i);
  fputs(",energy_error,orthogonality_error\n", o->file);
  return output_flush(o);
}

int csv_end(output *o, const run *r) {
  int width = run_width(r);
  for (long k = 0; k < r->nrow; k++) output_row(o, r->rows + k * width, width);
  return output_commit(o);
}
