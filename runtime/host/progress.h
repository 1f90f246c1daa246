/* One line of progress with the time left, on a terminal only. */
#ifndef HOST_PROGRESS_H
#define HOST_PROGRESS_H

#include <stdbool.h>

typedef struct progress {
  bool shown;         /* standard error is a terminal */
  double start, last; /* monotonic time of the start and of the last line, s */
} progress;

void progress_start(progress *p);

/* Shows what is done, 0 <= fraction <= 1, with a label in front; at most a few times a second. */
void progress_show(progress *p, const char *label, double fraction);

/* Removes the line. Returns the time since the start, s. */
double progress_end(progress *p);

#endif
