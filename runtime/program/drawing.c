/* What is drawn of a mechanism: lines through points in the plane, which formulas of its state give. */
#include "drawing.h"

#include "host/message.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char drawing_help[] =
    "A line goes through points \"X, Y\" with semicolons between them. X and Y are formulas of q[i], qd[i], t and parameters; x\n"
    "and y in them are the point before. \"k<N: X, Y\" stands for N points with k = 0, 1, .. Lines in the --start file:\n"
    "  line = 0, 0; k<n: x + length[k]*sin(q[k]), y - length[k]*cos(q[k])     # a pendulum of n links\n"
    "  line = q[0]-0.2, 0; q[0]+0.2, 0                                        # a cart on a track\n";

static int refused(const char *text, const char *why) {
  complain("line = %s: %s", text, why);
  return -1;
}

/* One formula of a stop. */
static formula *part(const setup *s, const char *line, const char *text) {
  char error[512];
  formula *f = formula_parse(text, FORMULA_DRAWING, &s->model, error, sizeof error);
  if (f == NULL) refused(line, error);
  return f;
}

/* The comma between X and Y: the first one outside of parentheses. */
static char *comma(char *text) {
  for (int depth = 0; *text != '\0'; text++) {
    depth += (*text == '(') - (*text == ')');
    if (*text == ',' && depth == 0) return text;
  }
  return NULL;
}

static int read_stop(const setup *s, drawing_stop *stop, const char *line, char *text) {
  char *colon = strchr(text, ':'), *less = strchr(text, '<');
  if (colon != NULL) {
    *colon = '\0';
    if (less == NULL || less > colon || text[strspn(text, " k")] != '<') return refused(line, "before a colon k<N is wanted");
    if ((stop->count = part(s, line, less + 1)) == NULL) return -1;
    text = colon + 1;
  }
  char *middle = comma(text);
  if (middle == NULL) return refused(line, "a point is two formulas with a comma between them: X, Y");
  *middle = '\0';
  stop->x = part(s, line, text);
  stop->y = stop->x != NULL ? part(s, line, middle + 1) : NULL;
  return stop->y != NULL ? 0 : -1;
}

static int add_line(drawing *d, const setup *s, const char *text) {
  char copy[4096];
  if (d->lines == SETUP_MOST_LINES) return refused(text, "too many lines");
  if (strlen(text) >= sizeof copy) return refused("..", "it is too long");
  strcpy(copy, text);
  drawing_line *line = &d->line[d->lines++];
  for (char *at = copy; at != NULL;) {
    char *next = strchr(at, ';');
    if (next != NULL) *next++ = '\0';
    if (line->stops == DRAWING_MOST_STOPS) return refused(text, "it has too many points");
    if (read_stop(s, &line->stop[line->stops++], text, at) != 0) return -1;
    at = next;
  }
  return 0;
}

/* Every point must be a number at the start: a wrong index shows at once. */
static int check_line(const drawing *d, const setup *s, int i, const char *text) {
  static double xy[2 * DRAWING_MOST_POINTS];
  const int count = drawing_points(&d->line[i], s, s->t0, s->q, xy);
  if (count == 0) return refused(text, "no points: the N of k<N is not a number from 1 to 4096");
  for (int j = 0; j < 2 * count; j++)
    if (!isfinite(xy[j])) return refused(text, "a point is not a number at the start; an index may be too large");
  return 0;
}

static int add_all(drawing *d, const setup *s, const option_texts *more) {
  for (int i = 0; i < s->lines; i++)
    if (add_line(d, s, s->line[i]) != 0 || check_line(d, s, d->lines - 1, s->line[i]) != 0) return -1;
  for (int i = 0; i < more->count; i++)
    if (add_line(d, s, more->text[i]) != 0 || check_line(d, s, d->lines - 1, more->text[i]) != 0) return -1;
  if (d->lines > 0) return 0;
  complain("no line says what to draw (see --help): %s over q[0] is drawn", s->n > 1 ? "q[1]" : "qd[0]");
  return add_line(d, s, s->n > 1 ? "q[0], q[1]" : "q[0], qd[0]");
}

int drawing_open(drawing *d, const setup *s, const option_texts *more) {
  *d = (drawing){.lines = 0};
  if (add_all(d, s, more) == 0) return 0;
  drawing_close(d);
  return -1;
}

void drawing_close(drawing *d) {
  for (int i = 0; i < d->lines; i++)
    for (int j = 0; j < d->line[i].stops; j++) {
      formula_free(d->line[i].stop[j].count);
      formula_free(d->line[i].stop[j].x);
      formula_free(d->line[i].stop[j].y);
    }
  d->lines = 0;
}

int drawing_points(const drawing_line *line, const setup *s, double t, const double *y, double *xy) {
  formula_point at = {.m = &s->model, .n = s->n, .q = y, .qd = y + s->n, .t = t};
  int points = 0;
  for (int i = 0; i < line->stops; i++) {
    const drawing_stop *stop = &line->stop[i];
    const double count = stop->count != NULL ? formula_value(stop->count, &at) : 1.0;
    if (!(count >= 0.0 && points + count <= (double)DRAWING_MOST_POINTS)) return 0;
    for (at.k = 0.0; at.k < count; at.k += 1.0) {
      const double px = formula_value(stop->x, &at), py = formula_value(stop->y, &at);
      xy[2 * points] = at.x = px;
      xy[2 * points + 1] = at.y = py;
      points++;
    }
    at.k = 0.0;
  }
  return points;
}
