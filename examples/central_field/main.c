/* central_field: the equations of constrained motion in a central field beside their closed form, then an orbit (paper, sect. 5.1). */
#include "agreement.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/options.h"
#include "host/output.h"
#include "orbit.h"

#include <math.h>
#include <stdio.h>

const char program[] = "central_field";

static const double most_steps = 1e9; /* of one orbit: more would take hours and gigabytes of rows */
static const double most_eccentric = 0.999;

static const char *const kinetic_names[] = {"full", "reduced", NULL}; /* in the order of enum kinetic */

static const manual text = {
    .summary = "A particle in the field V = -mu m/r, in the coordinates q = (r, u) with the constraint |u|^2 = 1. Prints the mass\n"
               "matrix M, the force Q, the constraint's A and b and the acceleration, computed from the Lagrangian alone, beside\n"
               "the closed form (eqs 67-71); compares both at random states; then integrates an orbit.\n",
    .examples = "  central_field                                T = m/2 |d(r u)/dt|^2 as it stands: M is singular\n"
                "  central_field --kinetic reduced              T = m/2 (rd^2 + r^2 |ud|^2): M is diagonal\n"
                "  central_field --eccentricity 0.99 --periods 1 --csv orbit.csv\n",
};

int main(int argc, char **argv) {
  orbit_request ask = {.eccentricity = 0.3, .periods = 10.0};
  int kind = KINETIC_FULL, states = 1000;
  const option table[] = {
      {.name = "--kinetic",
       .kind = OPTION_CHOICE,
       .value = &kind,
       .choices = kinetic_names,
       .operand = "full|reduced",
       .help = "\nkinetic energy as it stands, or reduced with |u| = 1; default full"},
      {.name = "--states",
       .kind = OPTION_COUNT,
       .value = &states,
       .least = 1,
       .most = 1e6,
       .operand = "K",
       .help = "number of random states to compare at; default 1000"},
      {.name = "--eccentricity",
       .kind = OPTION_REAL,
       .value = &ask.eccentricity,
       .most = most_eccentric,
       .operand = "E",
       .help = "of the orbit; default 0.3"},
      {.name = "--periods",
       .kind = OPTION_ABOVE,
       .value = &ask.periods,
       .most = HUGE_VAL,
       .operand = "P",
       .help = "length of the integration in periods of 2 pi s; default 10"},
      {.name = "--step",
       .kind = OPTION_ABOVE,
       .value = &ask.step,
       .most = HUGE_VAL,
       .operand = "H",
       .help = "fixed step of the integration, s; default: by the speed at the pericentre"},
      {.name = "--csv",
       .kind = OPTION_TEXT,
       .value = &ask.csv,
       .operand = "FILE",
       .help = "write t,r,u1,u2,u3,phi,energy_error,momentum_error for every step"},
  };
  read_options(argc, argv, table, sizeof table / sizeof table[0], &text);
  ask.kind = (kinetic)kind;
  double length = ask.periods * 2.0 * acos(-1.0);
  if (ask.step > length) usage_error("--step %g is longer than the orbit of %g s; take a shorter one", ask.step, length);
  if (ask.step > 0.0 && length / ask.step > most_steps) usage_error("--step %g: that makes more than %g steps", ask.step, most_steps);
  watch_interrupts();
  if (ask.csv != NULL && output_check(ask.csv) != 0) return EXIT_FAILED;
  printf("Central field in (r, u), T %s\n\n", kind == KINETIC_FULL ? "= m/2 |d(r u)/dt|^2" : "= m/2 (rd^2 + r^2 |ud|^2)");
  int status = print_agreement(ask.kind) == 0 ? EXIT_DONE : EXIT_FAILED;
  putchar('\n');
  if (print_errors(ask.kind, states) != 0) status = EXIT_FAILED;
  putchar('\n');
  int flown = orbit(&ask);
  if (flown != EXIT_DONE) status = flown;
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
