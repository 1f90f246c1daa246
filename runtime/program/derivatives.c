/* Derivatives of a motion: their names, their place in rows, and what is printed of them. */
#include "derivatives.h"

#include "host/message.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- names ---- */

/* "p->mass[1]" is named mass[1]. */
static const char *member(const char *parameter) {
  const char *arrow = strstr(parameter, "->");
  return arrow != NULL ? arrow + 2 : parameter;
}

static int parameter_named(const eom_system *sys, const char *name) {
  const eom_motion *motion = sys->options.needs & EOM_NEED_PARAMETERS ? sys->motion : NULL;
  for (int k = 0; motion != NULL && k < motion->np; k++)
    if (strcmp(member(motion->parameter[k]), name) == 0) return k;
  return -1;
}

static int unknown(const derivatives *d, const char *name) {
  char names[512] = "";
  const eom_motion *motion = d->sys->options.needs & EOM_NEED_PARAMETERS ? d->sys->motion : NULL;
  for (int k = 0; motion != NULL && k < motion->np; k++)
    snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", k > 0 ? ", " : "", member(motion->parameter[k]));
  if (motion == NULL)
    complain("--sensitivity %s: no coordinate or velocity; derivatives by parameters need a model made with --need parameters", name);
  else
    complain("--sensitivity %s: no coordinate or velocity, nor one of the parameters that the model has derivatives by: %s", name,
             names);
  return -1;
}

/* Initial values first: two passes over the list. */
static int read_names(derivatives *d, const setup *s, const char *text) {
  int parameters = 0;
  for (int pass = 0; pass < 2; pass++)
    for (const char *at = text; *at != '\0'; at += strcspn(at, ","), at += *at == ',') {
      char name[64];
      const size_t length = strcspn(at, ",");
      if (length == 0 || length >= sizeof name) return complain("--sensitivity %s: write names with commas between them", text), -1;
      memcpy(name, at, length);
      name[length] = '\0';
      const int component = component_named(s, name), parameter = component < 0 ? parameter_named(d->sys, name) : -1;
      if (component < 0 && parameter < 0) return unknown(d, name);
      if ((component >= 0) != (pass == 0)) continue;
      if (d->count == DERIVATIVES_MOST) return complain("--sensitivity: at most %d names", DERIVATIVES_MOST), -1;
      for (int k = 0; k < d->count; k++)
        if (strcmp(d->name[k], name) == 0) return complain("--sensitivity %s: %s is there twice", text, name), -1;
      if (pass == 0) d->component[d->count] = component;
      if (pass == 1) d->parameter[parameters++] = parameter;
      snprintf(d->name[d->count++], sizeof d->name[0], "%s", name);
    }
  d->columns.parameters = parameters;
  return 0;
}

/* ---- start and end ---- */

/* A system with derivatives by parameters where the model has them. */
static eom_status make_system(derivatives *d, const setup *s, const method *how) {
  const unsigned needs[] = {EOM_NEED_TANGENT | EOM_NEED_PARAMETERS, EOM_NEED_TANGENT};
  eom_status status = EOM_BAD_OPTION;
  for (int k = 0; k < 2 && status == EOM_BAD_OPTION; k++) {
    const eom_options options = method_system_options(how, needs[k]);
    status = eom_system_create(&d->sys, s->model.description->model, s->model.params, &options);
  }
  return status;
}

static int make_columns(derivatives *d) {
  const int parameters = d->columns.parameters, directions = d->count - parameters;
  d->work = calloc(eom_sensitivity_size(d->sys, directions, parameters), sizeof *d->work);
  if (d->work == NULL ||
      eom_sensitivity_init(&d->columns, d->sys, directions, parameters, parameters > 0 ? d->parameter : NULL, d->work) != EOM_OK)
    return complain("no memory for derivatives"), -1;
  d->z = calloc((size_t)d->columns.dim, sizeof *d->z);
  return d->z != NULL ? 0 : (complain("no memory for derivatives"), -1);
}

int derivatives_open(derivatives *d, const setup *s, const method *how, const char *text) {
  *d = (derivatives){.count = 0};
  if (text == NULL) return 0;
  if (!how->found->columns) return complain("--sensitivity: %s follows no derivatives", how->found->name), -1;
  const eom_status status = make_system(d, s, how);
  if (status != EOM_OK) return complain("--sensitivity: %s", eom_status_text(status)), -1;
  if (read_names(d, s, text) == 0 && make_columns(d) == 0) return 0;
  derivatives_close(d);
  return -1;
}

void derivatives_close(derivatives *d) {
  eom_system_destroy(d->sys);
  free(d->z);
  free(d->work);
  *d = (derivatives){.count = 0};
}

/* Steps of a parameter, in parts of it, for the difference of fourth order: the error is this to the power of four, and rounding over
 * it.
 */
static const double change = 1e-3;

/* The start of column k as a function of its parameter, which sys reads anew: what was given, brought onto the constraints. y: 2n. */
static eom_status moved_start(derivatives *d, const setup *s, int k, double by, double *y) {
  model m = s->model;
  int i;
  const eom_parameter *p = setup_parameter(s, d->name[k], &i);
  eom_projection projection = setup_projection(s);
  const int element = i < 0 ? 0 : i;
  const double value = parameter_value(&m, p, element);
  if (parameter_store(&m, p, element, value + by * (fabs(value) > 0.0 ? fabs(value) : 1.0)) != NULL) return EOM_BAD_OPTION;
  memcpy(y, s->given != NULL ? s->given : s->q, 2 * (size_t)s->n * sizeof *y);
  const eom_status status = eom_project(d->sys, y, y + s->n, s->t0, &projection);
  parameter_store(&m, p, element, value);
  return status;
}

/* Where constraints or what they weigh contain the parameter, the start that satisfies them depends on it: dy0/dp by a difference. */
static eom_status start_column(derivatives *d, const setup *s, int k) {
  static const double at[4] = {-2.0, -1.0, 1.0, 2.0}, weight[4] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0};
  const int rows = 2 * s->n;
  int i;
  const eom_parameter *p = setup_parameter(s, d->name[k], &i);
  const double value = p != NULL ? parameter_value(&s->model, p, i < 0 ? 0 : i) : (double)NAN;
  const double unit = change * (fabs(value) > 0.0 ? fabs(value) : 1.0);
  double *y = calloc((size_t)rows, sizeof *y);
  eom_status status = y == NULL ? EOM_NO_MEMORY : isfinite(value) ? EOM_OK : EOM_BAD_OPTION;
  for (int j = 0; j < 4 && status == EOM_OK; j++) {
    status = moved_start(d, s, k, at[j] * change, y);
    for (int row = 0; row < rows && status == EOM_OK; row++) d->z[rows + row * d->count + k] += weight[j] / unit * y[row];
  }
  free(y);
  return status;
}

eom_status derivatives_start(derivatives *d, const setup *s) {
  const int rows = 2 * s->n;
  memset(d->z, 0, (size_t)d->columns.dim * sizeof *d->z);
  memcpy(d->z, s->q, (size_t)rows * sizeof *d->z);
  for (int k = 0; k < d->columns.directions; k++) d->z[rows + d->component[k] * d->count + k] = 1.0;
  for (int k = d->columns.directions; k < d->count && d->sys->m > 0; k++) {
    const eom_status status = start_column(d, s, k);
    if (status == EOM_OK) continue;
    complain("--sensitivity %s: the start does not satisfy the constraints with other values of it", d->name[k]);
    return status;
  }
  return eom_sensitivity_project(&d->columns, s->t0, d->z);
}

/* ---- what is shown ---- */

int derivatives_add_columns(const derivatives *d, const setup *s, series *rows) {
  if (d->count == 0) return 0;
  const int first = rows->width;
  if (series_group_add(rows, "sensitivity", 2 * s->n * d->count) != 0) return -1;
  for (int i = 0; i < 2 * s->n; i++)
    for (int k = 0; k < d->count; k++)
      snprintf(rows->name[first + i * d->count + k], sizeof rows->name[0], "d %.28s/d %.28s", component_name(s, i), d->name[k]);
  return 0;
}

void derivatives_print(const derivatives *d, const setup *s) {
  if (d->count == 0) return;
  printf("Derivatives there\n  %-12s", "by");
  for (int k = 0; k < d->count; k++) printf(" %16s", d->name[k]);
  for (int i = 0; i < 2 * s->n; i++) {
    printf("\n  %-12s", component_name(s, i));
    for (int k = 0; k < d->count; k++) printf(" %16.9g", d->z[2 * s->n + i * d->count + k]);
  }
  printf("\n");
}
