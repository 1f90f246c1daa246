/* The table of the hard cases. */
#include "scene.h"

#include <math.h>
#include <string.h>

/* Two times that differ by less, in parts of the duration, are the same. */
static const double same_time = 1e-9;

const scene *const scenes[] = {
    &scene_a01,           &scene_a02,         &scene_a02_2,  &scene_a03,        &scene_a04,        &scene_a05,
    &scene_elastic_crank, &scene_dead_points, &scene_chain6, &scene_chain16,    &scene_chain64,    &scene_top,
    &scene_disk,          &scene_knife,       &scene_sleigh, &scene_snakeboard, &scene_kepler,     &scene_spring,
    &scene_heavy_above,   &scene_heavy_below, &scene_snap,   &scene_rod_thrice, &scene_rod_scaled, &scene_rod_mixed,
};
const int nscenes = sizeof scenes / sizeof scenes[0];

const scene *scene_find(const char *name) {
  for (int i = 0; i < nscenes; i++)
    if (strcmp(scenes[i]->name, name) == 0) return scenes[i];
  return NULL;
}

/* Whether there is a truth at t, and its values. */
static bool truth_at(const scene *s, double t, double *value) {
  if (s->truth != NULL) s->truth(t, value);
  for (int i = 0; s->truth == NULL && i < s->ndigits; i++) {
    if (fabs(s->digits[i].t - t) > same_time * s->duration) continue;
    for (int k = 0; k < s->values; k++) value[k] = s->digits[i].value[k];
    return true;
  }
  return s->truth != NULL;
}

double scene_error(const scene *s, double t, const double *y) {
  double truth[SCENE_MOST_VALUES], value[SCENE_MOST_VALUES], worst = 0.0;
  if (!truth_at(s, t, truth)) return (double)NAN;
  s->measure(y, value);
  for (int i = 0; i < s->values; i++) {
    const double error = fabs(value[i] - truth[i]) / fmax(fabs(truth[i]), s->floor);
    worst = fmax(worst, isnan(error) ? HUGE_VAL : error);
  }
  return worst;
}
