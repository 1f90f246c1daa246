/* Curves of time against error: read from the timers' rows, and compared at one error. */
#ifndef PRECISION_WORK_H
#define PRECISION_WORK_H

#include "table.h"

#include <stdbool.h>

enum { WORK_MOST_POINTS = 64, WORK_MOST_CURVES = 64 };

/* One method of one contender on one scene, in the order of its settings. */
typedef struct work_curve {
  const char *contender, *method;
  int count;
  double error[WORK_MOST_POINTS], cpu[WORK_MOST_POINTS], energy[WORK_MOST_POINTS]; /* at the end; s; J */
} work_curve;

/* Adds the scene's curves of a table; its text must live as long. Returns the new count of curves, at most WORK_MOST_CURVES. */
int work_read(work_curve *curves, int count, const table *t, const char *scene);

/* The time in which the curve reaches an error, s: that of a point that is at least as exact, or between two points by interpolation of
 * the logarithms. NaN where it does not get there. */
double work_time(const work_curve *c, double error);

/* The fastest of the contender's curves at an error, -1 where none gets there. */
int work_fastest(const work_curve *curves, int count, bool (*of)(const char *contender), double error);

#endif
