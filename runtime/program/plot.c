/* Figures of a motion, by gnuplot. */
#include "plot.h"

#include "host/gnuplot.h"
#include "host/message.h"

#include <math.h>

enum { MOST_CURVES = 12, MOST_POINTS = 4000 };

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
static void print_panel(FILE *script, const series *r, const char *label, int first, int count) {
  fprintf(script, "set ylabel '%s'\n", label);
  for (int i = 0; i < count && i < MOST_CURVES; i++)
    fprintf(script, "%s$rows using 1:%d with lines linewidth 1.6 linecolor '%s' title '%s'", i == 0 ? "plot " : ", ", first + i + 1,
            colours[i % COLOURS], r->name[first + i]);
  fputc('\n', script);
}

int plot_motion(const motion *m, const char *path) {
  const setup *s = m->ask.s;
  const series *r = &m->rows;
  const int columns = m->ask.columns != NULL ? m->ask.columns->count : 0, panels = columns > 0 ? 4 : 3;
  gnuplot g;
  if (r->count < 2) {
    complain("'%s' is left out: a curve needs two rows", path);
    return 0;
  }
  if (gnuplot_open(&g, path, 900, 240 * panels + 40) != 0) return -1;
  print_data(g.script, m);
  fprintf(g.script,
          "set grid back linecolor '#d0d0d0' linewidth 0.5\nset border 3 back\nset tics nomirror out\n"
          "set key outside right center samplen 2\nset lmargin 12\nset rmargin 18\nset multiplot layout %d,1 title 'Motion of %s'\n"
          "set xrange [%.10g:%.10g]\n",
          panels, s->model.description->model->name, fmin(s->t0, m->t), fmax(s->t0, m->t));
  print_panel(g.script, r, "coordinates", 1, s->n);
  print_panel(g.script, r, "velocities", 1 + s->n, s->n);
  if (columns > 0) print_panel(g.script, r, "columns", r->width - columns, columns);
  fputs("set xlabel 'time t, s'\nset logscale y\nset format y '%.0e'\n", g.script);
  if (m->energy_change <= zero_mark && m->phi <= zero_mark && m->phi_dot <= zero_mark)
    fprintf(g.script, "set yrange [%g:1e-6]\n", zero_mark);
  print_panel(g.script, r, "errors", 2 + 2 * s->n, s->sys->m > 0 ? 3 : 1);
  fputs("unset multiplot\n", g.script);
  return gnuplot_close(&g);
}
