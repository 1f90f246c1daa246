/* The figures of the demonstration, after Figs 3, 4 and 5 of the paper. */
#include "figures.h"

#include "host/gnuplot.h"
#include "host/message.h"

#include <math.h>

enum {
  MOST_NAMES = 24, /* of curves, in the legend: more do not fit beside it */
  MOST_RUNS = 2 * PENDULUM_MAX_LINKS
};

/* Between the times of two points of a curve: closer ones cannot be told apart on a logarithmic axis. */
static const double point_ratio = 1.01;

/* Stands for an error of zero on a logarithmic axis: less than any rounding error here. */
static const double zero_mark = 1e-18;

/* Ends the axis of the orthogonality error: beyond it nothing is left of Q, and the overflow would press the rest together. */
static const double lost_mark = 1e3;

/* One colour for each run; chosen to be told apart by colour-blind readers too. */
static const char *const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
enum { COLOURS = sizeof colours / sizeof colours[0] };

/* The columns of a row by their place in the script's data. */
static int energy_column(const run *r) { return run_width(r) - 1; }
static int orthogonality_column(const run *r) { return run_width(r); }

static void print_data(FILE *script, const run *r, int number) {
  int width = run_width(r);
  fprintf(script, "$run%d << EOD\n", number);
  double next = 0.0;
  for (long k = 0; k < r->nrow; k++) {
    const double *row = r->rows + k * width, energy = row[width - 2], orthogonality = row[width - 1];
    if (row[0] < next && k + 1 < r->nrow) continue;
    next = row[0] * point_ratio;
    fprintf(script, "%.8g", row[0]);
    for (int i = 1; i < width - 2; i++) fprintf(script, " %.6g", row[i]);
    fprintf(script, " %.6g %.6g\n", fmax(energy, zero_mark), fmax(orthogonality, zero_mark));
  }
  fputs("EOD\n", script);
}

static void print_style(FILE *script) {
  fputs("set grid back linecolor '#d0d0d0' linewidth 0.5\n"
        "set border 3 back\n"
        "set tics nomirror out\n"
        "set key outside right center samplen 2\n",
        script);
}

/* From the first row of any run to the last. */
static void print_time_axis(FILE *script, const run *const *runs, int count) {
  double first = HUGE_VAL, last = 0.0;
  for (int i = 0; i < count; i++) first = fmin(first, runs[i]->rows[0]), last = fmax(last, runs[i]->t);
  fputs("set logscale x\nset format x '%g'\nset xlabel 'time t, s'\n", script);
  fprintf(script, "set xrange [%.8g:%.8g]\n", first, last);
}

/* Without any error the axis has nothing to go by. */
static void print_energy_axis(FILE *script, const run *const *runs, int count) {
  double worst = 0.0;
  for (int i = 0; i < count; i++) worst = fmax(worst, runs[i]->worst_energy_error);
  if (worst <= zero_mark) fprintf(script, "set yrange [%g:%g]\n", zero_mark, energy_bound);
}

/* The runs that make a curve: their number. Zero after a message that the figure is left out. */
static int gather(const run **drawn, const run *const *runs, int count, const char *path) {
  int kept = 0;
  for (int i = 0; i < count; i++)
    if (runs[i]->nrow >= FIGURE_ROWS) drawn[kept++] = runs[i];
  if (kept == 0) complain("'%s' is left out: a curve needs two rows, and there are fewer", path);
  return kept;
}

/* One curve: a column of a run against time. Dashed and without a name of its own for the printed scheme. */
static void print_curve(FILE *script, const run *r, int number, int column) {
  fprintf(script, "%s$run%d using 1:%d with lines linewidth 1.6 linecolor '%s'", number == 0 ? "plot " : ", ", number, column,
          colours[(r->ask.links - 1) % COLOURS]);
  if (r->ask.scheme == EOM_LYAPUNOV_PAPER)
    fputs(" dashtype '-' notitle", script);
  else
    fprintf(script, " title 'N = %d'", r->ask.links);
}

/* The step of the printed scheme's runs, as a part of a title; empty where there is none. */
static void print_legend_of_dashes(FILE *script, const run *const *runs, int count) {
  const run *last = runs[count - 1];
  if (last->ask.scheme == EOM_LYAPUNOV_PAPER) fprintf(script, " (dashed: the scheme as printed, step %g s)", last->step);
}

int figure_maximal(const char *path, const run *const *all, int of) {
  gnuplot g;
  const run *runs[MOST_RUNS];
  int count = gather(runs, all, of, path);
  if (count == 0) return 0;
  if (gnuplot_open(&g, path, 900, 540) != 0) return -1;
  for (int i = 0; i < count; i++) print_data(g.script, runs[i], i);
  print_style(g.script);
  print_time_axis(g.script, runs, count);
  fputs("set title 'Maximal Lyapunov exponent of the planar N-pendulum'\nset ylabel 'λ₁(t), 1/s'\n", g.script);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, 2);
  fputc('\n', g.script);
  return gnuplot_close(&g);
}

enum { SUBSCRIPT_SIZE = 3 * 3 + 1 /* three digits of three bytes each */ };

/* A number from 0 to 999 in subscript digits. */
static const char *subscript(int number, char *text) {
  static const char *const digit[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  snprintf(text, SUBSCRIPT_SIZE, "%s%s%s", number >= 100 ? digit[number / 100 % 10] : "", number >= 10 ? digit[number / 10 % 10] : "",
           digit[number % 10]);
  return text;
}

int figure_spectrum(const char *path, const run *r) {
  gnuplot g;
  int exponents = 2 * r->ask.links, every = 1 + exponents / MOST_NAMES;
  char digits[SUBSCRIPT_SIZE];
  const run *drawn;
  if (gather(&drawn, &r, 1, path) == 0) return 0;
  if (gnuplot_open(&g, path, 900, 540) != 0) return -1;
  print_data(g.script, r, 0);
  print_style(g.script);
  print_time_axis(g.script, &drawn, 1);
  fprintf(g.script, "set title 'Lyapunov exponents of the planar pendulum with %d link%s'\n", r->ask.links,
          r->ask.links == 1 ? "" : "s");
  fputs("set ylabel 'λᵢ(t), 1/s'\n"
        "set palette defined (0 '#b2182b', 0.35 '#ef8a62', 0.5 '#8a8a8a', 0.65 '#67a9cf', 1 '#2166ac')\n"
        "unset colorbox\n"
        "set xzeroaxis linecolor '#404040'\n",
        g.script);
  for (int i = 0; i < exponents; i++) {
    fprintf(g.script, "%s$run0 using 1:%d with lines linecolor palette frac %.4f linewidth 1.6", i == 0 ? "plot " : ", ", i + 2,
            (double)i / (exponents - 1));
    if (i % every == 0 || i == exponents - 1)
      fprintf(g.script, " title 'λ%s'", subscript(i + 1, digits));
    else
      fputs(" notitle", g.script);
  }
  fputc('\n', g.script);
  return gnuplot_close(&g);
}

int figure_errors(const char *path, const run *const *all, int of) {
  gnuplot g;
  const run *runs[MOST_RUNS];
  int count = gather(runs, all, of, path);
  if (count == 0) return 0;
  if (gnuplot_open(&g, path, 900, 800) != 0) return -1;
  for (int i = 0; i < count; i++) print_data(g.script, runs[i], i);
  print_style(g.script);
  print_time_axis(g.script, runs, count);
  fputs("set logscale y\nset format y '%.0e'\nset lmargin 12\nset rmargin 14\n"
        "set multiplot layout 2,1\n"
        "set title 'Energy error",
        g.script);
  print_legend_of_dashes(g.script, runs, count);
  fputs("'\nset ylabel '|E - E₀|, J'\n", g.script);
  print_energy_axis(g.script, runs, count);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, energy_column(runs[i]));
  fputs("\nset title 'Loss of orthogonality", g.script);
  print_legend_of_dashes(g.script, runs, count);
  fprintf(g.script, "'\nset ylabel 'max |QᵀQ - I|'\nset yrange [%g:%g]\n", zero_mark, lost_mark);
  for (int i = 0; i < count; i++) print_curve(g.script, runs[i], i, orthogonality_column(runs[i]));
  fputs("\nunset multiplot\n", g.script);
  return gnuplot_close(&g);
}
