/* Messages of a driver to its user. */
#include "host/message.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void line(const char *format, va_list arguments) {
  fprintf(stderr, "%s: ", program);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
}

void complain(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  line(format, arguments);
  va_end(arguments);
}

static const char *command; /* null: none */

void usage_command(const char *name) { command = name; }

int refuse(void) {
  fprintf(stderr, "'%s%s%s --help' explains every option.\n", program, command != NULL ? " " : "", command != NULL ? command : "");
  return EXIT_USAGE;
}

void usage_error(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  line(format, arguments);
  va_end(arguments);
  exit(refuse());
}

int finish_stdout(void) {
  errno = 0;
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  complain("cannot write to standard output: %s", errno != 0 ? strerror(errno) : "an earlier write failed");
  return -1;
}
