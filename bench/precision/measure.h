/* One motion by one method at one setting, timed; and what is said of it in a row of results. */
#ifndef PRECISION_MEASURE_H
#define PRECISION_MEASURE_H

#include "scenes.h"

#include <eom/trajectory.h>

#include <stdio.h>

/* Of a contender's motion to the end of a scene. */
typedef struct measurement {
  const char *scene, *contender, *method, *setting;
  double cpu, cpu_median;     /* s: least and middle one of the repeats, of the integration alone */
  double error, energy_error; /* at the end; J, NaN where the scene conserves none */
  long steps, evaluations;    /* evaluations of accelerations; 0: not known */
} measurement;

/* CPU time of this process, s. */
double cpu_seconds(void);

void print_measurement_head(void);
void print_measurement(const measurement *m);

/* A system of the scene as a method wants it, with a consistent start y0: 2n. Null where there is none. */
eom_system *scene_system(const precision_scene *p, const eom_trajectory_method *method, double *y0);

/* Energy less the work done by forces and drives, J; NaN where it is none to be conserved, or where there is no energy. */
double scene_balance(const precision_scene *p, eom_system *sys, const double *y, double t);

/* Fills errors of m from the state y at the end of the scene. sys and y0 as scene_system made them. */
void judge(measurement *m, const precision_scene *p, eom_system *sys, const double *y0, const double *y);

/* How long and how often one setting may be repeated. */
typedef struct effort {
  double seconds; /* in all */
  int repeats;    /* at least one, at most these */
} effort;

/* Follows the scene with these options (method, control or h) and fills m but for its names. Returns the status of the motion. */
eom_status measure(measurement *m, const precision_scene *p, eom_system *sys, const double *y0, const eom_trajectory_options *options,
                   effort allowed);

#endif
