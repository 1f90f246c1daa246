/* The output files of a command, looked at before it computes. */
#include "files.h"

#include "host/gnuplot.h"
#include "host/message.h"

#include <stddef.h>
#include <string.h>

static void check_input(const wanted_file *f, const char *what, const char *input) {
  if (f->path != NULL && input != NULL && output_replaces(f->path, input))
    usage_error("%s %s would replace %s, which is read", f->option, f->path, what);
}

void files_distinct(wanted_files wanted, const setup *s) {
  const wanted_file *files = wanted.file;
  for (int i = 0; i < WANTED_FILES; i++) {
    check_input(&files[i], "the model", s->model.path);
    check_input(&files[i], "the file of --start", s->file);
  }
  for (int i = 0; i < WANTED_FILES; i++)
    for (int k = 0; k < i; k++)
      if (files[i].path != NULL && files[k].path != NULL && output_same(files[i].path, files[k].path))
        usage_error("%s %s and %s %s are the same file", files[k].option, files[k].path, files[i].option, files[i].path);
}

static int drawn(const wanted_file *f) {
  return f->path != NULL && (strcmp(f->option, "--plot") == 0 || strcmp(f->option, "--gif") == 0);
}

int files_possible(wanted_files wanted) {
  const wanted_file *files = wanted.file;
  for (int i = 0; i < WANTED_FILES; i++)
    if ((drawn(&files[i]) && find_gnuplot() != 0) || (files[i].path != NULL && output_check(files[i].path) != 0)) return -1;
  return 0;
}
