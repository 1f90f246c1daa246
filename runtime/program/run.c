/* eom run: a motion as rows over time. */
#include "command.h"
#include "files.h"
#include "host/gnuplot.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "motion.h"
#include "plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double most_rows = 1e8; /* of one motion: more would take gigabytes of memory */

enum { OWN_OPTIONS = 9 };

typedef struct command {
  setup s;
  method how;
  double t_end, every;
  option_texts columns, events;
  const char *csv, *npz, *plot, *events_csv, *sensitivity;
} command;

static void read_command(command *c, int argc, char **argv) {
  char summary[8192];
  option table[SETUP_OPTIONS + METHOD_OPTIONS + OWN_OPTIONS];
  const option own[OWN_OPTIONS] = {
      setup_t_end(&c->t_end, "time at the end, s; before --t0: backwards; default 10"),
      setup_every(&c->every, "time from row to row, s; default: a thousand rows"),
      {.name = "--column",
       .kind = OPTION_TEXTS,
       .value = &c->columns,
       .operand = "NAME=FORMULA",
       .help = "\none more column: --column 'x=length[0]*sin(q[0])'; may be\nrepeated"},
      {.name = "--event",
       .kind = OPTION_TEXTS,
       .value = &c->events,
       .operand = "FORMULA [rising|falling] [stop]",
       .help = "\nfind when a formula passes zero: --event 'q[0] rising';\nlooked at as often as rows are, or at steps' ends "
               "by\nSUNDIALS' methods; may be repeated"},
      {.name = "--sensitivity",
       .kind = OPTION_TEXT,
       .value = &c->sensitivity,
       .operand = "LIST",
       .help = "\nderivatives of q and qd by initial values, q[0], and by\nparameters that the model has derivatives by, length[1]"},
      {.name = "--csv", .kind = OPTION_TEXT, .value = &c->csv, .operand = "FILE", .help = "write the rows, numbers in full"},
      {.name = "--events-csv", .kind = OPTION_TEXT, .value = &c->events_csv, .operand = "FILE", .help = "write the events"},
      {.name = "--npz",
       .kind = OPTION_TEXT,
       .value = &c->npz,
       .operand = "FILE",
       .help = "write the rows for numpy.load: arrays t, q, qd, energy,\nenergy_change, phi, phi_dot, the columns, event_t, event, .."},
      {.name = "--plot",
       .kind = OPTION_TEXT,
       .value = &c->plot,
       .operand = "FILE",
       .help = "draw the motion and its errors (.svg or .png, needs gnuplot)"},
  };
  setup_options(&c->s, table);
  method_options(&c->how, table + SETUP_OPTIONS);
  memcpy(table + SETUP_OPTIONS + METHOD_OPTIONS, own, sizeof own);
  snprintf(summary, sizeof summary,
           "Follows the motion of a model. Each row has t, q, qd, the energy E = p.qd - L, how far it has gone from that of\n"
           "the start, with constraints the largest |phi| and the largest of |phi_dot| and |psi|, and columns of your own.\n"
           "A start that is not on the constraints is brought onto them, and the change is printed. Ctrl-C ends the motion;\n"
           "what there is by then is written.\n\n%s\nMethods\n%s\n"
           "Exit status: 0 done, 1 the motion or an output failed, 2 wrong options, 130 Ctrl-C.\n",
           setup_help, method_list());
  const manual text = {
      .command = "run",
      .operands = "MODEL.so ",
      .summary = summary,
      .examples = "  eom run pendulum.so --set n=2 --set g=9.81 --set mass=1 --set length=1 --q 75deg,0 --t-end 20 --csv rows.csv\n"
                  "  eom run pendulum.so --start double.txt --plot motion.svg --event 'q[0] rising'\n"
                  "  eom run andrews.so --start andrews.txt --t-end 0.03 --method cvode_bdf --rtol 1e-8 --npz andrews.npz\n",
  };
  setup_read(&c->s, argc, argv, table, (int)(sizeof table / sizeof table[0]), &text);
}

static wanted_files wanted(const command *c) {
  return (wanted_files){{{"--csv", c->csv}, {"--npz", c->npz}, {"--plot", c->plot}, {"--events-csv", c->events_csv}}};
}

/* Refuses what cannot be before there is any computing. */
static void check_command(command *c) {
  method_complete(&c->how);
  check_figure_name("--plot", c->plot);
  if (c->events_csv != NULL && c->events.count == 0) usage_error("--events-csv without --event would be empty");
  files_distinct(wanted(c), &c->s);
}

static int check_times(command *c) {
  const double way = fabs(c->t_end - c->s.t0);
  if (way == 0.0) return complain("--t-end %g is the time of the start", c->t_end), -1;
  if (method_check_step(c->how.step, c->s.t0, c->t_end) != 0) return -1;
  if (c->every == 0.0) c->every = way / 1000.0;
  if (way / c->every > most_rows) return complain("--every %g: that makes more than %g rows", c->every, most_rows), -1;
  return 0;
}

static void print_motion(const motion *m) {
  const setup *s = m->ask.s;
  if (m->end == MOTION_EVENT) printf("The event '%s' ended the motion.\n", m->met.text[m->met.stopped]);
  printf("From t = %g s to %.10g s by %s: %ld steps, %ld refused, %ld evaluations", s->t0, m->t, m->ask.how->found->name, m->work.steps,
         m->work.rejected, m->work.evaluations);
  if (m->work.jacobians > 0) printf(", %ld Jacobians", m->work.jacobians);
  printf("; %ld rows\n", m->rows.count);
  printf("  energy at the start    %.10g J\n  largest |E - E0|       %.1e J\n", m->energy0, m->energy_change);
  if (s->sys->m > 0) printf("  largest |phi|          %.1e\n  largest |phi_dot, psi| %.1e\n", m->phi, m->phi_dot);
  printf("State at t = %.10g s\n", m->t);
  for (int i = 0; i < s->n; i++)
    printf("  %-12s = %-16.9g %-12s = %.9g\n", component_name(s, i), m->y[i], component_name(s, s->n + i), m->y[s->n + i]);
  derivatives_print(&m->derivatives, s);
  events_print(&m->met);
}

/* What was found besides rows, with names of its own. */
static int write_events(const motion *m, npz *z) {
  const series *f = &m->met.found;
  const long n = m->ask.s->n, plain[] = {f->count}, vector[] = {f->count, n};
  if (m->met.watched.count == 0) return 0;
  if (npz_add(z, "event", f->rows, 1, plain, f->width) != 0 || npz_add(z, "event_t", f->rows + 1, 1, plain, f->width) != 0) return -1;
  return npz_add(z, "event_q", f->rows + 2, 2, vector, f->width) != 0 ||
                 npz_add(z, "event_qd", f->rows + 2 + n, 2, vector, f->width) != 0
             ? -1
             : 0;
}

static int write_npz(const motion *m, const char *path) {
  npz z;
  if (npz_open(&z, path) != 0) return -1;
  if (series_npz(&m->rows, &z) != 0 || write_events(m, &z) != 0) return -1;
  return npz_close(&z);
}

static int write_all(const command *c, const motion *m) {
  int status = 0;
  if (c->csv != NULL && series_csv(&m->rows, c->csv) != 0) status = -1;
  if (c->events_csv != NULL && series_csv(&m->met.found, c->events_csv) != 0) status = -1;
  if (c->npz != NULL && write_npz(m, c->npz) != 0) status = -1;
  if (c->plot != NULL && plot_motion(m, c->plot) != 0) status = -1;
  return status;
}

static int finish(const command *c, const motion *m) {
  int status = m->end == MOTION_FAILED ? EXIT_FAILED : m->end == MOTION_INTERRUPTED ? EXIT_INTERRUPTED : EXIT_DONE;
  if (m->rows.count == 0) return status;
  print_motion(m);
  return write_all(c, m) == 0 ? status : EXIT_FAILED;
}

/* All that the user wrote is read before anything is printed. */
static int follow(command *c) {
  motion m;
  if (check_times(c) != 0) return refuse();
  const motion_request ask = {.s = &c->s,
                              .how = &c->how,
                              .t_end = c->t_end,
                              .every = c->every,
                              .columns = &c->columns,
                              .events = &c->events,
                              .sensitivity = c->sensitivity};
  if (motion_open(&m, &ask) != 0) return refuse();
  setup_print(&c->s);
  int status = EXIT_FAILED;
  if (setup_consistent(&c->s) == 0) {
    motion_follow(&m);
    status = finish(c, &m);
  }
  motion_close(&m);
  return status;
}

int run_command(int argc, char **argv) {
  command c = {.how = method_default, .t_end = 10.0};
  read_command(&c, argc, argv);
  check_command(&c);
  const eom_options options = method_system_options(&c.how, EOM_NEED_SIMULATE);
  watch_interrupts();
  if (files_possible(wanted(&c)) != 0) return EXIT_FAILED;
  if (setup_load(&c.s, c.s.model.path, &options) != 0) return refuse();
  const int status = follow(&c);
  setup_close(&c.s);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
