/* Plots through gnuplot: a script in, an SVG or PNG file out. */
#ifndef HOST_GNUPLOT_H
#define HOST_GNUPLOT_H

#include "host/output.h"

typedef struct gnuplot {
  FILE *script;  /* the driver prints commands and data here */
  output figure; /* the file that becomes the figure */
} gnuplot;

/* Exits with EXIT_USAGE where a path ends in neither .svg nor .png. */
void check_figure_name(const char *option, const char *path);

/* Returns 0, or -1 after a message that says how to get gnuplot where the machine has none. */
int find_gnuplot(void);

/* Starts a figure of width by height (in pixels of a PNG): the terminal is set, the rest of the script is the driver's. Returns 0, or
 * -1 after a message. */
int gnuplot_open(gnuplot *g, const char *path, int width, int height);

/* Runs the script and puts the figure in place. Returns 0, or -1 after a message; then no figure is left behind. */
int gnuplot_close(gnuplot *g);

#endif
