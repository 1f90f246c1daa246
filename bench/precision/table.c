/* CSV files as tables. */
#include "table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The whole file, ended by 0; null where it cannot be read. */
static char *read_text(const char *path) {
  FILE *file = fopen(path, "rb");
  char *text = NULL;
  size_t size = 0, room = 0;
  if (file == NULL) return NULL;
  do {
    if (size + 1 >= room) {
      char *more = realloc(text, room = 2 * room + 65536);
      if (more == NULL) break;
      text = more;
    }
    size += fread(text + size, 1, room - size - 1, file);
  } while (!feof(file) && !ferror(file));
  fclose(file);
  if (text != NULL) text[size] = '\0';
  return text;
}

static int count_of(const char *text, char c) {
  int count = 0;
  for (; *text != '\0'; text++) count += *text == c;
  return count;
}

/* The comma behind a cell, null behind the last one. A cell in quotes loses them in place. */
static char *cell_end(char **cell) {
  char *quote = **cell == '"' ? strchr(*cell + 1, '"') : NULL;
  if (quote == NULL) return strchr(*cell, ',');
  ++*cell;
  *quote = '\0';
  return strchr(quote + 1, ',');
}

/* Splits one line in place into at most `most` cells; returns how many there are. */
static int split(char *line, char **cell, int most) {
  int count = 0;
  for (char *at = line; at != NULL; count++) {
    char *comma = cell_end(&at);
    if (comma != NULL) *comma++ = '\0';
    if (count < most) cell[count] = at;
    at = comma;
  }
  return count;
}

table table_read(const char *path) {
  table t = {.text = read_text(path)};
  if (t.text == NULL) return t;
  const int lines = count_of(t.text, '\n') + 1;
  char *next = t.text;
  for (int i = 0; i < lines && *next != '\0'; i++) {
    char *line = next, *end = line + strcspn(line, "\n");
    next = *end != '\0' ? end + 1 : end;
    *end = '\0';
    if (i == 0) {
      t.columns = count_of(line, ',') + 1;
      t.cell = calloc((size_t)lines * (size_t)t.columns, sizeof *t.cell);
      t.rows = -1;
    }
    if (t.cell == NULL) break;
    if (split(line, t.cell + (t.rows + 1) * t.columns, t.columns) == t.columns) t.rows++;
  }
  if (t.rows < 0) t.rows = 0;
  return t;
}

void table_free(table *t) {
  free(t->cell);
  free(t->text);
  *t = (table){0};
}

int table_column(const table *t, const char *name) {
  for (int i = 0; i < t->columns; i++)
    if (strcmp(t->cell[i], name) == 0) return i;
  return -1;
}

const char *table_cell(const table *t, int row, int column) { return column < 0 ? "" : t->cell[(row + 1) * t->columns + column]; }

double table_number(const table *t, int row, int column) {
  char *end;
  const char *text = table_cell(t, row, column);
  const double x = strtod(text, &end);
  return end != text && *end == '\0' ? x : (double)NAN;
}
