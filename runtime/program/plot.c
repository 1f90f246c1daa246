/* Figures of a motion, by gnuplot. */
#include "plot.h"

#include "host/gnuplot.h"
#include "host/message.h"

#include <math.h>
#include <string.h>

enum { MOST_CURVES = 12, MOST_POINTS = 4000 };

/* The names of curves beside a panel: so many below each other, and the width of a line and the gaps around it, in characters. */
enum { NAMES_HIGH = 6, LINE_WIDTH = 6, CHARACTER = 8 /* pixels */ };

static const char *const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7f7f7f"};
enum { COLOURS = sizeof colours / sizeof colours[0] };

/* Stands for an error of zero on a logarithmic axis: less than any rounding error here. */
static const double zero_mark = 1e-18;

/* A number on the axis of errors: without a logarithm none, but where there is nothing else. */
static double error_mark(const motion *m, double x) {
  const bool nothing = m->energy_change <= zero_mark && m->phi <= zero_mark && m->phi_dot <= zero_mark;
  return x != 0.0 ? fabs(x) : nothing ? zero_mark : (double)NAN;
}

/* Some of the rows, the last one among them. */
static void print_data(FILE *script, const motion *m) {
  const series *r = &m->rows;
  const long stride = 1 + r->count / MOST_POINTS;
  const int first = 2 + 2 * m->ask.s->n, behind = first + (m->ask.s->sys->m > 0 ? 3 : 1);
  fputs("$rows << EOD\n", script);
  for (long k = 0; k < r->count; k++) {
    const double *row = r->rows + k * r->width;
    if (k % stride != 0 && k + 1 < r->count) continue;
    for (int i = 0; i < r->width; i++) fprintf(script, "%.9g ", i >= first && i < behind ? error_mark(m, row[i]) : row[i]);
    fputc('\n', script);
  }
  fputs("EOD\n", script);
}

/* Columns first..first+count-1 against time; of many the first ones. */
typedef struct panel {
  const char *label;
  int first, count;
} panel;

static int curves(const panel *p) { return p->count < MOST_CURVES ? p->count : MOST_CURVES; }

/* What the names of a panel's curves take beside it, in characters. */
static int names_width(const series *r, const panel *p) {
  size_t longest = 0;
  for (int i = 0; i < curves(p); i++)
    if (strlen(r->name[p->first + i]) > longest) longest = strlen(r->name[p->first + i]);
  return ((int)longest + LINE_WIDTH) * ((curves(p) + NAMES_HIGH - 1) / NAMES_HIGH);
}

/* Where colours come again lines are broken. */
static void print_panel(FILE *script, const series *r, const panel *p) {
  fprintf(script, "set ylabel '%s'\n", p->label);
  for (int i = 0; i < curves(p); i++)
    fprintf(script, "%s$rows using 1:%d with lines linewidth 1.6 dashtype %d linecolor '%s' title '%s'", i == 0 ? "plot " : ", ",
            p->first + i + 1, 1 + i / COLOURS, colours[i % COLOURS], r->name[p->first + i]);
  fputc('\n', script);
}

int plot_motion(const motion *m, const char *path) {
  const setup *s = m->ask.s;
  const series *r = &m->rows;
  const int columns = m->ask.columns != NULL ? m->ask.columns->count : 0;
  const panel state[] = {{"coordinates", 1, s->n}, {"velocities", 1 + s->n, s->n}, {"columns", r->width - columns, columns}};
  const panel errors = {"errors", 2 + 2 * s->n, s->sys->m > 0 ? 3 : 1};
  const int states = columns > 0 ? 3 : 2;
  int names = names_width(r, &errors);
  for (int i = 0; i < states; i++)
    if (names_width(r, &state[i]) > names) names = names_width(r, &state[i]);
  gnuplot g;
  if (r->count < 2) {
    complain("'%s' is left out: a curve needs two rows", path);
    return 0;
  }
  if (gnuplot_open(&g, path, 750 + CHARACTER * names, 240 * (states + 1) + 40) != 0) return -1;
  print_data(g.script, m);
  fprintf(g.script,
          "set grid back linecolor '#d0d0d0' linewidth 0.5\nset border 3 back\nset tics nomirror out\n"
          "set key outside right center samplen 2 maxrows %d\nset lmargin 12\nset rmargin %d\n"
          "set multiplot layout %d,1 title 'Motion of %s'\nset xrange [%.10g:%.10g]\n",
          NAMES_HIGH, names, states + 1, s->model.description->model->name, fmin(s->t0, m->t), fmax(s->t0, m->t));
  for (int i = 0; i < states; i++) print_panel(g.script, r, &state[i]);
  fputs("set xlabel 'time t, s'\nset logscale y\nset format y '%.0e'\n", g.script);
  if (m->energy_change <= zero_mark && m->phi <= zero_mark && m->phi_dot <= zero_mark)
    fprintf(g.script, "set yrange [%g:1e-6]\n", zero_mark);
  print_panel(g.script, r, &errors);
  fputs("unset multiplot\n", g.script);
  return gnuplot_close(&g);
}
