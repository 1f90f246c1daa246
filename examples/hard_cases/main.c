/* hard_cases: mechanisms that break careless solvers, each beside its truth. */
#include "figures.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/options.h"
#include "report.h"

#include <math.h>
#include <stdio.h>

const char program[] = "hard_cases";

static const char *const drift_names[] = {"none", "baumgarte", "projection", NULL}; /* in the order of run_drift */

static const manual text = {
    .operands = "[NAME..] ",
    .summary = "Runs the scenes of these names, or those of --all, and prints their largest errors against closed forms and published\n"
               "or quadruple-precision digits, with the bounds that they must keep. An error is |value - truth| / max(|truth|, floor)\n"
               "of what the scene measures. Exit status 1 where a bound is missed.\n",
    .examples = "  hard_cases --list\n"
                "  hard_cases A01 A03\n"
                "  hard_cases A01 --drift none --out .      without projection; A01.csv has the errors over time\n"
                "  hard_cases --all --quick                 short forms of all; seconds\n",
};

typedef struct command {
  run_request each;
  const char *method, *out, *figures;
  int drift;
  bool list, all, quick, markdown;
} command;

static command read_command(int argc, char **argv) {
  command c = {.each = {.rate = 10.0}, .drift = DRIFT_PROJECTION};
  const option table[] = {
      {.name = "--list", .kind = OPTION_FLAG, .value = &c.list, .help = "print the names of all scenes and what is hard about them"},
      {.name = "--all", .kind = OPTION_FLAG, .value = &c.all, .help = "run all scenes; minutes"},
      {.name = "--quick", .kind = OPTION_FLAG, .value = &c.quick, .help = "the first seconds of each scene only"},
      {.name = "--method", .kind = OPTION_TEXT, .value = &c.method, .operand = "NAME", .help = "of integration; default: the scene's"},
      {.name = "--step",
       .kind = OPTION_ABOVE,
       .value = &c.each.step,
       .most = HUGE_VAL,
       .operand = "H",
       .help = "fixed step of integration, s; default: the scene's"},
      {.name = "--tolerance",
       .kind = OPTION_ABOVE,
       .value = &c.each.tolerance,
       .most = 1.0,
       .operand = "E",
       .help = "steps are chosen so that each is wrong by at most E,\nrelative to the larger of 1 and each number"},
      {.name = "--drift",
       .kind = OPTION_CHOICE,
       .value = &c.drift,
       .choices = drift_names,
       .operand = "none|baumgarte|projection",
       .help = "\nwhat keeps the constraints: nothing, Baumgarte's terms, or projection\nafter each step, the default"},
      {.name = "--rate",
       .kind = OPTION_ABOVE,
       .value = &c.each.rate,
       .most = HUGE_VAL,
       .operand = "R",
       .help = "both gains of --drift baumgarte, 1/s; default 10"},
      {.name = "--out",
       .kind = OPTION_TEXT,
       .value = &c.out,
       .operand = "DIR",
       .help = "write DIR/NAME.csv for each scene: t,error,energy_error,phi,phi_dot,rank at each output"},
      {.name = "--figures",
       .kind = OPTION_TEXT,
       .value = &c.figures,
       .operand = "DIR",
       .help = "draw DIR/speed_NAME.svg, time against error over steps and methods, of some scenes,\n"
               "and DIR/drift.svg, what none, Baumgarte's terms and projection leave of A01; minutes"},
      {.name = "--markdown", .kind = OPTION_FLAG, .value = &c.markdown, .help = "print the table as a page wants it"},
  };
  read_options(argc, argv, table, sizeof table / sizeof table[0], &text);
  if (c.method != NULL && eom_method_find(c.method) == NULL) usage_error("--method %s: no method has that name", c.method);
  if (c.each.step > 0.0 && c.each.tolerance > 0.0) usage_error("either --step or --tolerance");
  c.each.method = c.method;
  c.each.drift = (run_drift)c.drift;
  return c;
}

/* Returns an exit status. */
static int do_scene(const scene *s, const command *c) {
  run r;
  run_request ask = c->each;
  ask.scene = s;
  ask.duration = c->quick ? s->quick : s->duration;
  run_do(&r, &ask);
  print_run(&r, c->markdown);
  int status = run_passed(&r) ? EXIT_DONE : EXIT_FAILED;
  if (c->out != NULL && r.nrow > 0 && write_rows(c->out, &r) != 0) status = EXIT_FAILED;
  if (r.status == EOM_STOPPED) {
    complain("%s was stopped by the user at t = %g s of %g s", s->name, r.worst.t, r.duration);
    status = EXIT_INTERRUPTED;
  } else {
    explain(&r);
  }
  run_free(&r);
  return status;
}

static const scene *scene_named(const char *name) {
  const scene *s = scene_find(name);
  if (s == NULL) usage_error("there is no scene '%s'; --list names them all", name);
  return s;
}

int main(int argc, char **argv) {
  int names = 0;
  while (names + 1 < argc && argv[names + 1][0] != '-') names++;
  command c = read_command(argc - names, argv + names);
  for (int i = 1; i <= names; i++) (void)scene_named(argv[i]);
  if (c.list) {
    print_list();
    return finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
  }
  if (c.figures != NULL && (names > 0 || c.all)) usage_error("--figures stands alone");
  if (c.figures != NULL) {
    watch_interrupts();
    return draw_figures(c.figures, c.quick);
  }
  if (names == 0 && !c.all) usage_error("name a scene, or take --all or --figures; --list names the scenes");
  if (names > 0 && c.all) usage_error("either --all or names of scenes");
  watch_interrupts();
  int status = EXIT_DONE;
  print_head(c.markdown);
  for (int i = 0; i < (c.all ? nscenes : names) && status != EXIT_INTERRUPTED; i++) {
    const int done = do_scene(c.all ? scenes[i] : scene_named(argv[i + 1]), &c);
    if (done != EXIT_DONE) status = done;
  }
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
