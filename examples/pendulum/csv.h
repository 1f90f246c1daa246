/* The rows of a run as comma-separated values. */
#ifndef PENDULUM_CSV_H
#define PENDULUM_CSV_H

#include "host/output.h"
#include "run.h"

/* Opens the file and writes the header t,lambda_1..lambda_2N,mean_1..mean_2N,half_width_1..half_width_2N,energy_error,
 * orthogonality_error, so that a place that cannot be written to is known before the run. Units: s, 1/s, J, 1. Both return 0, or -1
 * after a message. */
int csv_begin(output *o, const char *path, int links);

/* Writes the rows and puts the file in place. */
int csv_end(output *o, const run *r);

#endif
