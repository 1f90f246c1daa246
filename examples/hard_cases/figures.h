/* The figures: time against error, and what keeps the constraints. */
#ifndef HARD_CASES_FIGURES_H
#define HARD_CASES_FIGURES_H

#include <stdbool.h>

/* Computes and draws all of them into a folder that is there; quick: the short forms, with few points. Returns an exit status. */
int draw_figures(const char *folder, bool quick);

#endif
