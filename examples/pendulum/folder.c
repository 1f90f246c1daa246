/* The folder of --figures: all figures, and the rows of every run. */
#include "folder.h"

#include "common/message.h"
#include "csv.h"
#include "figures.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

enum { PATH_SIZE = 4096, MOST_RUNS = 2 * PENDULUM_MAX_LINKS };

int folder_make(const char *folder) {
  struct stat info;
  if (mkdir(folder, 0777) == 0) return 0;
  if (errno == EEXIST && stat(folder, &info) == 0 && S_ISDIR(info.st_mode)) return 0;
  complain("cannot make the folder '%s': %s", folder, strerror(errno));
  return -1;
}

static int join(char *path, const char *folder, const char *name) {
  if (snprintf(path, PATH_SIZE, "%s/%s", folder, name) < PATH_SIZE) return 0;
  complain("cannot write into '%s': the name is too long", folder);
  return -1;
}

static int write_rows(const char *folder, const run *r) {
  char name[64], path[PATH_SIZE];
  output o;
  snprintf(name, sizeof name, "N%d%s.csv", r->ask.links, r->ask.scheme == EOM_LYAPUNOV_PAPER ? "_as_printed" : "");
  if (join(path, folder, name) != 0 || csv_begin(&o, path, r->ask.links) != 0) return -1;
  return csv_end(&o, r);
}

/* The runs that have rows. */
static int gather(const run **all, const run *const *runs, int count) {
  int kept = 0;
  for (int i = 0; i < count; i++)
    if (runs[i]->nrow > 0) all[kept++] = runs[i];
  return kept;
}

int folder_write(const char *folder, const run *const *runs, const run *const *printed, int count) {
  const run *all[MOST_RUNS];
  char path[PATH_SIZE];
  int main = gather(all, runs, count), both = main;
  if (printed != NULL) both += gather(all + main, printed, count);
  for (int i = 0; i < both; i++)
    if (write_rows(folder, all[i]) != 0) return -1;
  if (main == 0) return 0;
  if (join(path, folder, "fig3.svg") != 0 || figure_maximal(path, all, main) != 0) return -1;
  if (join(path, folder, "fig4.svg") != 0 || figure_spectrum(path, all[main - 1]) != 0) return -1;
  if (join(path, folder, "fig5.svg") != 0 || figure_errors(path, all, both) != 0) return -1;
  return 0;
}
