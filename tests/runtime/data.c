/* Reading of reference data. */
#include "data.h"

#include "close.h"

#include <stdlib.h>
#include <string.h>

FILE *data_open(const char *name) {
  char path[1024];
  snprintf(path, sizeof path, "%s/%s", TEST_DATA, name);
  FILE *file = fopen(path, "r");
  if (!file) fail_msg("cannot open %s", path);
  return file;
}

int data_next(FILE *file, data_line *line) {
  static char text[65536];
  do
    if (!fgets(text, sizeof text, file)) return 0;
  while (text[0] == '#' || text[0] == '\n');
  char *at = text;
  line->name[0] = '\0';
  line->count = 0;
  if ((*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z')) {
    const size_t length = strcspn(at, " \n");
    assert_true(length < sizeof line->name);
    memcpy(line->name, at, length);
    line->name[length] = '\0';
    at += length;
  }
  for (;;) {
    char *end;
    const double x = strtod(at, &end);
    if (end == at) break;
    assert_true(line->count < DATA_NUMBERS);
    line->number[line->count++] = x;
    at = end;
  }
  assert_true(line->count > 0 && strspn(at, " \n") == strlen(at));
  return 1;
}
