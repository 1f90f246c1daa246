/* precision_report: the page that scripts/report makes of what was measured. */
#include "host/message.h"
#include "host/page.h"
#include "scenes.h"
#include "table.h"
#include "work.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char program[] = "precision_report";

enum { PATH_SIZE = 4096, TEXT_SIZE = 256, LINE_SIZE = 4096, MOST_SERIES = 64, LINKS = 6, SHOWN = 120 };

/* A file of the folder of results. */
static table read_file(const char *folder, const char *name) {
  char path[PATH_SIZE];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return table_read(path);
}

/* ---- how the curves look ---- */

typedef struct look {
  const char *contender, *method; /* as in the rows */
  const char *title;
  int number; /* as page_series has it */
  bool dashed, bold;
} look;

static const look looks[] = {
    {"own", "dop853", "dop853", 0, false, true},
    {"own", "dop853 fixed", "dop853, equal steps", 0, true, false},
    {"own", "taylor", "taylor", 6, false, true},
    {"own", "taylor fixed", "taylor, equal steps", 6, true, false},
    {"own", "dp5", "dp5", 1, false, false},
    {"own", "dp5 fixed", "dp5, equal steps", 1, true, false},
    {"own", "rk4", "rk4", 2, false, false},
    {"own", "rk4 fixed", "rk4, equal steps", 2, true, false},
    {"own", "variational2 fixed", "variational2, equal steps", 3, true, false},
    {"own", "variational4 fixed", "variational4, equal steps", 4, true, false},
    {"own", "variational6 fixed", "variational6, equal steps", 5, true, false},
    {"sundials", "cvode_adams", "cvode_adams", 11, false, false},
    {"sundials", "cvode_bdf", "cvode_bdf", 12, false, false},
    {"sundials", "arkode_dp5", "arkode_dp5", 9, false, false},
    {"sundials", "arkode_fehlberg8", "arkode_fehlberg8", 8, false, false},
    {"hand", "dop853", "written by hand: dop853", 7, false, false},
    {"heyoka", "Taylor", "heyoka: Taylor", 3, false, true},
    {"casadi", "CVODES Adams", "CasADi: CVODES Adams", 12, false, false},
    {"casadi", "CVODES BDF", "CasADi: CVODES BDF", 13, false, false},
    {"scipy", "DOP853", "scipy: DOP853", 15, false, false},
};

static const look *look_of(const char *contender, const char *method) {
  for (size_t i = 0; i < sizeof looks / sizeof looks[0]; i++)
    if (strcmp(looks[i].contender, contender) == 0 && strcmp(looks[i].method, method) == 0) return &looks[i];
  return NULL;
}

static page_series series_of(const work_curve *c) {
  const look *l = look_of(c->contender, c->method);
  page_series s = {.name = c->method, .x = c->error, .y = c->cpu, .count = c->count, .style = PAGE_LINE_POINTS, .look = 15};
  if (l != NULL) s.name = l->title, s.look = l->number, s.dashed = l->dashed, s.bold = l->bold;
  return s;
}

/* ---- the run ---- */

/* Lines of a file of the folder, without their ends. */
static bool read_line(FILE *file, char *line, size_t size) {
  if (fgets(line, (int)size, file) == NULL) return false;
  line[strcspn(line, "\n")] = '\0';
  return true;
}

static FILE *open_file(const char *folder, const char *name) {
  char path[PATH_SIZE];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return fopen(path, "r");
}

/* Lines `name: value`. */
static void write_facts(page *p, const char *folder) {
  char line[LINE_SIZE];
  FILE *file = open_file(folder, "facts.txt");
  if (file == NULL) return;
  page_table(p, NULL, "ll", (const char *const[]){"this run", NULL});
  while (read_line(file, line, sizeof line)) {
    char *colon = strstr(line, ": ");
    if (colon == NULL) continue;
    *colon = '\0';
    page_row(p, (const char *const[]){line, colon + 2});
  }
  page_table_end(p);
  fclose(file);
}

/* ---- time against error ---- */

enum { RIVALS = 4, LOOSEST = 6, TIGHTEST = 13 };

static bool is_ours(const char *contender) { return strcmp(contender, "own") == 0 || strcmp(contender, "sundials") == 0; }
static bool is_hand(const char *contender) { return strcmp(contender, "hand") == 0; }
static bool is_heyoka(const char *contender) { return strcmp(contender, "heyoka") == 0; }
static bool is_casadi(const char *contender) { return strcmp(contender, "casadi") == 0; }
static bool is_scipy(const char *contender) { return strcmp(contender, "scipy") == 0; }

static const char *const rival_titles[RIVALS] = {"by hand", "heyoka", "CasADi", "scipy"};
static bool (*const is_rival[RIVALS])(const char *contender) = {is_hand, is_heyoka, is_casadi, is_scipy};

/* Which of our curves are the fastest somewhere. */
static void mark_winners(const work_curve *curves, int count, bool *wins) {
  for (int k = LOOSEST; k <= TIGHTEST; k++) {
    const int best = work_fastest(curves, count, is_ours, pow(10.0, -k));
    if (best >= 0) wins[best] = true;
  }
}

static void draw_work(page *p, const char *title, const page_series *series, int count, const char *measured) {
  char label[TEXT_SIZE];
  snprintf(label, sizeof label, "error of %s at the end", measured);
  if (count > 0)
    page_draw(p, &(page_plot){.title = title,
                              .x = {.label = label, .log = true},
                              .y = {.label = "CPU time, s", .log = true},
                              .series = series,
                              .count = count});
}

static void draw_scene(page *p, const precision_scene *of, const work_curve *curves, int count) {
  page_series ours[MOST_SERIES], race[MOST_SERIES];
  bool wins[WORK_MOST_CURVES] = {false};
  int mine = 0, all = 0;
  mark_winners(curves, count, wins);
  for (int i = 0; i < count; i++) {
    const bool own = is_ours(curves[i].contender);
    if (own) ours[mine++] = series_of(&curves[i]);
    if (!own || wins[i]) race[all++] = series_of(&curves[i]);
  }
  draw_work(p, "Methods of this library", ours, mine, of->scene->measured);
  draw_work(p, "The fastest of them beside others", race, all, of->scene->measured);
}

/* A time as a multiple of ours. */
static void ratio_text(char *text, size_t size, const work_curve *curves, int count, int rival, double error, double ours) {
  const int best = work_fastest(curves, count, is_rival[rival], error);
  text[0] = '\0';
  if (best < 0) return;
  const double ratio = work_time(&curves[best], error) / ours;
  if (isnan(ratio))
    snprintf(text, size, "ahead");
  else
    snprintf(text, size, ratio < 1.0 ? "%.2f ◀" : ratio < 9.95 ? "%.1f" : "%.0f", ratio);
}

static void write_levels(page *p, const work_curve *curves, int count) {
  const char *heads[3 + RIVALS] = {"error", "ours, ms"};
  memcpy(heads + 2, rival_titles, sizeof rival_titles);
  heads[2 + RIVALS] = "by";
  page_table(p, NULL, "rrrrrrl", heads);
  for (int k = LOOSEST; k <= TIGHTEST; k++) {
    char text[2 + RIVALS][TEXT_SIZE] = {""};
    const double error = pow(10.0, -k);
    const int best = work_fastest(curves, count, is_ours, error);
    const double ours = best >= 0 ? work_time(&curves[best], error) : (double)NAN;
    snprintf(text[0], sizeof text[0], "1e-%d", k);
    if (best >= 0) snprintf(text[1], sizeof text[1], "%.3g", 1e3 * ours);
    const char *cells[3 + RIVALS] = {text[0], text[1]};
    if (best >= 0) cells[2 + RIVALS] = series_of(&curves[best]).name;
    for (int r = 0; r < RIVALS; r++) {
      ratio_text(text[2 + r], sizeof text[2 + r], curves, count, r, error, ours);
      cells[2 + r] = text[2 + r];
    }
    page_row(p, cells);
  }
  page_table_end(p);
}

/* The shortest time of another package as a multiple of ours; NaN where one of both does not get there. */
static double closest(const work_curve *curves, int count, double error) {
  const int best = work_fastest(curves, count, is_ours, error);
  double ratio = (double)NAN;
  for (int r = 0; r < RIVALS && best >= 0; r++) {
    const int other = is_rival[r] == is_hand ? -1 : work_fastest(curves, count, is_rival[r], error);
    const double here = other >= 0 ? work_time(&curves[other], error) / work_time(&curves[best], error) : (double)NAN;
    if (!isnan(here) && !(here >= ratio)) ratio = here;
  }
  return ratio;
}

enum { NAMES = 1 + RIVALS, LEVELS = TIGHTEST - LOOSEST + 1 };

static int read_curves(work_curve *curves, const table *tables, const precision_scene *of) {
  int count = 0;
  for (int k = 0; k < NAMES; k++) count = work_read(curves, count, &tables[k], of->name);
  return count;
}

/* On standard output as a page of text wants it. */
static void print_markdown(const char *const *cells, int count) {
  for (int i = 0; i < count; i++) printf("| %s ", cells[i]);
  puts("|");
}

/* On the page, and on standard output. */
static void write_overview(page *p, work_curve *curves, const table *tables) {
  char text[LEVELS][TEXT_SIZE];
  const char *cells[1 + LEVELS] = {"scene"};
  for (int k = 0; k < LEVELS; k++) {
    snprintf(text[k], sizeof text[k], "1e-%d", LOOSEST + k);
    cells[1 + k] = text[k];
  }
  print_markdown(cells, 1 + LEVELS);
  for (int i = 0; i <= LEVELS; i++) fputs("|---", stdout);
  puts("|");
  page_table(p, "The fastest other package at each error: its time as a multiple of ours; below 1 it is ahead", "lrrrrrrrr", cells);
  for (int i = 0; i < precision_scene_count; i++) {
    const int count = read_curves(curves, tables, &precision_scenes[i]);
    cells[0] = precision_scenes[i].title;
    for (int k = 0; k < LEVELS; k++) {
      const double ratio = closest(curves, count, pow(10.0, -LOOSEST - k));
      text[k][0] = '\0';
      if (!isnan(ratio)) snprintf(text[k], sizeof text[k], ratio < 1.0 ? "%.2f" : "%.1f", ratio);
    }
    page_row(p, cells);
    print_markdown(cells, 1 + LEVELS);
  }
  page_table_end(p);
}

static void write_work(page *p, const char *folder) {
  static const char *const names[NAMES] = {"own.csv", "hand.csv", "heyoka.csv", "casadi.csv", "scipy.csv"};
  static work_curve curves[WORK_MOST_CURVES];
  table tables[NAMES];
  for (int i = 0; i < NAMES; i++) tables[i] = read_file(folder, names[i]);
  page_heading(p, 2, "Time against error");
  page_text(
      p,
      "Each point is one motion from its start to its end by one method at one setting: a tolerance, relative and absolute, or a "
      "number of equal steps. The error is that of the end state, the largest of |value − truth| / max(|truth|, 1) "
      "(0.01 for Andrews' mechanism), against closed forms or digits of quadruple precision; the program that judges is the same for "
      "all. CPU time is the least of repeats on one core, of the integration alone: what was derived, compiled and allocated before "
      "is not in it. Lower and to the left is better.");
  page_text(
      p,
      "In the tables stands the time in which the fastest of our methods reaches an error, between its points by interpolation of the "
      "logarithms, and what others take as multiples of it. ◀ stands where another is faster; a cell is empty where one of both does "
      "not get there, or does not have the scene. Bricard's mechanism nobody else has: its constraints depend on each other, and its "
      "mass "
      "matrix is singular.");
  write_overview(p, curves, tables);
  for (int i = 0; i < precision_scene_count; i++) {
    const int count = read_curves(curves, tables, &precision_scenes[i]);
    page_heading(p, 3, precision_scenes[i].title);
    draw_scene(p, &precision_scenes[i], curves, count);
    write_levels(p, curves, count);
  }
  for (int i = 0; i < NAMES; i++) table_free(&tables[i]);
}

/* ---- curves of any table ---- */

/* The points of a table whose rows pass a test, in two columns that are to be freed. */
typedef struct points {
  double *x, *y;
  int count;
} points;

typedef struct row_key {
  int column;
  const char *value;
} row_key;

static points points_of(const table *t, const row_key *keys, int nkey, const char *x, const char *y) {
  points z = {.x = malloc(((size_t)t->rows + 1) * sizeof(double)), .y = malloc(((size_t)t->rows + 1) * sizeof(double))};
  const int cx = table_column(t, x), cy = table_column(t, y);
  for (int row = 0; row < t->rows && z.x != NULL && z.y != NULL; row++) {
    bool fits = true;
    for (int k = 0; k < nkey; k++) fits = fits && strcmp(table_cell(t, row, keys[k].column), keys[k].value) == 0;
    if (!fits) continue;
    z.x[z.count] = table_number(t, row, cx);
    z.y[z.count++] = table_number(t, row, cy);
  }
  return z;
}

/* ---- energy ---- */

static void draw_energy(page *p, const table *t, const precision_scene *of) {
  const int names_at = table_column(t, "scene"), method = table_column(t, "method"), setting = table_column(t, "setting");
  page_series series[MOST_SERIES];
  points data[MOST_SERIES];
  char names[MOST_SERIES][TEXT_SIZE], title[TEXT_SIZE];
  int count = 0;
  for (int row = 0; row < t->rows && count < MOST_SERIES; row++) {
    const row_key keys[3] = {{names_at, of->name}, {method, table_cell(t, row, method)}, {setting, table_cell(t, row, setting)}};
    if (strcmp(table_cell(t, row, names_at), of->name) != 0) continue;
    snprintf(names[count], sizeof names[count], "%s, %s", keys[1].value, keys[2].value);
    bool known = false;
    for (int i = 0; i < count; i++) known = known || strcmp(names[i], names[count]) == 0;
    if (known) continue;
    const bool fixed = strncmp(keys[2].value, "steps", strlen("steps")) == 0;
    char as_timed[TEXT_SIZE];
    snprintf(as_timed, sizeof as_timed, "%s%s", keys[1].value, fixed ? " fixed" : "");
    const look *l = look_of("own", as_timed) != NULL ? look_of("own", as_timed) : look_of("sundials", as_timed);
    data[count] = points_of(t, keys, 3, "t", "energy_error");
    series[count] = (page_series){.name = names[count], .x = data[count].x, .y = data[count].y, .count = data[count].count, .look = 15};
    if (l != NULL) series[count].look = l->number, series[count].dashed = l->dashed, series[count].bold = l->bold;
    count++;
  }
  snprintf(title, sizeof title, "%s", of->scene->about);
  if (count > 0)
    page_draw(p, &(page_plot){.title = title,
                              .x = {.label = "time t, s"},
                              .y = {.label = "largest energy error so far, J", .log = true},
                              .series = series,
                              .count = count});
  for (int i = 0; i < count; i++) free(data[i].x), free(data[i].y);
}

static void write_energy(page *p, const char *folder) {
  table t = read_file(folder, "energy.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Energy over time");
    page_text(p, "|E − E₀| over a long time, by steps that each method chooses at one tolerance, and by equal steps. What a method "
                 "loses at each "
                 "step adds up; a symplectic one keeps it within bounds.");
    for (int i = 0; i < precision_scene_count; i++) draw_energy(p, &t, &precision_scenes[i]);
  }
  table_free(&t);
}

/* ---- cost against N ---- */

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

static void write_cost(page *p, const char *folder) {
  table t = read_file(folder, "cost.csv");
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

/* ---- Lyapunov exponents ---- */

static void write_lyapunov_table(page *p, const table *t) {
  const int columns[] = {table_column(t, "N"),           table_column(t, "table1"),        table_column(t, "t"),
                         table_column(t, "lambda_1"),    table_column(t, "interval_mean"), table_column(t, "interval_half_width"),
                         table_column(t, "energy_error")};
  page_table(p, NULL, "rrrrrr", (const char *const[]){"N", "Table 1, 1/s", "t, s", "λ₁(t), 1/s", "95 % interval", "energy error, J"});
  for (int i = 0; i < t->rows; i++) {
    char text[3][TEXT_SIZE];
    const double mean = table_number(t, i, columns[4]), half = table_number(t, i, columns[5]);
    snprintf(text[0], sizeof text[0], "%.5f", table_number(t, i, columns[3]));
    snprintf(text[1], sizeof text[1], "%.3f .. %.3f", mean - half, mean + half);
    snprintf(text[2], sizeof text[2], "%.1e", table_number(t, i, columns[6]));
    page_row(p, (const char *const[]){table_cell(t, i, columns[0]), table_cell(t, i, columns[1]), table_cell(t, i, columns[2]), text[0],
                                      text[1], text[2]});
  }
  page_table_end(p);
}

/* At most SHOWN points, the last one among them. */
static void thin_out(points *z) {
  const int each = (z->count + SHOWN - 1) / SHOWN;
  int kept = 0;
  for (int i = z->count == 0 ? 0 : (z->count - 1) % each; i < z->count; i += each, kept++) z->x[kept] = z->x[i], z->y[kept] = z->y[i];
  z->count = kept;
}

/* lambda_1.. of one number of links over time, the interval of the first, and what the paper's Table 1 has for it. */
static void draw_exponents(page *p, const char *folder, const table *summary, int row) {
  char file[TEXT_SIZE], title[TEXT_SIZE], names[LINKS][TEXT_SIZE];
  const int n = atoi(table_cell(summary, row, table_column(summary, "N")));
  const double end = table_number(summary, row, table_column(summary, "t")),
               printed = table_number(summary, row, table_column(summary, "table1")),
               mean = table_number(summary, row, table_column(summary, "interval_mean")),
               half = table_number(summary, row, table_column(summary, "interval_half_width"));
  const double ends[2] = {0.0, end}, means[2] = {mean, mean}, low[2] = {mean - half, mean - half}, high[2] = {mean + half, mean + half};
  const double table1[2] = {printed, printed};
  snprintf(file, sizeof file, "lyapunov/N%d.csv", n);
  table t = read_file(folder, file);
  points data[LINKS] = {{NULL, NULL, 0}};
  page_series series[LINKS + 2];
  int count = 0;
  double most = printed;
  series[count++] =
      (page_series){.name = "λ₁: interval of 95 %", .x = ends, .y = means, .low = low, .high = high, .count = 2, .look = 5};
  series[count++] =
      (page_series){.name = "the paper's Table 1", .x = ends, .y = table1, .count = 2, .look = 1, .dashed = true, .bold = true};
  for (int i = 0; i < n && i < LINKS && t.rows > 0; i++) {
    char column[TEXT_SIZE];
    snprintf(column, sizeof column, "lambda_%d", i + 1);
    snprintf(names[i], sizeof names[i], "λ%s", ((const char *const[]){"₁", "₂", "₃", "₄", "₅", "₆"})[i]);
    data[i] = points_of(&t, NULL, 0, "t", column);
    thin_out(&data[i]);
    series[count++] = (page_series){.name = names[i],
                                    .x = data[i].x,
                                    .y = data[i].y,
                                    .count = data[i].count,
                                    .bold = i == 0,
                                    .look = ((const int[]){0, 2, 3, 4, 6, 7})[i]};
  }
  for (int k = data[0].count / 20; k < data[0].count; k++) most = fmax(most, data[0].y[k]); /* the first seconds wander widely */
  snprintf(title, sizeof title, "%d link%s", n, n > 1 ? "s" : "");
  page_draw(
      p, &(page_plot){
             .title = title,
             .x = {.label = "time t, s"},
             .y = {.label = "running exponents, 1/s", .least = fmin(-0.1 * most, mean - half), .most = 1.1 * fmax(most, mean + half)},
             .series = series,
             .count = count});
  for (int i = 0; i < LINKS; i++) free(data[i].x), free(data[i].y);
  table_free(&t);
}

static void write_lyapunov(page *p, const char *folder) {
  table t = read_file(folder, "lyapunov/table1.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Lyapunov exponents");
    page_text(
        p,
        "The paper's pendulum of N links from 75 degrees: running exponents with Q re-orthonormalised and a step that keeps the energy "
        "(`pendulum --table1`), beside Table 1 and, in place of its Figs 3 to 5, over the same time. Table 1 holds for N = 1 and 2 "
        "only.");
    write_lyapunov_table(p, &t);
    for (int i = 0; i < t.rows; i++) draw_exponents(p, folder, &t, i);
  }
  table_free(&t);
}

/* ---- the page ---- */

static void write_notes(page *p, const char *folder) {
  char line[LINE_SIZE];
  FILE *file = open_file(folder, "notes.txt");
  if (file == NULL) return;
  page_heading(p, 2, "How it was measured");
  while (read_line(file, line, sizeof line)) page_text(p, "%s", line);
  fclose(file);
}

int main(int argc, char **argv) {
  page p;
  if (argc != 3) {
    fputs("usage: precision_report FOLDER PAGE.html: makes the page of the results that bench/precision/run left in a folder\n",
          stderr);
    return EXIT_USAGE;
  }
  const char *folder = argv[1];
  if (page_open(&p, argv[2], "libtaylor: speed against error") != 0) return EXIT_FAILED;
  page_text(
      &p,
      "Exact dynamics from plain C Lagrangians: what motions, linearisations and Lyapunov exponents cost for what they are wrong by, "
      "beside programs written by hand and other packages, all measured in one run by `scripts/report`.");
  write_facts(&p, folder);
  write_work(&p, folder);
  write_energy(&p, folder);
  write_cost(&p, folder);
  write_lyapunov(&p, folder);
  write_notes(&p, folder);
  return page_close(&p) == 0 && finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
}
