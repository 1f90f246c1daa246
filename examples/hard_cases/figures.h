/* The figures: time against error, and what keeps the constraints. */
#ifndef HARD_CASES_FIGURES_H
#define HARD_CASES_FIGURES_H

/* Computes and draws all of them into a folder that is there. Returns an exit status. */
int draw_figures(const char *folder);

#endif
