/* One line of progress with the time left, on a terminal only. */
#include "host/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const double interval = 0.2; /* between two lines, s: often enough to see it move */

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void progress_start(progress *p) {
  p->shown = isatty(STDERR_FILENO) == 1;
  p->start = now();
  p->last = p->start;
}

void progress_show(progress *p, const char *label, double fraction) {
  double time = now(), elapsed = time - p->start;
  if (!p->shown || time - p->last < interval) return;
  p->last = time;
  fprintf(stderr, "\r%s %5.1f %%", label, 100.0 * fraction);
  if (fraction > 0.0) fprintf(stderr, ", %.0f s left", elapsed * (1.0 - fraction) / fraction);
  fputs("\033[K", stderr);
}

double progress_end(progress *p) {
  if (p->shown) fputs("\r\033[K", stderr);
  return now() - p->start;
}
