/* Reads a file of reference.py. */
#include "reference.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static _Noreturn void unreadable(const char *path, const char *what) {
  fprintf(stderr, "%s: %s\n", path, what);
  exit(EXIT_FAILURE);
}

static double *read_numbers(FILE *file, const char *path, int count) {
  double *numbers = malloc(((size_t)count + 1) * sizeof *numbers);
  if (!numbers) unreadable(path, "no memory");
  for (int i = 0; i < count; i++)
    if (fscanf(file, "%lf", &numbers[i]) != 1) unreadable(path, "a number is missing");
  return numbers;
}

/* Blocks up to the next point or the end. */
static void read_blocks(FILE *file, const char *path, point *p) {
  block b;
  long place = ftell(file);
  while (fscanf(file, "%15s", b.name) == 1 && strcmp(b.name, "point") != 0) {
    if (p->nblock == MAX_BLOCKS || fscanf(file, "%d %lf", &b.count, &b.condition) != 2 || b.count < 0) unreadable(path, "not a block");
    b.numbers = read_numbers(file, path, b.count);
    p->blocks[p->nblock++] = b;
    place = ftell(file);
  }
  fseek(file, place, SEEK_SET);
}

reference reference_read(const char *path) {
  reference r;
  FILE *file = fopen(path, "r");
  if (!file) unreadable(path, "cannot be read: print it with reference.py");
  if (fscanf(file, "#%*[^\n] n %d points %d", &r.n, &r.npoint) != 2 || r.n < 1 || r.npoint < 1) unreadable(path, "not a reference");
  r.points = calloc((size_t)r.npoint, sizeof *r.points);
  if (!r.points) unreadable(path, "no memory");
  for (int i = 0; i < r.npoint; i++) {
    if (fscanf(file, " point %127[^\n]", r.points[i].kind) != 1) unreadable(path, "a point is missing");
    r.points[i].state = read_numbers(file, path, 2 * r.n + 1);
    read_blocks(file, path, &r.points[i]);
  }
  if (fscanf(file, "%*s") != EOF) unreadable(path, "more than was announced");
  fclose(file);
  return r;
}

void reference_free(reference *r) {
  for (int i = 0; i < r->npoint; i++) {
    for (int k = 0; k < r->points[i].nblock; k++) free(r->points[i].blocks[k].numbers);
    free(r->points[i].state);
  }
  free(r->points);
}

const block *reference_block(const point *p, const char *name) {
  for (int i = 0; i < p->nblock; i++)
    if (strcmp(p->blocks[i].name, name) == 0) return &p->blocks[i];
  fprintf(stderr, "the reference has no %s\n", name);
  exit(EXIT_FAILURE);
}
