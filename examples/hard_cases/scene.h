/* The hard cases: mechanisms that break careless solvers, each with a start, a truth and what is asked of the result. */
#ifndef HARD_CASES_SCENE_H
#define HARD_CASES_SCENE_H

#include <eom/eom.h>

#include <stdbool.h>

enum { SCENE_MOST_COORDINATES = 128, SCENE_MOST_VALUES = 6 };

/* Reference digits at one time. */
typedef struct scene_digits {
  double t; /* s */
  double value[SCENE_MOST_VALUES];
} scene_digits;

/* Where a scene begins. */
typedef struct scene_start {
  const void *params;
  double q[SCENE_MOST_COORDINATES], qd[SCENE_MOST_COORDINATES];
} scene_start;

typedef struct scene {
  const char *name, *about; /* as on the command line; the mechanism and what is hard about it */
  const eom_model *model;
  void (*begin)(scene_start *start);

  double duration, quick; /* of the whole scene and of its short form, s */
  int outputs;            /* in the whole duration, at equal distances; those of the short form are the first of them */
  const char *method;     /* of integration */
  double step, tolerance; /* s; of a step's error, relative to the largest of 1 and each number: one of them is 0 */
  bool hold;              /* the rank is decided once per step (eom_hold) */
  double coarsest;        /* step that the figure of speed against error begins with, s; 0: no such figure */

  /* The error is the largest |value - truth| / max(|truth|, floor) over all values and outputs that have a truth. */
  const char *measured; /* what the values are */
  int values;
  void (*measure)(const double *y, double *value); /* of y = (q,qd) */
  void (*truth)(double t, double *value);          /* closed form; null where there are digits instead */
  const scene_digits *digits;
  int ndigits;
  double floor, required;

  double energy;                   /* largest error allowed of the energy less work(y), J; 0 where it is not conserved */
  double (*work)(const double *y); /* done by forces and drives from q = qd = 0 on, J; null for none */
  const char *source, *published;  /* who asks for `required`; what others take, for orientation; null where nothing is known */
} scene;

/* By the files that define them; all of them in the order in which they are listed. */
extern const scene scene_a01, scene_rod_thrice, scene_rod_scaled, scene_rod_mixed, scene_chain6, scene_chain16, scene_chain64,
    scene_heavy_above, scene_heavy_below, scene_snap, scene_spring;                                                 /* pendulums.c */
extern const scene scene_a02, scene_a02_2, scene_a03, scene_a04, scene_a05, scene_elastic_crank, scene_dead_points; /* mechanisms.c */
extern const scene scene_disk, scene_knife, scene_sleigh, scene_snakeboard;                                         /* rolling.c */
extern const scene scene_top, scene_kepler;                                                                         /* turning.c */
extern const scene *const scenes[];
extern const int nscenes;

/* The scene of that name, or null. */
const scene *scene_find(const char *name);

/* The error of the state y = (q,qd) at t; NaN where there is no truth then. */
double scene_error(const scene *s, double t, const double *y);

#endif
