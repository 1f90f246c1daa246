/* The folder of --figures: all figures, and the rows of every run. */
#include "folder.h"

#include "csv.h"
#include "figures.h"
#include "host/message.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_SIZE = 4096, NAME_SIZE = 64, MOST_RUNS = 2 * PENDULUM_MAX_LINKS };

static const char *const figure_names[] = {"fig3.svg", "fig4.svg", "fig5.svg"};
enum { FIGURES = sizeof figure_names / sizeof figure_names[0] };

static int join(char *path, const char *folder, const char *name) {
  if (snprintf(path, PATH_SIZE, "%s/%s", folder, name) < PATH_SIZE) return 0;
  complain("cannot write into '%s': the name is too long", folder);
  return -1;
}

int folder_make(const char *folder, bool *made) {
  struct stat info;
  char path[PATH_SIZE];
  *made = mkdir(folder, 0777) == 0;
  if (!*made && !(errno == EEXIST && stat(folder, &info) == 0 && S_ISDIR(info.st_mode))) {
    complain("cannot make the folder '%s': %s", folder, strerror(errno));
    return -1;
  }
  if (join(path, folder, figure_names[0]) == 0 && output_check(path) == 0) return 0;
  if (*made) rmdir(folder);
  return -1;
}

static void name_rows(char *name, int links, eom_lyapunov_scheme scheme) {
  snprintf(name, NAME_SIZE, "N%d%s.csv", links, scheme == EOM_LYAPUNOV_PAPER ? "_as_printed" : "");
}

static bool is_inside(const char *folder, const char *name, const char *path) {
  char inside[PATH_SIZE];
  return snprintf(inside, sizeof inside, "%s/%s", folder, name) < PATH_SIZE && output_same(inside, path);
}

/* The path of a folder that is not there yet resolves to nothing: it is compared as it is written, but for slashes at its end. */
bool folder_writes(const char *folder, const char *path, int links) {
  char name[NAME_SIZE], plain[PATH_SIZE];
  size_t length = strlen(folder);
  while (length > 1 && folder[length - 1] == '/') length--;
  snprintf(plain, sizeof plain, "%.*s", (int)length, folder);
  for (int i = 0; i < FIGURES; i++)
    if (is_inside(plain, figure_names[i], path)) return true;
  for (int n = 1; n <= links; n++) {
    name_rows(name, n, EOM_LYAPUNOV_DISCRETE);
    if (is_inside(plain, name, path)) return true;
    name_rows(name, n, EOM_LYAPUNOV_PAPER);
    if (is_inside(plain, name, path)) return true;
  }
  return false;
}

static int write_rows(const char *folder, const run *r) {
  char name[NAME_SIZE], path[PATH_SIZE];
  output o;
  name_rows(name, r->ask.links, r->ask.scheme);
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
  if (join(path, folder, figure_names[0]) != 0 || figure_maximal(path, all, main) != 0) return -1;
  if (join(path, folder, figure_names[1]) != 0 || figure_spectrum(path, all[main - 1]) != 0) return -1;
  if (join(path, folder, figure_names[2]) != 0 || figure_errors(path, all, both) != 0) return -1;
  return 0;
}
