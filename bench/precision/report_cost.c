/* The page's section of cost against the number of links. */
#include "report.h"
#include "work.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const struct {
  const char *contender, *title;
  int look;
  bool bold;
} cost_curves[] = {
    {"adjoint", "generated", 0, true},      {"adjoint-lanes", "generated, 8 states in a vector", 8, false},
    {"hand", "by hand", 7, false},          {"casadi", "CasADi", 6, false},
    {"heyoka", "heyoka", 3, false},         {"pinocchio", "Pinocchio", 2, false},
    {"mujoco", "MuJoCo", 1, false},         {"adolc", "ADOL-C", 4, false},
    {"dense", "the paper's way", 5, false},
};
enum { COST_CURVES = sizeof cost_curves / sizeof cost_curves[0] };

/* Of each size the fastest build. Returns how many sizes there are. */
static int cost_points(const table *t, const char *contender, const char *need, const char *way, double *n, double *ns) {
  const int columns[] = {table_column(t, "contender"), table_column(t, "need"), table_column(t, "way"), table_column(t, "model")};
  const char *const wanted[] = {contender, need, way, "pendulum"};
  const int size = table_column(t, "N"), time = table_column(t, "min_ns");
  int count = 0;
  for (int row = 0; row < t->rows; row++) {
    bool fits = true;
    for (int k = 0; k < 4; k++) fits = fits && strcmp(table_cell(t, row, columns[k]), wanted[k]) == 0;
    const double here = table_number(t, row, size), took = table_number(t, row, time);
    if (!fits || !isfinite(took)) continue;
    int i = 0;
    while (i < count && n[i] < here) i++;
    if (i < count && n[i] == here) {
      ns[i] = fmin(ns[i], took);
      continue;
    }
    if (count == WORK_MOST_POINTS) continue;
    memmove(n + i + 1, n + i, (size_t)(count - i) * sizeof *n);
    memmove(ns + i + 1, ns + i, (size_t)(count - i) * sizeof *ns);
    n[i] = here, ns[i] = took;
    count++;
  }
  return count;
}

static void draw_cost(page *p, const table *t, const char *need, const char *way, const char *title) {
  static double n[COST_CURVES][WORK_MOST_POINTS + 1], ns[COST_CURVES][WORK_MOST_POINTS + 1];
  page_series series[COST_CURVES];
  int count = 0;
  for (int i = 0; i < COST_CURVES; i++) {
    const int found = cost_points(t, cost_curves[i].contender, need, way, n[i], ns[i]);
    if (found > 0)
      series[count++] = (page_series){.name = cost_curves[i].title,
                                      .x = n[i],
                                      .y = ns[i],
                                      .count = found,
                                      .style = PAGE_LINE_POINTS,
                                      .look = cost_curves[i].look,
                                      .bold = cost_curves[i].bold};
  }
  if (count > 0)
    page_draw(p, &(page_plot){.title = title,
                              .x = {.label = "links N", .log = true},
                              .y = {.label = "ns per state", .log = true},
                              .series = series,
                              .count = count});
}

void report_cost(page *p, const char *folder) {
  table t = report_table(folder, "cost.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Cost against the number of links");
    page_text(
        p, "One evaluation for the pendulum of N links, the fastest build of each contender, each checked against quad precision, as "
           "`bench/run` measures it. Independent states follow one another; where each waits for the last result, as in a simulation, "
           "vectors of states do not help.");
    draw_cost(p, &t, "F", "throughput", "Accelerations, independent states");
    draw_cost(p, &t, "F", "latency", "Accelerations, each state waits for the last");
    draw_cost(p, &t, "J", "throughput", "Accelerations and linearisation, independent states");
    draw_cost(p, &t, "J", "latency", "Accelerations and linearisation, each state waits for the last");
  }
  table_free(&t);
}
