/* The folder of --figures: all figures, and the rows of every run. */
#ifndef PENDULUM_FOLDER_H
#define PENDULUM_FOLDER_H

#include "run.h"

/* Makes the folder where there is none, and sees that files can be made in it. Returns 0, or -1 after a message; then no new folder is
 * left behind. *made: whether there was none. */
int folder_make(const char *folder, bool *made);

/* Whether folder_write writes the file of that path, for pendulums of at most the given number of links. */
bool folder_writes(const char *folder, const char *path, int links);

/* Writes fig3.svg of the runs, fig4.svg of the last of them, fig5.svg of the runs and the printed-scheme runs (count of each; printed
 * may be null), N<links>.csv, and N<links>_as_printed.csv. Runs without a row are left out, and from the figures
 * those with fewer than two. Returns 0, or -1 after a message. */
int folder_write(const char *folder, const run *const *runs, const run *const *printed, int count);

#endif
