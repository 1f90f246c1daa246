/* Messages of a driver to its user. */
#include "common/message.h"

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

void usage_error(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  line(format, arguments);
  va_end(arguments);
  fprintf(stderr, "'%s --help' explains every option.\n", program);
  exit(EXIT_USAGE);
}

int finish_stdout(void) {
  errno = 0;
  if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
  complain("cannot write to standard output: %s", errno != 0 ? strerror(errno) : "an earlier write failed");
  return -1;
}
