/* Plots through gnuplot: a script in, an SVG or PNG file out. */
#include "host/gnuplot.h"

#include "host/message.h"

#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NO_COMMAND = 127 }; /* what a shell exits with where there is no such command */

static bool ends_in(const char *path, const char *suffix) {
  size_t n = strlen(path), m = strlen(suffix);
  return n > m && strcmp(path + n - m, suffix) == 0;
}

void check_figure_name(const char *option, const char *path) {
  if (path != NULL && !ends_in(path, ".svg") && !ends_in(path, ".png"))
    usage_error("%s %s: the name must end in .svg or .png", option, path);
}

int find_gnuplot(void) {
  int status = system("gnuplot --version >/dev/null 2>&1");
  if (status == 0) return 0;
  complain("plots need gnuplot, which does not run here; install it (Debian: apt-get install gnuplot-nox) or leave the plots out");
  return -1;
}

int gnuplot_open(gnuplot *g, const char *path, int width, int height) {
  if (output_open(&g->figure, path) != 0) return -1;
  g->script = tmpfile();
  if (g->script == NULL) {
    complain("cannot make a temporary file for gnuplot: %s", strerror(errno));
    output_discard(&g->figure);
    return -1;
  }
  fputs("set encoding utf8\n", g->script);
  if (ends_in(path, ".png"))
    fprintf(g->script, "set terminal pngcairo size %d,%d noenhanced font 'DejaVu Sans,12' background 'white'\n", width, height);
  else if (ends_in(path, ".gif"))
    fprintf(g->script, "set terminal gif size %d,%d\n", width, height); /* what moves sets it anew */
  else
    fprintf(g->script, "set terminal svg size %d,%d noenhanced font 'DejaVu Sans,12' background 'white'\n", width, height);
  return 0;
}

static noreturn void become_gnuplot(int script, int figure, int messages) {
  if (dup2(script, STDIN_FILENO) >= 0 && dup2(figure, STDOUT_FILENO) >= 0 && (messages < 0 || dup2(messages, STDERR_FILENO) >= 0))
    execlp("gnuplot", "gnuplot", "-", (char *)NULL);
  _exit(NO_COMMAND);
}

static void copy(int from, FILE *to) {
  char block[1 << 14];
  ssize_t n;
  while ((n = read(from, block, sizeof block)) > 0) fwrite(block, 1, (size_t)n, to);
}

/* Exit status of gnuplot reading the script, its output copied to figure (gnuplot itself does not notice a full disk); -1 where it
 * could not be started or did not end by itself. Its messages count where it fails. */
static int run_with(FILE *script, FILE *figure, FILE *messages) {
  int ends[2], status;
  if (fflush(script) != 0 || lseek(fileno(script), 0, SEEK_SET) != 0 || pipe(ends) != 0) return -1;
  pid_t child = fork();
  if (child == 0) become_gnuplot(fileno(script), ends[1], messages != NULL ? fileno(messages) : -1);
  close(ends[1]);
  if (child > 0) copy(ends[0], figure);
  close(ends[0]);
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

static int run(FILE *script, FILE *figure) {
  FILE *messages = tmpfile();
  const int status = run_with(script, figure, messages);
  if (messages != NULL && status != 0 && lseek(fileno(messages), 0, SEEK_SET) == 0) copy(fileno(messages), stderr);
  if (messages != NULL) fclose(messages);
  return status;
}

int gnuplot_close(gnuplot *g) {
  int status = run(g->script, g->figure.file);
  fclose(g->script);
  if (status == 0) return output_commit(&g->figure);
  if (status == NO_COMMAND)
    find_gnuplot();
  else
    complain("gnuplot failed on '%s' (its message stands above)", g->figure.target);
  output_discard(&g->figure);
  return -1;
}
