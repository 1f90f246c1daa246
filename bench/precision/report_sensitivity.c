/* The page's section of derivatives of motions. */
#include "report.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_SIZE = 256, CURVES = 5 };

static const struct {
  const char *name, *title;
} models[] = {
    {"chain", "Chain of two masses"},
    {"planet", "Planet about a sun"},
    {"spring", "Pendulum on a spring"},
    {"rod", "Mass on a rod, by a constraint"},
};
enum { MODELS = sizeof models / sizeof models[0] };

static const struct {
  const char *way, *column, *title;
  int look;
  bool dashed, bold;
} curves[CURVES] = {
    {"tangents", "initial_error", "∂y/∂y₀", 0, false, true},
    {"tangents", "parameter_error", "∂y/∂p", 1, false, true},
    {"tangents", "state_error", "y itself", 7, false, false},
    {"differences", "initial_error", "∂y/∂y₀ by differences", 0, true, false},
    {"differences", "parameter_error", "∂y/∂p by differences", 1, true, false},
};

/* Columns of one model: errors over x. */
static void draw(page *p, const table *t, int model, const char *x, const char *label, bool state) {
  report_curve data[CURVES];
  page_series series[CURVES];
  int count = 0;
  for (int i = 0; i < CURVES; i++) {
    if (!state && strcmp(curves[i].column, "state_error") == 0) continue;
    const report_key keys[] = {{table_column(t, "model"), models[model].name}, {table_column(t, "way"), curves[i].way}};
    data[count] = report_points(t, keys, 2, x, curves[i].column);
    series[count] = (page_series){.name = curves[i].title,
                                  .x = data[count].x,
                                  .y = data[count].y,
                                  .count = data[count].count,
                                  .style = PAGE_LINE_POINTS,
                                  .look = curves[i].look,
                                  .dashed = curves[i].dashed,
                                  .bold = curves[i].bold};
    count++;
  }
  page_draw(p, &(page_plot){.title = models[model].title,
                            .x = {.label = label, .log = true},
                            .y = {.label = "relative error", .log = true},
                            .series = series,
                            .count = count});
  for (int i = 0; i < count; i++) report_free(&data[i]);
}

/* At one tolerance. */
static void write_table(page *p, const table *t, const char *tolerance) {
  const int model = table_column(t, "model"), way = table_column(t, "way"), at = table_column(t, "tolerance");
  char caption[TEXT_SIZE];
  snprintf(caption, sizeof caption, "At a tolerance of %s", tolerance);
  page_table(p, caption, "lrrrr", (const char *const[]){"", "columns", "error of ∂y/∂y₀", "of ∂y/∂p", "time, ms"});
  for (int i = 0; i < t->rows; i++) {
    char text[5][TEXT_SIZE];
    if (strcmp(table_cell(t, i, at), tolerance) != 0) continue;
    const bool differences = strcmp(table_cell(t, i, way), "differences") == 0;
    int k = 0;
    while (k + 1 < MODELS && strcmp(table_cell(t, i, model), models[k].name) != 0) k++;
    snprintf(text[0], sizeof text[0], "%s%s", models[k].title, differences ? ", by differences" : "");
    snprintf(text[1], sizeof text[1], "%s + %s", table_cell(t, i, table_column(t, "directions")),
             table_cell(t, i, table_column(t, "parameters")));
    snprintf(text[2], sizeof text[2], "%.1e", table_number(t, i, table_column(t, "initial_error")));
    snprintf(text[3], sizeof text[3], "%.1e", table_number(t, i, table_column(t, "parameter_error")));
    snprintf(text[4], sizeof text[4], "%.3g", 1e3 * table_number(t, i, table_column(t, "cpu_s")));
    page_row(p, (const char *const[]){text[0], text[1], text[2], text[3], text[4]});
  }
  page_table_end(p);
}

void report_sensitivity(page *p, const char *folder) {
  table t = report_table(folder, "sensitivity.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Sensitivities");
    page_text(p,
              "Derivatives of the state at the end of a motion with respect to where it began and to its parameters, integrated beside "
              "it by dop853 with exact tangents (`eom/sensitivity.h`), against derivatives in 40 digits that a program with "
              "textbook equations computed. The error is the largest in a column, in parts of the column's largest number. Dashed: "
              "what central differences of whole motions by the same method make of the same tolerance, two motions for each "
              "column, at the step that balances their errors.");
    page_heading(p, 3, "Error against tolerance");
    for (int i = 0; i < MODELS; i++) draw(p, &t, i, "tolerance", "tolerance", true);
    page_heading(p, 3, "Error against CPU time");
    for (int i = 0; i < MODELS; i++) draw(p, &t, i, "cpu_s", "CPU time for all columns, s", false);
    write_table(p, &t, "1e-12");
  }
  table_free(&t);
}
