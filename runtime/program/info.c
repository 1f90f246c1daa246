/* eom info: what a model is made of. */
#include "command.h"
#include "host/message.h"
#include "setup.h"

#include <stdio.h>
#include <string.h>

static const manual text = {
    .command = "info",
    .operands = "MODEL.so ",
    .summary = "Prints a model's functions, sizes and parameters, and who evaluates it, with values as --start and --set give\n"
               "them.\n"
               "\nExit status: 0 done, 1 standard output failed, 2 wrong options.\n",
    .examples = "  eom info pendulum.so\n"
                "  eom info pendulum.so --set n=3 --set g=9.81 --set mass=1 --set length=1\n",
};

static void print_function(const char *role, const eom_function *f, const setup *s) {
  if (f->jet == NULL) return;
  printf("  %-13s %s (%s)", role, f->name, f->source);
  if (s->sys != NULL && f->rows != NULL && strcmp(role, "Lagrangian") != 0 && strcmp(role, "dissipation") != 0)
    printf(", %d row%s", f->rows(s->model.params), f->rows(s->model.params) == 1 ? "" : "s");
  putchar('\n');
}

static const char *type_of(const eom_parameter *p) {
  switch (p->number) {
  case EOM_NUMBER_REAL:
    return p->size == sizeof(float) ? "float" : "double";
  case EOM_NUMBER_INTEGER:
    return "integer";
  case EOM_NUMBER_UNSIGNED:
    return "unsigned";
  case EOM_NUMBER_BOOL:
    return "bool";
  case EOM_NUMBER_NONE:
    break;
  }
  return "cannot be set";
}

enum { SHOWN = 8 /* elements of an array */ };

static void print_parameter(const model *m, const eom_parameter *p) {
  char name[160];
  const int count = parameter_count(p);
  snprintf(name, sizeof name, p->count > 0 ? "%s[%d]" : "%s", p->name, p->count);
  printf("  %-20s %-8s", name, type_of(p));
  int same = 1;
  while (same < count && parameter_value(m, p, same) == parameter_value(m, p, 0)) same++;
  if (count > 0) printf(" =");
  for (int i = 0; i < count && i < (same == count ? 1 : SHOWN); i++)
    printf(" %.*g", p->number == EOM_NUMBER_REAL ? 10 : 17, parameter_value(m, p, i));
  if (count > 1 && same == count) fputs(" (all)", stdout);
  if (same < count && count > SHOWN) fputs(" ..", stdout);
  if (p->text != NULL) printf("   %s", p->text);
  putchar('\n');
}

static void print_who(const setup *s) {
  static const struct {
    eom_task task;
    const char *name;
  } tasks[] = {{EOM_TASK_ENERGY, "energy"},
               {EOM_TASK_ASSEMBLE, "motion"},
               {EOM_TASK_LINEARISE, "linearise"},
               {EOM_TASK_RESIDUAL, "residual"},
               {EOM_TASK_TANGENT, "tangent"}};
  printf("Evaluated by motion functions of this size, or by calls on jets:\n ");
  for (size_t i = 0; i < sizeof tasks / sizeof tasks[0]; i++)
    printf("%s %s by %s", i > 0 ? "," : "", tasks[i].name,
           eom_system_emitter(s->sys, tasks[i].task) == EOM_EMITTER_MOTION ? "motion functions" : "calls");
  putchar('\n');
}

static void print_model(const setup *s) {
  const eom_model *m = s->model.description->model;
  printf("Model %s, %s\n", m->name, s->model.path);
  print_function("Lagrangian", &m->lagrangian, s);
  print_function("force", &m->force, s);
  print_function("dissipation", &m->dissipation, s);
  for (int i = 0; i < m->nholonomic; i++) print_function("holonomic", &m->holonomic[i], s);
  for (int i = 0; i < m->nnonholonomic; i++) print_function("nonholonomic", &m->nonholonomic[i], s);
  for (int i = 0; i < m->nmotion; i++)
    printf("Motion functions for %d coordinates, %d holonomic and %d nonholonomic rows%s%s\n", m->motion[i]->n, m->motion[i]->m1,
           m->motion[i]->m2, m->motion[i]->autonomous ? "; time occurs nowhere" : "",
           m->motion[i]->constant_mass ? "; the mass matrix is constant" : "");
  for (int i = 0; i < m->nmotion; i++)
    if (m->motion[i]->taylor != NULL) printf("Taylor series of the motion for %d coordinates: --method taylor\n", m->motion[i]->n);
  const eom_description *d = s->model.description;
  printf(d->nparameter > 0 ? "Parameters\n" : "No parameters\n");
  for (int i = 0; i < d->nparameter; i++) print_parameter(&s->model, &d->parameter[i]);
}

/* Sizes are known only with the parameters that they depend on. */
static void print_sizes(const setup *s) {
  printf("Coordinates: %d", s->n);
  if (s->model.description->coordinate != NULL)
    for (int i = 0; i < s->n; i++) printf("%s %s", i == 0 ? ":" : ",", component_name(s, i));
  if (s->model.description->velocity != NULL)
    for (int i = 0; i < s->n; i++) printf("%s %s", i == 0 ? "; velocities:" : ",", component_name(s, s->n + i));
  printf("\nConstraint rows: %d holonomic, %d nonholonomic\n", s->sys->m1, s->sys->m2);
  print_who(s);
}

int info_command(int argc, char **argv) {
  setup s = {.n = 0};
  option table[SETUP_OPTIONS];
  setup_options(&s, table);
  setup_read(&s, argc, argv, table, SETUP_OPTIONS, &text);
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT;
  s.any_size = true;
  if (setup_load(&s, s.model.path, &options) != 0) return refuse();
  print_model(&s);
  if (s.n > 0)
    print_sizes(&s);
  else
    printf("The number of coordinates depends on parameters: give them with --set or --start\n");
  setup_close(&s);
  return finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
}
