/* Curves of time against error. */
#include "work.h"

#include <math.h>
#include <string.h>

static work_curve *curve_of(work_curve *curves, int *count, const char *contender, const char *method) {
  for (int i = 0; i < *count; i++)
    if (strcmp(curves[i].contender, contender) == 0 && strcmp(curves[i].method, method) == 0) return &curves[i];
  if (*count == WORK_MOST_CURVES) return NULL;
  curves[*count] = (work_curve){.contender = contender, .method = method};
  return &curves[(*count)++];
}

int work_read(work_curve *curves, int count, const table *t, const char *scene) {
  const int scenes = table_column(t, "scene"), contender = table_column(t, "contender"), method = table_column(t, "method");
  const int cpu = table_column(t, "cpu_s"), error = table_column(t, "error"), energy = table_column(t, "energy_error");
  for (int row = 0; row < t->rows; row++) {
    if (strcmp(table_cell(t, row, scenes), scene) != 0) continue;
    work_curve *c = curve_of(curves, &count, table_cell(t, row, contender), table_cell(t, row, method));
    if (c == NULL || c->count == WORK_MOST_POINTS) continue;
    c->cpu[c->count] = table_number(t, row, cpu);
    c->error[c->count] = table_number(t, row, error);
    c->energy[c->count++] = table_number(t, row, energy);
  }
  return count;
}

/* Between points a and b on either side of the error. */
static double between(const work_curve *c, int a, int b, double error) {
  const double part = log(error / c->error[a]) / log(c->error[b] / c->error[a]);
  return c->cpu[a] * pow(c->cpu[b] / c->cpu[a], part);
}

double work_time(const work_curve *c, double error) {
  double least = (double)NAN;
  for (int i = 0; i < c->count; i++) {
    if (c->error[i] <= error) least = fmin(least, c->cpu[i]);
    if (i > 0 && c->error[i] > 0.0 && c->error[i - 1] > error && c->error[i] < error) least = fmin(least, between(c, i - 1, i, error));
  }
  return least;
}

int work_fastest(const work_curve *curves, int count, bool (*of)(const char *contender), double error) {
  int best = -1;
  for (int i = 0; i < count; i++) {
    if (!of(curves[i].contender)) continue;
    const double time = work_time(&curves[i], error);
    if (!isnan(time) && (best < 0 || time < work_time(&curves[best], error))) best = i;
  }
  return best;
}
