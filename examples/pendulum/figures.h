/* The figures of the demonstration, after Figs 3, 4 and 5 of the paper. */
#ifndef PENDULUM_FIGURES_H
#define PENDULUM_FIGURES_H

#include "run.h"

enum { FIGURE_ROWS = 2 /* that a curve needs */ };

/* All write one .svg or .png file, and return 0, or -1 after a message. A run with fewer than two rows makes no curve; a figure
 * without any curve is left out, which a message says. */

/* Fig 3: the maximal exponent against time, one curve for each run. */
int figure_maximal(const char *path, const run *const *runs, int count);

/* Fig 4: every exponent of one run against time. */
int figure_spectrum(const char *path, const run *r);

/* Fig 5: energy error and orthogonality error against time, one curve for each run. */
int figure_errors(const char *path, const run *const *runs, int count);

#endif
