/* The page's section of Lyapunov exponents: how they converge with their intervals, beside the paper's Table 1 and Figs 3 to 5. */
#include "report.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINKS = 6, TEXT_SIZE = 256, TABLE1_LOOK = 1 };

/* Between the times of two points of a curve: closer ones cannot be told apart on a logarithmic axis. */
static const double point_ratio = 1.06;

/* The directions of one link grow in proportion to time, |x| ~ c t, since swings of other amplitudes have other periods: then
 * lambda_1 = ln(c t)/t. c, 1/s, as fitted to a run by a program that shares nothing with this one. */
static const double shear = 1.64;

/* An interval that is wider than this part of the axis says nothing but that it is too early. */
static const double widest = 0.5;

/* Axes of errors: what is less than any rounding error here, and what leaves nothing of Q. */
static const double least_error = 1e-17, lost = 1e3;

static const int colours[LINKS] = {0, 2, 3, 4, 6, 7};
static const char *const lambdas[LINKS] = {"λ₁", "λ₂", "λ₃", "λ₄", "λ₅", "λ₆"};

/* ---- the summary ---- */

static double summary_number(const table *t, int row, const char *name) { return table_number(t, row, table_column(t, name)); }

static int links_of(const table *t, int row) { return (int)summary_number(t, row, "N"); }

static void write_summary(page *p, const table *t) {
  const int links = table_column(t, "N"), printed = table_column(t, "table1"), end = table_column(t, "t");
  page_table(p, NULL, "rrrrrr", (const char *const[]){"N", "Table 1, 1/s", "t, s", "λ₁(t), 1/s", "95 % interval", "energy error, J"});
  for (int i = 0; i < t->rows; i++) {
    char text[3][TEXT_SIZE];
    const double mean = summary_number(t, i, "interval_mean"), half = summary_number(t, i, "interval_half_width");
    snprintf(text[0], sizeof text[0], "%.5f", summary_number(t, i, "lambda_1"));
    snprintf(text[1], sizeof text[1], "%.3f .. %.3f", mean - half, mean + half);
    snprintf(text[2], sizeof text[2], "%.1e", summary_number(t, i, "energy_error"));
    page_row(
        p, (const char *const[]){table_cell(t, i, links), table_cell(t, i, printed), table_cell(t, i, end), text[0], text[1], text[2]});
  }
  page_table_end(p);
}

/* ---- curves over time ---- */

/* An exponent over time, count numbers each; low and high: its interval by then, not finite where there is none yet. */
typedef struct history {
  double *t, *lambda, *low, *high;
  int count;
} history;

/* Takes points that can be told apart, the last one among them. */
static void thin_out(history *h) {
  double next = 0.0;
  int kept = 0;
  for (int k = 0; k < h->count; k++) {
    if (h->t[k] < next && k + 1 < h->count) continue;
    next = point_ratio * h->t[k];
    h->t[kept] = h->t[k], h->lambda[kept] = h->lambda[k], h->low[kept] = h->low[k], h->high[kept] = h->high[k];
    kept++;
  }
  h->count = kept;
}

static double *column_of(const table *t, const char *name, int number) {
  char column[TEXT_SIZE];
  snprintf(column, sizeof column, "%s_%d", name, number);
  report_curve c = report_points(t, NULL, 0, "t", column);
  free(c.x);
  return c.y;
}

static history history_of(const table *t, int number) {
  const report_curve c = report_points(t, NULL, 0, "t", "t");
  history h = {.t = c.x, .lambda = column_of(t, "lambda", number), .low = column_of(t, "mean", number), .count = c.count};
  h.high = column_of(t, "half_width", number);
  free(c.y);
  for (int k = 0; k < h.count; k++) {
    const double mean = h.low[k], half = h.high[k];
    h.low[k] = mean - half, h.high[k] = mean + half;
  }
  thin_out(&h);
  return h;
}

static void history_free(history *h) {
  free(h->t);
  free(h->lambda);
  free(h->low);
  free(h->high);
}

static page_series series_of(const history *h, const char *name, int look, bool bold) {
  return (page_series){
      .name = name, .x = h->t, .y = h->lambda, .low = h->low, .high = h->high, .count = h->count, .look = look, .bold = bold};
}

/* How far an axis goes: as the curve and its interval do in the later half of its points; at first they wander widely. */
static void include(const history *h, double *least, double *most) {
  for (int k = h->count / 2; k < h->count; k++) {
    *least = fmin(*least, h->lambda[k]), *most = fmax(*most, h->lambda[k]);
    if (isfinite(h->low[k])) *least = fmin(*least, h->low[k]), *most = fmax(*most, h->high[k]);
  }
}

/* Leaves out intervals that would fill the plot. */
static void clear_wide(history *h, double least, double most) {
  for (int k = 0; k < h->count; k++)
    if (!(h->high[k] - h->low[k] <= widest * (most - least))) h->low[k] = h->high[k] = (double)NAN;
}

static table rows_of(const char *folder, int links, const char *kind) {
  char file[TEXT_SIZE];
  snprintf(file, sizeof file, "lyapunov/N%d%s.csv", links, kind);
  return report_table(folder, file);
}

/* After Fig 3. */
static void draw_maximal(page *p, const char *folder, const table *summary) {
  history h[LINKS];
  page_series series[LINKS + 1];
  char names[LINKS][TEXT_SIZE];
  double ends[LINKS], printed[LINKS], least = 0.0, most = 0.0;
  int count = 0;
  for (int i = 0; i < summary->rows && i < LINKS; i++, count++) {
    table t = rows_of(folder, links_of(summary, i), "");
    h[i] = history_of(&t, 1);
    table_free(&t);
    ends[i] = summary_number(summary, i, "t"), printed[i] = summary_number(summary, i, "table1");
    most = fmax(most, printed[i]);
    include(&h[i], &least, &most);
    snprintf(names[i], sizeof names[i], "N = %d", links_of(summary, i));
    series[i] = series_of(&h[i], names[i], colours[i], false);
  }
  for (int i = 0; i < count; i++) clear_wide(&h[i], least, most);
  series[count] = (page_series){.name = "the paper's Table 1, N = 1 below to 6 above",
                                .x = ends,
                                .y = printed,
                                .count = count,
                                .style = PAGE_POINTS,
                                .look = TABLE1_LOOK};
  page_draw(p, &(page_plot){.title = "Maximal exponent of 1 to 6 links",
                            .note = "Bands: the interval by each time, from where it is narrower than half of the axis.",
                            .x = {.label = "time t, s", .log = true},
                            .y = {.label = "λ₁(t), 1/s", .least = 1.1 * least, .most = 1.1 * most},
                            .series = series,
                            .count = count + 1});
  for (int i = 0; i < count; i++) history_free(&h[i]);
}

/* One link is not chaotic. From the longer run where there is one. */
static void draw_one_link(page *p, const char *folder, const table *summary) {
  table t = report_table(folder, "lyapunov/one.csv");
  if (t.rows == 0) table_free(&t), t = rows_of(folder, 1, "");
  history h = history_of(&t, 1);
  table_free(&t);
  if (h.count == 0) {
    history_free(&h);
    return;
  }
  const double printed = summary_number(summary, 0, "table1"), ends[2] = {h.t[0], h.t[h.count - 1]}, table1[2] = {printed, printed};
  double *law = calloc((size_t)h.count, sizeof *law);
  for (int k = 0; law != NULL && k < h.count; k++) law[k] = log(shear * h.t[k]) / h.t[k];
  const page_series series[] = {
      {.name = "λ₁(t)", .x = h.t, .y = h.lambda, .count = h.count, .bold = true, .look = 0},
      {.name = "upper end of its 95 % interval", .x = h.t, .y = h.high, .count = h.count, .look = 5},
      {.name = "ln(1.64 t)/t", .x = h.t, .y = law, .count = law != NULL ? h.count : 0, .dashed = true, .look = 2},
      {.name = "the paper's Table 1", .x = ends, .y = table1, .count = 2, .dashed = true, .look = TABLE1_LOOK},
  };
  page_draw(p,
            &(page_plot){.title = "One link: the maximal exponent tends to zero",
                         .note = "A motion that is not chaotic has no positive exponent; what is computed for a finite time falls like "
                                 "ln(t)/t. Zero is inside the interval all the time.",
                         .x = {.label = "time t, s", .log = true},
                         .y = {.label = "λ₁(t), 1/s", .log = true},
                         .series = series,
                         .count = sizeof series / sizeof series[0]});
  free(law);
  history_free(&h);
}

/* After Fig 4: the first half of the spectrum, the other being its negative. */
static void draw_spectrum(page *p, const char *folder, const table *summary, int row) {
  const int n = links_of(summary, row);
  const double printed = summary_number(summary, row, "table1");
  history h[LINKS];
  page_series series[LINKS + 1];
  char title[TEXT_SIZE];
  double least = 0.0, most = 0.0;
  table t = rows_of(folder, n, "");
  if (t.rows == 0) {
    table_free(&t);
    return;
  }
  for (int i = 0; i < n; i++) {
    h[i] = history_of(&t, i + 1);
    include(&h[i], &least, &most);
    series[i] = series_of(&h[i], lambdas[i], colours[i], i == 0);
  }
  table_free(&t);
  const double ends[2] = {h[0].t[0], h[0].t[h[0].count - 1]}, table1[2] = {printed, printed};
  series[n] = (page_series){
      .name = "the paper's Table 1", .x = ends, .y = table1, .count = 2, .dashed = true, .bold = true, .look = TABLE1_LOOK};
  most = fmax(most, printed);
  for (int i = 0; i < n; i++) clear_wide(&h[i], least, most);
  snprintf(title, sizeof title, "%d link%s", n, n > 1 ? "s" : "");
  page_draw(p, &(page_plot){.title = title,
                            .x = {.label = "time t, s", .log = true},
                            .y = {.label = "exponents by t, 1/s", .least = 1.1 * least, .most = 1.1 * most},
                            .series = series,
                            .count = n + 1});
  for (int i = 0; i < n; i++) history_free(&h[i]);
}

/* ---- errors over time ---- */

/* The largest number so far of the points between two that can be told apart. */
static void thin_errors(report_curve *c) {
  double next = 0.0, most = 0.0;
  int kept = 0;
  for (int k = 0; k < c->count; k++) {
    most = fmax(most, fmax(c->y[k], least_error));
    if (c->x[k] < next && k + 1 < c->count) continue;
    next = point_ratio * c->x[k];
    c->x[kept] = c->x[k], c->y[kept] = most;
    kept++;
    most = 0.0;
  }
  c->count = kept;
}

/* After Fig 5: of the runs, and dashed of the scheme as printed at a step that does not overflow at once. */
static void draw_errors(page *p, const char *folder, const table *summary, const char *title, const char *label, const char *column,
                        double limit) {
  report_curve curves[2 * LINKS];
  page_series series[2 * LINKS];
  char names[2 * LINKS][TEXT_SIZE];
  int count = 0;
  for (int printed = 0; printed < 2; printed++)
    for (int i = 0; i < summary->rows && i < LINKS; i++, count++) {
      table t = rows_of(folder, links_of(summary, i), printed ? "_as_printed" : "");
      curves[count] = report_points(&t, NULL, 0, "t", column);
      table_free(&t);
      thin_errors(&curves[count]);
      snprintf(names[count], sizeof names[count], "N = %d%s", links_of(summary, i), printed ? ", as printed" : "");
      series[count] = (page_series){.name = names[count],
                                    .x = curves[count].x,
                                    .y = curves[count].y,
                                    .count = curves[count].count,
                                    .dashed = printed,
                                    .look = colours[i]};
    }
  page_draw(p, &(page_plot){.title = title,
                            .x = {.label = "time t, s", .log = true},
                            .y = {.label = label, .log = true, .least = least_error, .most = limit},
                            .series = series,
                            .count = count});
  for (int i = 0; i < count; i++) report_free(&curves[i]);
}

/* ---- the section ---- */

void report_lyapunov(page *p, const char *folder) {
  table t = report_table(folder, "lyapunov/table1.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Lyapunov exponents");
    page_text(
        p,
        "The paper's pendulum of N links from 75 degrees: Q re-orthonormalised, with steps that keep the energy (`pendulum "
        "--table1`), beside Table 1 and, in place of its Figs 3 to 5, over time. Intervals are of 95 %%, from means over blocks of the "
        "time so far. Table 1 holds for N = 1 and 2 only.");
    write_summary(p, &t);
    page_heading(p, 3, "Convergence of the maximal exponent");
    draw_maximal(p, folder, &t);
    draw_one_link(p, folder, &t);
    page_heading(p, 3, "Convergence of the spectrum");
    page_text(p, "The first N exponents; the others are their negatives. The last of them tends to zero like ln(t)/t.");
    for (int i = 0; i < t.rows && i < LINKS; i++) draw_spectrum(p, folder, &t, i);
    page_heading(p, 3, "What the scheme as printed loses");
    page_text(
        p, "Dashed: eqs 75 to 80 as printed, Q never made orthonormal again, at a step of 0.002 s over half the time; at the paper's "
           "step of 0.05 s it overflows within half a second for N = 2 to 6. Its energy is as good as that of the runs above; Q is "
           "not orthogonal for long.");
    draw_errors(p, folder, &t, "Energy error", "|E − E₀|, J", "energy_error", 1.0);
    draw_errors(p, folder, &t, "Loss of orthogonality", "max |QᵀQ − I|", "orthogonality_error", lost);
  }
  table_free(&t);
}
