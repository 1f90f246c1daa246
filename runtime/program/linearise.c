/* eom linearise: the linear model at a state, an equilibrium found first where asked for, and its modes. */
#include "eom/linearise.h"
#include "command.h"
#include "eom/equilibrium.h"
#include "eom/modes.h"
#include "files.h"
#include "host/message.h"
#include "host/npz.h"
#include "setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWN_OPTIONS = 5, SHOWN = 12 /* rows of a matrix that are printed */ };

/* An acceleration below this, in parts of 1 + |y|, is zero: what an equilibrium's own iteration leaves over. */
static const double no_acceleration = 1e-9;

/* An equilibrium so many times the size of the start away is not one near it. */
static const double far = 10.0;

/* What is printed as zero, in parts of the numbers beside it. */
static const double rounding = 1e-13;

typedef struct command {
  setup s;
  bool equilibrium, steady;
  const char *csv, *modes_csv, *npz;
} command;

static const char summary[] =
    "The linear model at the start: z' = F z. Without constraints z = (q, qd); with them z are minimal coordinates, as many\n"
    "as small changes are free on the constraints (eom/minimal.h), named by the coordinate that each moves most freely.\n"
    "Prints F where it is small, the eigenvalues, frequencies, damping ratios, and which coordinate each mode moves most.\n"
    "At a state that is neither an equilibrium nor a steady motion F is that of the instant.\n\n";

static void read_command(command *c, int argc, char **argv) {
  char whole[4096];
  option table[SETUP_OPTIONS + OWN_OPTIONS];
  const option own[OWN_OPTIONS] = {
      {.name = "--equilibrium",
       .kind = OPTION_FLAG,
       .value = &c->equilibrium,
       .help = "first move to the equilibrium near the start, velocities\nand the coordinates of --keep staying as they are"},
      {.name = "--steady",
       .kind = OPTION_FLAG,
       .value = &c->steady,
       .help = "likewise to a steady motion: velocities but those of --keep\nmay change too"},
      {.name = "--csv", .kind = OPTION_TEXT, .value = &c->csv, .operand = "FILE", .help = "write F, a line per row"},
      {.name = "--modes-csv", .kind = OPTION_TEXT, .value = &c->modes_csv, .operand = "FILE", .help = "write the modes, a line each"},
      {.name = "--npz",
       .kind = OPTION_TEXT,
       .value = &c->npz,
       .operand = "FILE",
       .help = "write q, qd, qdd, F, Z and S (eom/minimal.h), eigenvalues\n(re, im), shapes (mode, re or im, component of q, qd)"},
  };
  setup_options(&c->s, table);
  memcpy(table + SETUP_OPTIONS, own, sizeof own);
  snprintf(whole, sizeof whole, "%s%s\nExit status: 0 done, 1 there is no such state or an output failed, 2 wrong options.\n", summary,
           setup_help);
  const manual text = {
      .command = "linearise",
      .operands = "MODEL.so ",
      .summary = whole,
      .examples = "  eom linearise cart_pole.so --start cart_pole.txt --equilibrium\n"
                  "  eom linearise pendulum.so --set n=2 --set g=9.81 --set mass=1 --set length=1 --modes-csv modes.csv\n"
                  "  eom linearise flyball.so --start flyball.txt --steady --keep 'qd[0]' --npz governor.npz\n",
  };
  setup_read(&c->s, argc, argv, table, (int)(sizeof table / sizeof table[0]), &text);
}

static wanted_files wanted(const command *c) {
  return (wanted_files){{{"--csv", c->csv}, {"--modes-csv", c->modes_csv}, {"--npz", c->npz}}};
}

/* A linear model with what it is made of. */
typedef struct linear {
  int d;
  double *F;      /* d x d */
  double *qdd;    /* n */
  eom_mode *mode; /* d */
  double *shape;  /* d x 2 x 2n, in changes of (q,qd) */
  eom_minimal minimal;
  void *memory, *numbers;
} linear;

/* ---- computing ---- */

/* Says which component went far, in parts of 1 + the largest at the start: what was found is then hardly what was meant. */
static void warn_of_distance(const setup *s, const double *before) {
  double scale = 1.0;
  int most = 0;
  for (int i = 0; i < 2 * s->n; i++) {
    scale = fmax(scale, 1.0 + fabs(before[i]));
    if (fabs(s->q[i] - before[i]) > fabs(s->q[most] - before[most])) most = i;
  }
  if (fabs(s->q[most] - before[most]) > far * scale)
    complain("this is far from the start: %s went from %g to %g", component_name(s, most), before[most], s->q[most]);
}

/* Velocities that stay as they are may be why. */
static void explain_acceleration(const command *c, int i) {
  const setup *s = &c->s;
  int moving = c->steady ? 2 * s->n : s->n;
  while (moving < 2 * s->n && s->q[moving] == 0.0) moving++;
  if (moving < 2 * s->n)
    complain(
        "nothing near this state holds %s at the velocities given, which --equilibrium leaves as they are (%s = %g); start at rest, or "
        "try --steady",
        component_name(s, i), component_name(s, moving), s->q[moving]);
  else
    complain("nothing near this state holds %s", component_name(s, i));
}

static int find_state(const command *c) {
  const setup *s = &c->s;
  eom_equilibrium e = {.keep_q = s->any_kept[0] ? s->keep : NULL, .keep_qd = c->steady ? s->keep + s->n : NULL};
  const size_t bytes = eom_equilibrium_bytes(s->sys);
  void *memory = malloc(bytes);
  double *before = malloc(2 * (size_t)s->n * sizeof *before);
  if (before != NULL) memcpy(before, s->q, 2 * (size_t)s->n * sizeof *before);
  const eom_status status =
      memory != NULL && before != NULL ? eom_find_equilibrium(s->sys, s->q, s->qd, s->t0, &e, memory, bytes) : EOM_NO_MEMORY;
  if (status != EOM_OK) {
    complain_status(s->sys, status, c->steady ? "no steady motion" : "no equilibrium");
    if (status == EOM_NO_EQUILIBRIUM && s->sys->report.index >= 0) explain_acceleration(c, s->sys->report.index);
  } else {
    printf("%s after %d steps; largest acceleration left %.1e\n", c->steady ? "Steady motion" : "Equilibrium", e.steps, e.residual);
    warn_of_distance(s, before);
  }
  free(before);
  free(memory);
  return status == EOM_OK ? 0 : -1;
}

/* Frees what there is at a failure. */
static void linear_free(linear *l) {
  free(l->memory);
  free(l->numbers);
  free(l->mode);
}

static eom_status compute(const setup *s, linear *l) {
  const size_t bytes = eom_minimal_bytes(s->sys), most = 2 * (size_t)s->n;
  *l = (linear){.memory = malloc(bytes)};
  l->numbers = calloc(most * most * 3 + most + eom_modes_work((int)most), sizeof(double));
  l->mode = calloc(most, sizeof *l->mode);
  if (l->memory == NULL || l->numbers == NULL || l->mode == NULL) return EOM_NO_MEMORY;
  double *work = (double *)l->numbers + most * most * 3 + most;
  l->shape = l->numbers;
  l->F = l->shape + 2 * most * most;
  l->qdd = l->F + most * most;
  if (s->sys->m > 0) {
    const eom_status status = eom_linearise_minimal(s->sys, &l->minimal, s->q, s->qd, s->t0, l->memory, bytes);
    if (status != EOM_OK) return status;
    l->d = l->minimal.d;
    memcpy(l->F, l->minimal.F, (size_t)(l->d * l->d) * sizeof *l->F);
  } else {
    const eom_status status = eom_linearise(s->sys, s->q, s->qd, s->t0);
    if (status != EOM_OK) return status;
    l->d = 2 * s->n;
    eom_state_matrix(s->sys, l->F);
  }
  memcpy(l->qdd, s->sys->qdd, (size_t)s->n * sizeof *l->qdd);
  if (s->sys->m > 0) return eom_minimal_modes(l->mode, l->shape, &l->minimal, work);
  return eom_modes(l->mode, l->shape, l->d, l->F, work);
}

/* ---- printing ---- */

/* What component i of z is called. */
static const char *z_name(const setup *s, const linear *l, int i) {
  if (s->sys->m == 0) return component_name(s, i);
  return component_name(s, l->minimal.coordinate[i] + (i < l->minimal.nq ? 0 : s->n));
}

/* Without what is rounding beside `size`: a machine's last bits are not for reading. */
static double clean(double x, double size) { return fabs(x) <= rounding * size ? 0.0 : x; }

static void print_state(const setup *s, const linear *l, bool driven) {
  double most = 0.0, scale = 1.0;
  printf("State at t = %.10g s\n", s->t0);
  for (int i = 0; i < s->n; i++) {
    printf("  %-12s = %-18.10g %-12s = %-18.10g acceleration %.3g\n", component_name(s, i), clean(s->q[i], 1.0),
           component_name(s, s->n + i), clean(s->qd[i], 1.0), clean(l->qdd[i], 1.0));
    most = fmax(most, fabs(l->qdd[i]));
    scale = fmax(scale, 1.0 + fmax(fabs(s->q[i]), fabs(s->qd[i])));
  }
  if (most > no_acceleration * scale)
    printf("It is no equilibrium: the modes are those of the instant (--equilibrium finds one).\n");
  else if (driven)
    printf("Time moves this model: nothing accelerates at this instant, and the modes are those of the instant.\n");
}

static void print_matrix(const setup *s, const linear *l) {
  printf("z' = F z, z of %d components:", l->d);
  for (int i = 0; i < l->d && i < SHOWN; i++) printf(" %s", z_name(s, l, i));
  if (l->d > SHOWN) {
    printf(" ..\n");
    return;
  }
  putchar('\n');
  for (int i = 0; i < l->d; i++) {
    for (int k = 0; k < l->d; k++) {
      const double x = l->F[i * l->d + k];
      printf("%14.6g", x == 0.0 ? 0.0 : x); /* no -0 */
    }
    putchar('\n');
  }
}

/* The coordinate that a mode moves most. */
static int most_moved(const setup *s, const linear *l, int mode) {
  const double *re = l->shape + (size_t)mode * 4 * (size_t)s->n, *im = re + 2 * s->n;
  int most = 0;
  for (int i = 1; i < s->n; i++)
    if (hypot(re[i], im[i]) > hypot(re[most], im[most]) * (1.0 + 1e-6)) most = i;
  return most;
}

static void print_modes(const setup *s, const linear *l) {
  double most = 0.0; /* of |s| */
  for (int i = 0; i < l->d; i++) most = fmax(most, hypot(l->mode[i].re, l->mode[i].im));
  printf("Modes\n  %14s %14s %14s %14s   moves most\n", "re, 1/s", "im, 1/s", "frequency, Hz", "damping");
  for (int i = 0; i < l->d; i++) {
    const eom_mode *m = &l->mode[i];
    const double noise = fmax(m->condition, 1.0) * most, re = clean(m->re, noise), size = hypot(re, m->im);
    printf("  %14.6g %14.6g %14.6g %14.6g   %s\n", re, clean(m->im, noise), clean(m->frequency, noise),
           size > 0.0 ? 0.0 - re / size : 0.0, component_name(s, most_moved(s, l, i)));
  }
}

/* ---- writing ---- */

static int write_matrix(const setup *s, const linear *l, const char *path) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  for (int i = 0; i < l->d; i++) fprintf(o.file, "%s%c", z_name(s, l, i), i + 1 < l->d ? ',' : '\n');
  for (int i = 0; i < l->d; i++) output_row(&o, l->F + i * l->d, l->d);
  return output_commit(&o);
}

static int write_modes(const setup *s, const linear *l, const char *path) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  fputs("re,im,frequency,damping,condition", o.file);
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < 2 * s->n; i++) fprintf(o.file, ",%s %s", k == 0 ? "re" : "im", component_name(s, i));
  fputc('\n', o.file);
  for (int i = 0; i < l->d; i++) {
    const double head[] = {l->mode[i].re, l->mode[i].im, l->mode[i].frequency, l->mode[i].damping, l->mode[i].condition};
    for (int k = 0; k < 5; k++) {
      output_number(&o, head[k]);
      fputc(',', o.file);
    }
    output_row(&o, l->shape + (size_t)i * 4 * (size_t)s->n, 4 * s->n);
  }
  return output_commit(&o);
}

static int write_npz(const setup *s, const linear *l, const char *path) {
  npz z;
  const long n[] = {s->n}, square[] = {l->d, l->d}, values[] = {l->d, 2}, shapes[] = {l->d, 2, 2 * s->n}, tall[] = {2 * s->n, l->d},
             flat[] = {l->d, 2 * s->n};
  const long stride = (long)(sizeof(eom_mode) / sizeof(double)); /* re and im stand first in a mode */
  if (npz_open(&z, path) != 0) return -1;
  if (npz_add(&z, "q", s->q, 1, n, 0) != 0 || npz_add(&z, "qd", s->qd, 1, n, 0) != 0 || npz_add(&z, "qdd", l->qdd, 1, n, 0) != 0 ||
      npz_add(&z, "F", l->F, 2, square, 0) != 0 || npz_add(&z, "eigenvalues", &l->mode[0].re, 2, values, stride) != 0 ||
      npz_add(&z, "shapes", l->shape, 3, shapes, 0) != 0)
    return -1;
  if (s->sys->m > 0 && (npz_add(&z, "Z", l->minimal.Z, 2, tall, 0) != 0 || npz_add(&z, "S", l->minimal.S, 2, flat, 0) != 0)) return -1;
  return npz_close(&z);
}

static int write_all(const command *c, const linear *l) {
  int status = 0;
  if (c->csv != NULL && write_matrix(&c->s, l, c->csv) != 0) status = -1;
  if (c->modes_csv != NULL && write_modes(&c->s, l, c->modes_csv) != 0) status = -1;
  if (c->npz != NULL && write_npz(&c->s, l, c->npz) != 0) status = -1;
  return status;
}

static int linearise(command *c) {
  linear l;
  if (setup_consistent(&c->s) != 0 || ((c->equilibrium || c->steady) && find_state(c) != 0)) return EXIT_FAILED;
  const bool driven = setup_driven(&c->s);
  const eom_status status = compute(&c->s, &l);
  int result = EXIT_FAILED;
  if (status != EOM_OK) {
    complain_status(c->s.sys, status, "the linear model");
  } else {
    print_state(&c->s, &l, driven);
    print_matrix(&c->s, &l);
    print_modes(&c->s, &l);
    result = write_all(c, &l) == 0 ? EXIT_DONE : EXIT_FAILED;
  }
  linear_free(&l);
  return result;
}

int linearise_command(int argc, char **argv) {
  command c = {.equilibrium = false};
  read_command(&c, argc, argv);
  if (c.equilibrium && c.steady) usage_error("--equilibrium and --steady: one of them");
  files_distinct(wanted(&c), &c.s);
  if (files_possible(wanted(&c)) != 0) return EXIT_FAILED;
  if (setup_load(&c.s, c.s.model.path, NULL) != 0) return refuse();
  setup_print(&c.s);
  const int status = linearise(&c);
  setup_close(&c.s);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
