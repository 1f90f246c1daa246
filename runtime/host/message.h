/* Messages of a driver to its user. */
#ifndef HOST_MESSAGE_H
#define HOST_MESSAGE_H

#include <stdnoreturn.h>

/* Exit statuses of every driver. */
enum {
  EXIT_DONE = 0,
  EXIT_FAILED = 1,       /* the computation or an output failed */
  EXIT_USAGE = 2,        /* the command line makes no sense */
  EXIT_INTERRUPTED = 130 /* Ctrl-C; what there was has been written */
};

/* The name that starts each message; every driver defines it. */
extern const char program[];

/* Prints "program: " and the formatted text as one line to standard error. */
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Points to --help, behind messages that said what makes no sense. Returns EXIT_USAGE. */
int refuse(void);

/* Complains, points to --help and exits with EXIT_USAGE. */
noreturn void usage_error(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* From now on usage_error points to the --help of this subcommand, where that is not null. */
void usage_command(const char *name);

/* Flushes standard output. Returns 0, or -1 after a message when what was printed did not all get out (full disk, closed pipe). */
int finish_stdout(void);

#endif
