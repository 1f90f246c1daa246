/* Derivatives of motions by their start and by parameters beside references in 40 digits. */
#ifndef PRECISION_SENSITIVITY_H
#define PRECISION_SENSITIVITY_H

#include <stdbool.h>
#include <stdio.h>

/* Reads references as tests/data/sensitivity.txt has them and prints rows: model, way (`tangents` of eom/sensitivity.h, or
 * `differences` of the motion), how many columns there are, tolerance, errors (of the state in parts of its largest number; of
 * derivatives in parts of the largest number of their column), least CPU time, s. Returns an exit status. */
int sensitivity(FILE *references, bool quick);

#endif
