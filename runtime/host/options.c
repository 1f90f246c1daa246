/* Command lines: a table of options, checked strictly. */
#include "host/options.h"

#include "host/message.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HELP_COLUMN = 24 };

static void print_option(const char *name, const char *operand, const char *help) {
  int width = printf("  %s%s%s", name, operand != NULL ? " " : "", operand != NULL ? operand : "");
  for (const char *p = help; *p != '\0';) {
    size_t length = strcspn(p, "\n");
    printf("%*s%.*s\n", width < HELP_COLUMN ? HELP_COLUMN - width : 1, "", (int)length, p);
    width = 0;
    p += length + (p[length] == '\n');
  }
}

static noreturn void print_manual(const option *table, int count, const manual *text) {
  printf("Usage: %s %s%s%s[options]\n\n%s\nOptions\n", program, text->command != NULL ? text->command : "",
         text->command != NULL ? " " : "", text->operands != NULL ? text->operands : "", text->summary);
  for (int i = 0; i < count; i++) print_option(table[i].name, table[i].operand, table[i].help);
  print_option("-h, --help", NULL, "print this text");
  printf("\nExamples\n%s", text->examples);
  exit(finish_stdout() == 0 ? EXIT_DONE : EXIT_FAILED);
}

static const option *find(const char *name, size_t length, const option *table, int count) {
  for (int i = 0; i < count; i++)
    if (strlen(table[i].name) == length && memcmp(table[i].name, name, length) == 0) return &table[i];
  return NULL;
}

/* The option that begins like a mistyped or shortened name, null where there is not just one. */
static const option *meant(const char *name, size_t length, const option *table, int count) {
  const option *found = NULL;
  for (; length > 2; length--, found = NULL) {
    int hits = 0;
    for (int i = 0; i < count; i++)
      if (strncmp(table[i].name, name, length) == 0) found = &table[i], hits++;
    if (hits > 0) return hits == 1 ? found : NULL;
  }
  return NULL;
}

static noreturn void unknown(const char *argument, size_t length, const option *table, int count) {
  const option *near = meant(argument, length, table, count);
  if (argument[0] != '-') usage_error("unexpected argument '%s'; options begin with --", argument);
  if (near != NULL) usage_error("unknown option '%.*s'; did you mean %s?", (int)length, argument, near->name);
  usage_error("unknown option '%.*s'", (int)length, argument);
}

static void read_count(const option *o, const char *text) {
  char *end;
  errno = 0;
  long n = strtol(text, &end, 10);
  if (end == text || *end != '\0') usage_error("%s %s: not a whole number; write for example %s 2", o->name, text, o->name);
  if (errno != 0 || (double)n < o->least || (double)n > o->most)
    usage_error("%s %s: must be from %.0f to %.0f", o->name, text, o->least, o->most);
  *(int *)o->value = (int)n;
}

static void read_real(const option *o, const char *text) {
  char *end;
  double x = strtod(text, &end);
  if (end == text || *end != '\0' || !isfinite(x))
    usage_error("%s %s: not a number that can be used here; write for example %s 0.5", o->name, text, o->name);
  if (o->kind == OPTION_ABOVE && x <= o->least) usage_error("%s %s: must be greater than %g", o->name, text, o->least);
  if (x < o->least) usage_error("%s %s: must be at least %g", o->name, text, o->least);
  if (x > o->most) usage_error("%s %s: must be at most %g", o->name, text, o->most);
  *(double *)o->value = x;
}

static void read_text(const option *o, const char *text) {
  if (*text == '\0') usage_error("%s: the %s is empty", o->name, o->operand);
  *(const char **)o->value = text;
}

static void add_text(const option *o, const char *text) {
  option_texts *all = o->value;
  if (*text == '\0') usage_error("%s: the %s is empty", o->name, o->operand);
  if (all->count == OPTION_MOST_TEXTS) usage_error("%s: at most %d of them", o->name, OPTION_MOST_TEXTS);
  all->text[all->count++] = text;
}

static void read_choice(const option *o, const char *text) {
  for (int i = 0; o->choices[i] != NULL; i++) {
    if (strcmp(text, o->choices[i]) != 0) continue;
    *(int *)o->value = i;
    return;
  }
  usage_error("%s %s: choose one of %s", o->name, text, o->operand);
}

static void read_value(const option *o, const char *text) {
  switch (o->kind) {
  case OPTION_FLAG:
    *(bool *)o->value = true;
    break;
  case OPTION_COUNT:
    read_count(o, text);
    break;
  case OPTION_REAL:
  case OPTION_ABOVE:
    read_real(o, text);
    break;
  case OPTION_TEXT:
    read_text(o, text);
    break;
  case OPTION_TEXTS:
    add_text(o, text);
    break;
  case OPTION_CHOICE:
    read_choice(o, text);
    break;
  }
}

void read_options(int argc, char **argv, const option *table, int count, const manual *text) {
  unsigned long long files = 0; /* bits of those that have been given */
  usage_command(text->command);
  for (int i = 1; i < argc; i++) {
    size_t length = strcspn(argv[i], "=");
    const char *attached = argv[i][length] == '=' ? argv[i] + length + 1 : NULL;
    if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) print_manual(table, count, text);
    const option *o = find(argv[i], length, table, count);
    if (o == NULL) unknown(argv[i], length, table, count);
    if (o->kind == OPTION_FLAG && attached != NULL) usage_error("%s takes no value", o->name);
    if (o->kind != OPTION_FLAG && attached == NULL && i + 1 == argc)
      usage_error("%s needs a value: %s %s", o->name, o->name, o->operand);
    if (o->kind == OPTION_TEXT && strncmp(o->operand, "FILE", 4) == 0) {
      if (files >> (o - table) & 1) usage_error("%s is given twice", o->name);
      files |= 1ull << (o - table);
    }
    read_value(o, o->kind == OPTION_FLAG ? NULL : attached != NULL ? attached : argv[++i]);
  }
}
