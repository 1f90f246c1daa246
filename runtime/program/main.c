/* eom: motion, linear models, Lyapunov exponents and pictures of any model that tlgen generated. */
#include "command.h"
#include "eom/description.h"
#include "host/message.h"
#include "host/nearest.h"

#include <stdio.h>
#include <string.h>

const char program[] = "eom";

static const struct {
  const char *name;
  int (*run)(int argc, char **argv);
  const char *text;
} commands[] = {
    {"info", info_command, "what a model is made of: functions, sizes, parameters"},
    {"run", run_command, "a motion as rows over time, with events and plots"},
    {"linearise", linearise_command, "the linear model at a state or equilibrium, and its modes"},
    {"lyapunov", lyapunov_command, "Lyapunov exponents with intervals, checks and checkpoints"},
    {"compare", compare_command, "methods and tolerances on one motion: time against true error"},
    {"watch", watch_command, "the motion as a moving picture (SVG, GIF)"},
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static const char rest[] =
    "\nMODEL.so is a model that tlgen generated, as a shared object: taylor_add_model(NAME .. SHARED), or by hand\n"
    "  tlgen pendulum.c --model pendulum --lagrangian pendulum_lagrangian --dof n -o pendulum_tl.c\n"
    "  cc -O2 -shared -fPIC -DEOM_SHARED_MODEL $(pkg-config --cflags libtaylor) pendulum_tl.c -o pendulum.so -lm\n"
    "\n'eom COMMAND --help' explains a command, with examples; 'eom --version' says which eom this is.\n"
    "\nExit status: 0 done, 1 the computation or an output failed, 2 what the user wrote makes no sense,\n130 Ctrl-C (what there was "
    "has been written).\n";

static int help(void) {
  printf("Usage: eom COMMAND MODEL.so [options]\n\nExact dynamics of a mechanism whose Lagrangian is plain C.\n\nCommands\n");
  for (int i = 0; i < COMMANDS; i++) printf("  %-10s %s\n", commands[i].name, commands[i].text);
  fputs(rest, stdout);
  return finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
}

static int version(void) {
  printf("eom %s (models of description %u)\n", EOM_VERSION, EOM_DESCRIPTION_VERSION >> 8);
  return finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED;
}

int main(int argc, char **argv) {
  const char *near = NULL;
  if (argc < 2) usage_error("which command?");
  if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) return help();
  if (strcmp(argv[1], "--version") == 0) return version();
  for (int i = 0; i < COMMANDS; i++) {
    if (strcmp(argv[1], commands[i].name) == 0) return commands[i].run(argc - 1, argv + 1);
    near = nearer(argv[1], near, commands[i].name);
  }
  if (near != NULL) usage_error("unknown command '%s'; did you mean %s?", argv[1], near);
  usage_error("unknown command '%s'", argv[1]);
}
