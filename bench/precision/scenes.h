/* The scenes of the report: motions with a truth at their end, those of the hard cases among them. */
#ifndef PRECISION_SCENES_H
#define PRECISION_SCENES_H

#include "scene.h"

typedef struct precision_scene {
  const char *name, *title;
  const scene *scene;
  double t_end;  /* s: the scene has a truth then */
  double orbit;  /* s: for how long its energy is watched; 0: not */
  long coarsest; /* fixed steps to t_end that a figure begins with */
} precision_scene;

extern const precision_scene precision_scenes[];
extern const int precision_scene_count;

/* The scene of that name, or null. */
const precision_scene *precision_scene_find(const char *name);

#endif
