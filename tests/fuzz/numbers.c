/* Names, sizes and memory of the groups of numbers.h. */
#include "numbers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

const char *fuzz_group_name(int group) {
  static const char *const names[] = {
#define FUZZ_X(id, name, rows, columns) name,
      FUZZ_GROUPS(FUZZ_X)
#undef FUZZ_X
  };
  return names[group];
}

int fuzz_group_rows(const fuzz_sizes *s, int group) {
  const int n = s->n, m1 = s->m1, m2 = s->m2, m = s->m;
  const int rows[] = {
#define FUZZ_X(id, name, rows, columns) rows,
      FUZZ_GROUPS(FUZZ_X)
#undef FUZZ_X
  };
  return rows[group];
}

int fuzz_group_columns(const fuzz_sizes *s, int group) {
  const int n = s->n, k = s->k, np = s->np;
  const int columns[] = {
#define FUZZ_X(id, name, rows, columns) columns,
      FUZZ_GROUPS(FUZZ_X)
#undef FUZZ_X
  };
  return columns[group];
}

int fuzz_group_size(const fuzz_sizes *s, int group) { return fuzz_group_rows(s, group) * fuzz_group_columns(s, group); }

void fuzz_numbers_start(fuzz_numbers *numbers, fuzz_sizes sizes) {
  size_t count = 0;
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) count += (size_t)fuzz_group_size(&sizes, g);
  numbers->sizes = sizes;
  numbers->memory = malloc(count * sizeof *numbers->memory);
  if (!numbers->memory) {
    fprintf(stderr, "out of memory\n");
    exit(2);
  }
  for (size_t i = 0; i < count; i++) numbers->memory[i] = (double)NAN;
  double *next = numbers->memory;
  for (int g = 0; g < FUZZ_GROUP_COUNT; g++) {
    numbers->group[g] = next;
    next += fuzz_group_size(&sizes, g);
  }
}

void fuzz_numbers_free(fuzz_numbers *numbers) { free(numbers->memory); }

void fuzz_make_absent(fuzz_numbers *numbers, int first, int last) {
  for (int g = first; g < last; g++) numbers->group[g] = NULL;
}

double fuzz_group_largest(const fuzz_numbers *numbers, int group) {
  double largest = 0.0;
  if (!numbers->group[group]) return largest;
  for (int i = 0; i < fuzz_group_size(&numbers->sizes, group); i++) largest = fmax(largest, fabs(numbers->group[group][i]));
  return largest;
}
