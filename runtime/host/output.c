/* Output files that are there whole or not at all. */
#include "host/output.h"

#include "host/message.h"

#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int failed(output *o) {
  complain("cannot write '%s': %s", o->target, strerror(errno));
  output_discard(o);
  return -1;
}

static FILE *open_direct(const char *path) {
  int descriptor = open(path, O_WRONLY | O_CLOEXEC);
  return descriptor < 0 ? NULL : fdopen(descriptor, "w");
}

/* A new file beside the target, with the permissions that a plain new file gets. */
static FILE *open_temporary(output *o) {
  size_t size = strlen(o->final) + 32;
  o->temporary = malloc(size);
  if (o->temporary == NULL) return NULL;
  snprintf(o->temporary, size, "%s.%ld.part", o->final, (long)getpid());
  int descriptor = open(o->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) return fdopen(descriptor, "w");
  free(o->temporary); /* it is not ours, so it is not ours to remove */
  o->temporary = NULL;
  return NULL;
}

int output_open(output *o, const char *target) {
  struct stat info;
  *o = (output){.target = target};
  bool exists = stat(target, &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    return failed(o);
  }
  if (exists && !S_ISREG(info.st_mode)) {
    o->file = open_direct(target);
  } else {
    o->final = exists ? realpath(target, NULL) : strdup(target);
    if (o->final != NULL) o->file = open_temporary(o);
  }
  return o->file != NULL ? 0 : failed(o);
}

int output_check(const char *target) {
  struct stat info;
  output o = {.target = target};
  bool direct = stat(target, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode);
  if (direct) return access(target, W_OK) == 0 ? 0 : failed(&o); /* to open a pipe would already tell its reader something */
  if (output_open(&o, target) != 0) return -1;
  output_discard(&o);
  return 0;
}

/* The folder that holds a path's last name, to be freed; that name begins at *name. Null where there is no such folder. */
static char *folder_of(const char *path, const char **name) {
  const char *slash = strrchr(path, '/');
  *name = slash != NULL ? slash + 1 : path;
  char *written = slash != NULL ? strndup(path, (size_t)(*name - path)) : strdup(".");
  char *folder = written != NULL ? realpath(written, NULL) : NULL;
  free(written);
  return folder;
}

/* Where a path leads to, without links, to be freed; null where not even its folder is there. */
static char *resolve(const char *path) {
  char *whole = realpath(path, NULL);
  if (whole != NULL) return whole;
  const char *name;
  char *folder = folder_of(path, &name);
  size_t size = folder != NULL ? strlen(folder) + strlen(name) + 2 : 0;
  if (folder != NULL) whole = malloc(size);
  if (whole != NULL) snprintf(whole, size, "%s/%s", folder, name);
  free(folder);
  return whole;
}

/* One file with two names, or two links to it. A terminal or a pipe may well be read and written. */
static bool is_one_file(const char *a, const char *b) {
  struct stat x, y;
  return stat(a, &x) == 0 && stat(b, &y) == 0 && S_ISREG(x.st_mode) && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

bool output_same(const char *a, const char *b) {
  if (is_one_file(a, b)) return true;
  char *x = resolve(a), *y = resolve(b);
  bool same = strcmp(a, b) == 0 || (x != NULL && y != NULL && strcmp(x, y) == 0);
  free(x);
  free(y);
  return same;
}

bool output_replaces(const char *target, const char *input) { return is_one_file(target, input); }

void output_number(output *o, double x) {
  char text[32];
  int digits = DBL_DIG;
  x = isnan(x) ? (double)NAN : x; /* one that has a sign would be printed with it */
  do snprintf(text, sizeof text, "%.*g", digits, x);
  while (digits++ < DBL_DECIMAL_DIG && strtod(text, NULL) != x);
  fputs(text, o->file);
}

void output_row(output *o, const double *row, int width) {
  for (int i = 0; i < width; i++) {
    output_number(o, row[i]);
    fputc(i + 1 < width ? ',' : '\n', o->file);
  }
}

int output_flush(output *o) { return fflush(o->file) == 0 && !ferror(o->file) ? 0 : failed(o); }

int output_commit(output *o) {
  if (output_flush(o) != 0) return -1;
  FILE *file = o->file;
  o->file = NULL;
  if (fclose(file) != 0) return failed(o);
  if (o->temporary != NULL && rename(o->temporary, o->final) != 0) return failed(o);
  free(o->temporary);
  o->temporary = NULL;
  output_discard(o);
  return 0;
}

void output_discard(output *o) {
  if (o->file != NULL) fclose(o->file);
  if (o->temporary != NULL) unlink(o->temporary);
  free(o->temporary);
  free(o->final);
  *o = (output){.target = o->target};
}
