/* The figures of the demonstration, after Figs 3, 4 and 5 of the paper. */
#include "figures.h"

#include "common/gnuplot.h"

enum { MOST_POINTS = 800 /* of one curve: more cannot be told apart in a figure */ };

/* One colour for each run; chosen to be told apart by colour-blind readers too. */
static const char *const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
enum { COLOURS = sizeof colours / sizeof colours[0] };

/* The columns of a row by their place in the script's data. */
static int energy_column(const run *r) { return run_width(r) - 1; }
static int orthogonality_column(const run *r) { return run_width(r); }

static bool in_script(const run *r, long k) {
  long stride = 1 + r->nrow / MOST_POINTS;
  return k % stride == 0 || k == r->nrow - 1;
}

static void print_data(FILE *script, const run *r, int number) {
  int width = run_width(r);
  fprintf(script, "$run%d << EOD\n", number);
  for (long k = 0; k < r->nrow; k++) {
    if (!in_script(r, k)) continue;
    for (int i = 0; i < width; i++) fprintf(script, i == 0 ? "%.8g" : " %.6g", r->rows[k * width + i]);
    fputc('\n', script);
  }
  fputs("EOD\n", script);
}

static void print_style(FILE *script) {
  fputs("set grid back linecolor '#d0d0d0' linewidth 0.5\n"
        "set border 3 back\n"
        "set tics nomirror out\n"
        "set key outside right center noenhanced samplen 2\n",
        script);
}

static void print_time_axis(FILE *script, const run *r) {
  fprintf(script, "set logscale x\nset xrange [%g:%g]\nset format x '%%g'\nset xlabel 'time t, s'\n", r->rows[0], r->ask.t_end);
}

static const char *scheme_mark(const run *r) { return r->ask.scheme == EOM_LYAPUNOV_PAPER ? " dashtype '.-'" : ""; }

/* One curve: a column of a run against time. */
static void print_curve(FILE *script, const run *r, int number, int column) {
  fprintf(script, "%s$run%d using 1:%d with lines linecolor '%s' linewidth 1.6%s title 'N = %d%s'", number == 0 ? "plot " : ", ",
          number, column, colours[(r->ask.links - 1) % COLOURS], scheme_mark(r), r->ask.links,
          r->ask.scheme == EOM_LYAPUNOV_PAPER ? ", as printed" : "");
}

int figure_maximal(const char *path, const run *const *runs, int count) {
  gnuplot g;
  if (gnuplot_open(&g, path, 900, 540) != 0) return -1;
  for (int i = 0; i < count; i++) print_data(g.script, runs[i], i);
  print_style(g.script);
  print_time_axis(g.script, runs[0]);
  fputs("set title 'Maximal Lyapunov exponent of the planar N-pendulum'\nset ylabel '{/Symbol l}_1(t), 1/s'\n", g.script);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, 2);
  fputc('\n', g.script);
  return gnuplot_close(&g);
}

int figure_spectrum(const char *path, const run *r) {
  gnuplot g;
  int exponents = 2 * r->ask.links;
  if (gnuplot_open(&g, path, 900, 540) != 0) return -1;
  print_data(g.script, r, 0);
  print_style(g.script);
  print_time_axis(g.script, r);
  fprintf(g.script, "set title 'Lyapunov exponents of the planar pendulum with %d link%s'\n", r->ask.links,
          r->ask.links == 1 ? "" : "s");
  fputs("set ylabel '{/Symbol l}_i(t), 1/s'\n"
        "set key enhanced\n"
        "set palette defined (0 '#b2182b', 0.35 '#ef8a62', 0.5 '#8a8a8a', 0.65 '#67a9cf', 1 '#2166ac')\n"
        "unset colorbox\n"
        "set xzeroaxis linecolor '#404040'\n",
        g.script);
  for (int i = 0; i < exponents; i++)
    fprintf(g.script, "%s$run0 using 1:%d with lines linecolor palette frac %.4f linewidth 1.6 title '{/Symbol l}_{%d}'",
            i == 0 ? "plot " : ", ", i + 2, (double)i / (exponents - 1), i + 1);
  fputc('\n', g.script);
  return gnuplot_close(&g);
}

int figure_errors(const char *path, const run *const *runs, int count) {
  gnuplot g;
  if (gnuplot_open(&g, path, 900, 800) != 0) return -1;
  for (int i = 0; i < count; i++) print_data(g.script, runs[i], i);
  print_style(g.script);
  print_time_axis(g.script, runs[0]);
  fputs("set logscale y\nset format y '10^{%T}'\nset lmargin 12\nset rmargin 24\n"
        "set multiplot layout 2,1\n"
        "set title 'Energy error'\nset ylabel '|E - E_0|, J'\n",
        g.script);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, energy_column(runs[i]));
  fputs("\nset title 'Loss of orthogonality'\nset ylabel 'max |Q^TQ - I|'\n", g.script);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, orthogonality_column(runs[i]));
  fputs("\nunset multiplot\n", g.script);
  return gnuplot_close(&g);
}
