/* How a motion is followed: the method, its tolerances or step, and how constraints are held, from options. */
#include "method.h"

#include "host/message.h"
#include "host/nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double usual_tolerance = 1e-10;

/* Below it errors in parts of the tolerance overflow. */
static const double least_tolerance = 1e-100;

const method method_default = {.rtol = -1.0, .atol = -1.0}; /* not given */

option method_name(const char **name, const char *help) {
  return (option){.name = "--method", .kind = OPTION_TEXT, .value = name, .operand = "NAME", .help = help};
}

option method_rtol(double *rtol, const char *help) {
  return (option){.name = "--rtol", .kind = OPTION_REAL, .value = rtol, .most = 1.0, .operand = "TOL", .help = help};
}

option method_atol(double *atol, const char *help) {
  return (option){.name = "--atol", .kind = OPTION_REAL, .value = atol, .most = HUGE_VAL, .operand = "TOL", .help = help};
}

option method_step(double *step, const char *help) {
  return (option){.name = "--step", .kind = OPTION_ABOVE, .value = step, .most = HUGE_VAL, .operand = "H", .help = help};
}

void method_options(method *m, option *table) {
  const option own[METHOD_OPTIONS] = {
      method_name(&m->name, "how to integrate, see below; default dop853"),
      method_rtol(&m->rtol, "relative tolerance of each step; default 1e-10"),
      method_atol(&m->atol, "absolute tolerance of each step; default 1e-10"),
      method_step(&m->step, "fixed steps of H s in the place of tolerances"),
      {.name = "--no-projection",
       .kind = OPTION_FLAG,
       .value = &m->free,
       .help = "do not bring the state back onto the constraints after\neach step"},
      {.name = "--baumgarte",
       .kind = OPTION_REAL,
       .value = &m->baumgarte,
       .most = HUGE_VAL,
       .operand = "A",
       .help = "hold constraints by Baumgarte's terms with alpha = beta = A 1/s\nin the place of projection"},
  };
  memcpy(table, own, sizeof own);
}

const eom_trajectory_method *method_find(const char *given_by, const char *name) {
  const eom_trajectory_method *m;
  const char *near = NULL;
  char names[1024] = "";
  for (int i = 0; (m = eom_trajectory_method_at(i)) != NULL; i++) {
    if (strcmp(m->name, name) == 0) return m;
    near = nearer(name, near, m->name);
    strncat(names, i > 0 ? ", " : "", sizeof names - strlen(names) - 1);
    strncat(names, m->name, sizeof names - strlen(names) - 1);
  }
  if (near != NULL) usage_error("%s %s: no such method; did you mean %s? There are %s", given_by, name, near, names);
  usage_error("%s %s: no such method; there are %s", given_by, name, names);
}

void method_complete_tolerances(double step, double *rtol, double *atol) {
  if (step > 0.0 && (*rtol >= 0.0 || *atol >= 0.0))
    usage_error("--step and --rtol or --atol: steps are fixed, or chosen by tolerances");
  if (*rtol < 0.0) *rtol = step > 0.0 ? 0.0 : usual_tolerance;
  if (*atol < 0.0) *atol = step > 0.0 ? 0.0 : usual_tolerance;
  if (step == 0.0 && *rtol == 0.0 && *atol == 0.0) usage_error("--rtol 0 --atol 0: one of them must be above zero");
  if (step == 0.0 && fmax(*rtol, *atol) < least_tolerance)
    usage_error("--rtol %g --atol %g: one of them must be at least %g", *rtol, *atol, least_tolerance);
}

static bool is_of_sundials(const eom_trajectory_method *m) {
  return strncmp(m->name, "cvode_", 6) == 0 || strncmp(m->name, "arkode_", 7) == 0;
}

void method_complete(method *m) {
  m->found = m->name != NULL ? method_find("--method", m->name) : eom_trajectory_method_at(0);
  if (m->step > 0.0 && !m->found->fixed) usage_error("--step: %s chooses its steps itself; give --rtol and --atol", m->found->name);
  if (m->step == 0.0 && !m->found->chosen) usage_error("--method %s takes fixed steps: give --step", m->found->name);
  method_complete_tolerances(m->step, &m->rtol, &m->atol);
  if (m->step == 0.0 && m->atol == 0.0 && is_of_sundials(m->found)) usage_error("--atol 0: %s wants it above zero", m->found->name);
  if (m->baumgarte > 0.0) m->free = true;
}

int method_check_step(double step, double t0, double t_end) {
  const double largest = fmax(fabs(t0), fabs(t_end));
  if (step == 0.0 || largest + step != largest) return 0;
  complain("--step %g: too short to be told from zero beside t = %g s", step, largest);
  return -1;
}

eom_options method_system_options(const method *m, unsigned needs) {
  eom_options options = eom_options_default();
  options.needs = needs | (m->found->implicit ? EOM_NEED_LINEARISE : 0u);
  options.baumgarte = (eom_baumgarte){m->baumgarte, m->baumgarte};
  return options;
}

eom_trajectory_options method_trajectory_options(const method *m, const setup *s) {
  return (eom_trajectory_options){.method = m->found->name,
                                  .control = {.rtol = m->rtol, .atol = m->atol},
                                  .h = m->step,
                                  .project = s->sys->m > 0 && !m->free && m->found->projects};
}

const char *method_list(void) {
  static char text[4096];
  const eom_trajectory_method *m;
  text[0] = '\0';
  for (int i = 0; (m = eom_trajectory_method_at(i)) != NULL; i++)
    snprintf(text + strlen(text), sizeof text - strlen(text), "  %-18s %s%s\n", m->name, m->text,
             m->projects ? "" : "; cannot project");
  return text;
}
