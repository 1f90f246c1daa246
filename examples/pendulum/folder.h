/* The folder of --figures: all figures, and the rows of every run. */
#ifndef PENDULUM_FOLDER_H
#define PENDULUM_FOLDER_H

#include "run.h"

/* Makes the folder where there is none. Returns 0, or -1 after a message. */
int folder_make(const char *folder);

/* Writes fig3.svg of the runs, fig4.svg of the last of them, fig5.svg of the runs and the printed-scheme runs (count of each; printed
 * may be null), N<links>.csv, and N<links>_as_printed.csv. Runs without a row are left out. Returns 0, or -1 after a message. */
int folder_write(const char *folder, const run *const *runs, const run *const *printed, int count);

#endif
