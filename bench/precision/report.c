/* precision_report: the page that scripts/report makes of what was measured. */
#include "report.h"
#include "host/message.h"
#include "host/page.h"
#include "scenes.h"
#include "work.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char program[] = "precision_report";

enum { PATH_SIZE = 4096, TEXT_SIZE = 256, LINE_SIZE = 4096, MOST_SERIES = 64 };

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

/* The shortest time of another package as a multiple of ours, and who it is; NaN where one of both does not get there. */
static double closest(const work_curve *curves, int count, double error, int *who) {
  const int best = work_fastest(curves, count, is_ours, error);
  double ratio = (double)NAN;
  for (int r = 0; r < RIVALS && best >= 0; r++) {
    const int other = is_rival[r] == is_hand ? -1 : work_fastest(curves, count, is_rival[r], error);
    const double here = other >= 0 ? work_time(&curves[other], error) / work_time(&curves[best], error) : (double)NAN;
    if (!isnan(here) && !(here >= ratio)) ratio = here, *who = r;
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

/* "heyoka, CasADi": those that are ahead of us at some error. */
static void list_rivals(char *text, const bool *ahead) {
  int length = 0;
  text[0] = '\0';
  for (int r = 0; r < RIVALS; r++)
    if (ahead[r]) length += snprintf(text + length, (size_t)(TEXT_SIZE - length), "%s%s", length > 0 ? ", " : "", rival_titles[r]);
}

/* On the page, and on standard output, where there is room for one more column. */
static void write_overview(page *p, work_curve *curves, const table *tables) {
  char text[LEVELS + 1][TEXT_SIZE];
  const char *cells[2 + LEVELS] = {"scene"};
  for (int k = 0; k < LEVELS; k++) {
    snprintf(text[k], sizeof text[k], "1e-%d", LOOSEST + k);
    cells[1 + k] = text[k];
  }
  cells[1 + LEVELS] = "ahead";
  print_markdown(cells, 2 + LEVELS);
  for (int i = 0; i < 2 + LEVELS; i++) fputs("|---", stdout);
  puts("|");
  page_table(p, "The fastest other package at each error: its time as a multiple of ours; below 1 it is ahead", "lrrrrrrrr", cells);
  for (int i = 0; i < precision_scene_count; i++) {
    const int count = read_curves(curves, tables, &precision_scenes[i]);
    bool ahead[RIVALS] = {false};
    int who = 0;
    cells[0] = precision_scenes[i].title;
    for (int k = 0; k < LEVELS; k++) {
      const double ratio = closest(curves, count, pow(10.0, -LOOSEST - k), &who);
      if (ratio < 1.0) ahead[who] = true;
      text[k][0] = '\0';
      if (!isnan(ratio)) snprintf(text[k], sizeof text[k], ratio < 1.0 ? "%.2f" : "%.1f", ratio);
    }
    list_rivals(text[LEVELS], ahead);
    cells[1 + LEVELS] = text[LEVELS];
    page_row(p, cells);
    print_markdown(cells, 2 + LEVELS);
  }
  page_table_end(p);
}

static void write_work(page *p, const char *folder) {
  static const char *const names[NAMES] = {"own.csv", "hand.csv", "heyoka.csv", "casadi.csv", "scipy.csv"};
  static work_curve curves[WORK_MOST_CURVES];
  table tables[NAMES];
  for (int i = 0; i < NAMES; i++) tables[i] = report_table(folder, names[i]);
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

/* ---- energy ---- */

static void draw_energy(page *p, const table *t, const precision_scene *of) {
  const int names_at = table_column(t, "scene"), method = table_column(t, "method"), setting = table_column(t, "setting");
  page_series series[MOST_SERIES];
  report_curve data[MOST_SERIES];
  char names[MOST_SERIES][TEXT_SIZE], title[TEXT_SIZE];
  int count = 0;
  for (int row = 0; row < t->rows && count < MOST_SERIES; row++) {
    const report_key keys[3] = {{names_at, of->name}, {method, table_cell(t, row, method)}, {setting, table_cell(t, row, setting)}};
    if (strcmp(table_cell(t, row, names_at), of->name) != 0) continue;
    snprintf(names[count], sizeof names[count], "%s, %s", keys[1].value, keys[2].value);
    bool known = false;
    for (int i = 0; i < count; i++) known = known || strcmp(names[i], names[count]) == 0;
    if (known) continue;
    const bool fixed = strncmp(keys[2].value, "steps", strlen("steps")) == 0;
    char as_timed[TEXT_SIZE];
    snprintf(as_timed, sizeof as_timed, "%s%s", keys[1].value, fixed ? " fixed" : "");
    const look *l = look_of("own", as_timed) != NULL ? look_of("own", as_timed) : look_of("sundials", as_timed);
    data[count] = report_points(t, keys, 3, "t", "energy_error");
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
  for (int i = 0; i < count; i++) report_free(&data[i]);
}

static void write_energy(page *p, const char *folder) {
  table t = report_table(folder, "energy.csv");
  if (t.rows > 0) {
    page_heading(p, 2, "Energy over time");
    page_text(p, "|E − E₀| over a long time, by steps that each method chooses at one tolerance, and by equal steps. What a method "
                 "loses at each "
                 "step adds up; a symplectic one keeps it within bounds.");
    for (int i = 0; i < precision_scene_count; i++) draw_energy(p, &t, &precision_scenes[i]);
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
  report_sensitivity(&p, folder);
  report_cost(&p, folder);
  report_lyapunov(&p, folder);
  write_notes(&p, folder);
  return page_close(&p) == 0 && finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
}
