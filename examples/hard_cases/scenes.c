/* The table of the hard cases. */
#include "scene.h"

#include <string.h>

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
