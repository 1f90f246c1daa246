/* Figures of a motion, by gnuplot. */
#ifndef PROGRAM_PLOT_H
#define PROGRAM_PLOT_H

#include "motion.h"

/* Coordinates, velocities and errors over time. Returns 0, or -1 after a message. */
int plot_motion(const motion *m, const char *path);

#endif
