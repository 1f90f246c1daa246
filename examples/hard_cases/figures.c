/* The figures: time against error, and what keeps the constraints. */
#include "figures.h"

#include "host/gnuplot.h"
#include "host/message.h"
#include "run.h"

#include <math.h>

enum { PATH_SIZE = 4096 };

/* Stands for zero on a logarithmic axis: less than any rounding error here. */
static const double zero_mark = 1e-18;

/* Between two points of a curve: closer ones cannot be told apart. */
static const double point_ratio = 1.02;

/* Errors above it are no solutions: they are left out. */
static const double most_error = 1.0;

/* Longest run of a curve, s; the next finer one would take about twice as long. */
static const double most_seconds = 2.0;

/* Colours that colour-blind readers can tell apart. */
static const char *const colours[] = {"#0072B2", "#D55E00", "#009E73"};

/* One curve of a figure of speed against error: fixed steps, each half the last, or tolerances, each a tenth of the last. */
typedef struct curve {
  const char *method, *title;
  int colour;
  bool chosen;
} curve;

static const curve curves[] = {{"rk4", "rk4, fixed steps", 0, false},
                               {"dp5", "dp5, fixed steps", 1, false},
                               {"dop853", "dop853, fixed steps", 2, false},
                               {"dp5", "dp5, steps chosen", 1, true},
                               {"dop853", "dop853, steps chosen", 2, true}};
enum { CURVES = sizeof curves / sizeof curves[0] };

static int open_figure(gnuplot *g, const char *folder, const char *name, int width, int height) {
  static char path[PATH_SIZE]; /* of the one figure that is open */
  if (snprintf(path, sizeof path, "%s/%s.svg", folder, name) >= (int)sizeof path) {
    complain("cannot write into '%s': the name is too long", folder);
    return -1;
  }
  if (gnuplot_open(g, path, width, height) != 0) return -1;
  fputs("set grid back linecolor '#d0d0d0' linewidth 0.5\nset border 3 back\nset tics nomirror out\n", g->script);
  return 0;
}

/* Text between the quotes of a script. */
static void print_quoted(FILE *script, const char *text) {
  for (; *text != '\0'; text++) fputs((const char[]){*text, *text == '\'' ? '\'' : '\0', '\0'}, script);
}

/* ---- time against error ---- */

/* The runs of one curve as data, from coarse to fine, until one takes long or the user interrupts. Returns 0, or -1 where that was. */
static int print_curve(FILE *script, const scene *s, const curve *c, int number, bool quick) {
  bool interrupted = false, long_enough = false;
  fprintf(script, "$curve%d << EOD\n", number);
  for (int i = 0; i < (quick ? 3 : 12) && !interrupted && !long_enough; i++) {
    run_request ask = {.scene = s, .duration = quick ? s->quick : s->duration, .method = c->method, .drift = DRIFT_PROJECTION};
    if (c->chosen)
      ask.tolerance = 1e-3 * pow(0.1, i);
    else
      ask.step = ldexp(s->coarsest, -i);
    run r;
    run_do(&r, &ask);
    interrupted = r.status == EOM_STOPPED;
    long_enough = r.seconds > most_seconds;
    if (r.status == EOM_OK && r.worst.error < most_error)
      fprintf(script, "%.6g %.6g\n", r.seconds / r.duration, fmax(r.worst.error, zero_mark));
    run_free(&r);
  }
  fputs("EOD\n", script);
  return interrupted ? -1 : 0;
}

static void plot_curves(FILE *script, const scene *s, bool quick) {
  fprintf(script, "set title '%s: ", s->name);
  print_quoted(script, s->about);
  fprintf(script, ", %g s'\n", quick ? s->quick : s->duration);
  fputs("set logscale xy\nset format '%.0e'\nset key outside right top samplen 3\n"
        "set xlabel 'time of computation / real time'\n",
        script);
  fprintf(script, "set ylabel 'largest error of %s'\n", s->measured);
  fprintf(script, "plot %g with lines dashtype '.' linewidth 1.5 linecolor '#404040' title 'required'", s->required);
  for (int i = 0; i < CURVES; i++)
    fprintf(script, ", $curve%d with linespoints linewidth 1.6 pointsize 0.6 pointtype %d linecolor '%s' dashtype %s title '%s'", i,
            curves[i].chosen ? 6 : 7, colours[curves[i].colour], curves[i].chosen ? "'-'" : "1", curves[i].title);
  fputc('\n', script);
}

static int draw_speed(const char *folder, const scene *s, bool quick) {
  char name[PATH_SIZE];
  gnuplot g;
  snprintf(name, sizeof name, "speed_%s", s->name);
  if (open_figure(&g, folder, name, 960, 540) != 0) return EXIT_FAILED;
  int stopped = 0;
  for (int i = 0; i < CURVES && stopped == 0; i++) stopped = print_curve(g.script, s, &curves[i], i, quick);
  plot_curves(g.script, s, quick);
  if (stopped != 0) {
    fclose(g.script);
    output_discard(&g.figure);
    return EXIT_INTERRUPTED;
  }
  return gnuplot_close(&g) == 0 ? EXIT_DONE : EXIT_FAILED;
}

/* ---- drift ---- */

static const double drift_time = 1000.0, drift_step = 0.01;    /* s */
static const double drift_rate = 10.0, drift_required = 1e-12; /* 1/s; of |phi| where it is projected, m^2 */
static const char *const drift_titles[] = {"none", "Baumgarte, α = β = 10/s", "projection"}; /* in the order of run_drift */
enum { DRIFTS = sizeof drift_titles / sizeof drift_titles[0] };

/* Data: t, and the largest |phi|, |phi_dot| and energy error so far. Returns whether the run came to its end. */
static bool print_drift(FILE *script, int drift, double duration) {
  run r;
  const run_request ask = {.scene = scene_find("A01"),
                           .duration = duration,
                           .method = "dp5",
                           .step = drift_step,
                           .drift = (run_drift)drift,
                           .rate = drift_rate};
  run_do(&r, &ask);
  fprintf(script, "$drift%d << EOD\n", drift);
  run_row worst = {.phi = zero_mark, .phi_dot = zero_mark, .energy = zero_mark};
  for (int i = 1; i < r.nrow; i++) {
    const run_row *row = &r.rows[i];
    const bool larger =
        row->phi > worst.phi * point_ratio || row->phi_dot > worst.phi_dot * point_ratio || row->energy > worst.energy * point_ratio;
    if (!larger && i + 1 < r.nrow) continue;
    worst.phi = fmax(worst.phi, row->phi);
    worst.phi_dot = fmax(worst.phi_dot, row->phi_dot);
    worst.energy = fmax(worst.energy, row->energy);
    fprintf(script, "%.8g %.6g %.6g %.6g\n", row->t, worst.phi, worst.phi_dot, worst.energy);
  }
  fputs("EOD\n", script);
  const bool done = r.status == EOM_OK;
  run_free(&r);
  return done;
}

static void plot_drift(FILE *script, double duration) {
  static const char *const labels[] = {"|φ|, m²", "|φ̇|, m²/s", "energy error, J"};
  fprintf(script,
          "set logscale y\nset format y '%%.0e'\nset xrange [0:%g]\nset lmargin 12\nset rmargin 4\n"
          "set multiplot layout 3,1 title 'A01: pendulum in Cartesian coordinates, dp5, steps of %g s; largest error so far'\n"
          "set key above horizontal left samplen 2\n",
          duration, drift_step);
  for (int k = 0; k < 3; k++) {
    fprintf(script, "set ylabel '%s'\n", labels[k]);
    if (k == 2) fputs("set xlabel 'time t, s'\n", script);
    for (int i = 0; i < DRIFTS; i++) {
      fprintf(script, "%s$drift%d using 1:%d with lines linewidth 1.6 linecolor '%s' ", i == 0 ? "plot " : ", ", i, k + 2, colours[i]);
      if (k == 0)
        fprintf(script, "title '%s'", drift_titles[i]);
      else
        fputs("notitle", script);
    }
    if (k == 0)
      fprintf(script, ", %g with lines dashtype '.' linewidth 1.5 linecolor '#404040' title 'required of projection'", drift_required);
    fputc('\n', script);
  }
  fputs("unset multiplot\n", script);
}

static int draw_drift(const char *folder, double duration) {
  gnuplot g;
  bool done = true;
  if (open_figure(&g, folder, "drift", 960, 900) != 0) return EXIT_FAILED;
  for (int i = 0; i < DRIFTS && done; i++) done = print_drift(g.script, i, duration);
  plot_drift(g.script, duration);
  if (!done) {
    fclose(g.script);
    output_discard(&g.figure);
    return EXIT_INTERRUPTED;
  }
  return gnuplot_close(&g) == 0 ? EXIT_DONE : EXIT_FAILED;
}

int draw_figures(const char *folder, bool quick) {
  if (find_gnuplot() != 0) return EXIT_FAILED;
  int status = draw_drift(folder, quick ? scene_find("A01")->quick : drift_time);
  for (int i = 0; i < nscenes && status == EXIT_DONE; i++)
    if (scenes[i]->coarsest > 0.0) status = draw_speed(folder, scenes[i], quick);
  return status;
}
