/* What is drawn of a mechanism: lines through points in the plane, which formulas of its state give. */
#ifndef PROGRAM_DRAWING_H
#define PROGRAM_DRAWING_H

#include "formula.h"
#include "setup.h"

enum { DRAWING_MOST_STOPS = 32, DRAWING_MOST_POINTS = 4096 };

/* How lines are written, for a help text. */
extern const char drawing_help[];

/* "X, Y" or "k<N: X, Y": one point, or N with k = 0, 1, .. */
typedef struct drawing_stop {
  formula *count, *x, *y; /* count null: one */
} drawing_stop;

typedef struct drawing_line {
  drawing_stop stop[DRAWING_MOST_STOPS];
  int stops;
} drawing_line;

typedef struct drawing {
  drawing_line line[SETUP_MOST_LINES];
  int lines;
} drawing;

/* The lines of the start file and those of the options; where there are none q[1] over q[0], or qd[0] over q[0]. Returns 0, or -1 after
 * a message. */
int drawing_open(drawing *d, const setup *s, const option_texts *more);
void drawing_close(drawing *d);

/* The points of one line at a state: xy, x and y in turn, DRAWING_MOST_POINTS of them. Returns how many there are. */
int drawing_points(const drawing_line *line, const setup *s, double t, const double *y, double *xy);

#endif
