/* What every subcommand begins with: a model, its parameters and a start, from a text file and options. */
#define _GNU_SOURCE
#include "setup.h"

#include "eom/assemble.h"
#include "eom/solve.h"
#include "formula.h"
#include "host/message.h"
#include "host/nearest.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_N = 100000, MOST_NAME = 128, MOST_LINE = 1 << 24, ERROR_SIZE = 512 };

const char setup_help[] =
    "Parameters and start, in a text file (--start) or one by one (--set), later ones in the place of earlier ones:\n"
    "  g = 9.81                 # a member of the parameter struct; what is not given is zero\n"
    "  mass = 1 1 2             # the first elements of an array; one value alone fills the whole array\n"
    "  length[2] = 0.5          # one element; members of structs inside: arm.length = 2; one called q: p.q = 1\n"
    "  q = 75 deg, 0, pi/6      # all coordinates; q[0] = 75 deg is one of them\n"
    "  qd[1] = -2               # velocities; t0 = 1 is the time of the start, s\n";

/* ---- values from texts ---- */

/* "name = values", and where that stands. */
typedef struct entry {
  char place[512];
  char name[MOST_NAME];
  char *values;
} entry;

typedef struct entries {
  entry *all;
  int count;
} entries;

static char *trimmed(char *text) {
  while (isspace((unsigned char)*text)) text++;
  for (size_t n = strlen(text); n > 0 && isspace((unsigned char)text[n - 1]);) text[--n] = '\0';
  return text;
}

/* Takes "name = values" apart. text is changed. Returns 0, or -1 after a message. */
static int add_entry(entries *list, const char *place, char *text) {
  char *sign = strchr(text, '=');
  if (sign == NULL || trimmed(sign + 1)[0] == '\0') {
    complain("%s: '%s' is not of the form name = value", place, trimmed(text));
    return -1;
  }
  *sign = '\0';
  const char *name = trimmed(text), *values = trimmed(sign + 1);
  entry *more = realloc(list->all, ((size_t)list->count + 1) * sizeof *more);
  if (more == NULL || strlen(name) >= MOST_NAME || name[0] == '\0') {
    complain("%s: %s", place,
             more == NULL      ? "not enough memory"
             : name[0] == '\0' ? "a name is missing before the ="
                               : "the name is too long");
    if (more != NULL) list->all = more;
    return -1;
  }
  list->all = more;
  entry *e = &list->all[list->count];
  snprintf(e->place, sizeof e->place, "%s", place);
  snprintf(e->name, sizeof e->name, "%s", name);
  e->values = strdup(values);
  if (e->values == NULL) return -1;
  list->count++;
  return 0;
}

static void free_entries(entries *list) {
  for (int i = 0; i < list->count; i++) free(list->all[i].values);
  free(list->all);
}

/* The next line of a file: at most MOST_LINE - 1 characters. Returns 1, 0 at the end of the file, or -1 where it is no line of a text,
 * and *why. */
static int next_line(FILE *file, char *line, const char **why) {
  int length = 0;
  for (int c = 0; c != '\n' && (c = getc(file)) != EOF; line[length++] = (char)c) {
    *why = c == '\0' ? "a byte that no text has" : "the line is too long";
    if (c == '\0' || length == MOST_LINE - 1) return -1;
  }
  line[length] = '\0';
  return length > 0;
}

static int read_lines(entries *list, const char *path, FILE *file, char *text) {
  static const char mark[] = "\xEF\xBB\xBF"; /* of UTF-8, which some editors write at the start */
  const char *why;
  int number = 0, read;
  while ((read = next_line(file, text, &why)) != 0) {
    char place[512];
    snprintf(place, sizeof place, "%s:%d", path, ++number);
    if (read < 0) {
      complain("%s: %s; --start wants lines of name = value", place, why);
      return -1;
    }
    text[strcspn(text, "#")] = '\0';
    char *line = trimmed(number == 1 && strncmp(text, mark, 3) == 0 ? text + 3 : text);
    if (line[0] != '\0' && add_entry(list, place, line) != 0) return -1;
  }
  return 0;
}

static int read_file(entries *list, const char *path) {
  FILE *file = fopen(path, "r");
  char *text = file != NULL ? malloc(MOST_LINE) : NULL;
  int status = text != NULL ? read_lines(list, path, file, text) : -1;
  if (text == NULL || (status == 0 && ferror(file))) {
    complain("--start %s: %s", path, strerror(errno));
    status = -1;
  }
  free(text);
  if (file != NULL) fclose(file);
  return status;
}

/* The next value of a list with blanks or commas between them, "deg" being a part of the value before it: written to token, of which it
 * fills all where it is too long. Returns what follows, or null at the end. */
static const char *next_value(const char *text, char *token, size_t size) {
  size_t n = 0;
  text += strspn(text, " \t,");
  if (*text == '\0') return NULL;
  for (int depth = 0; *text != '\0' && (depth > 0 || strchr(" \t,", *text) == NULL); text++) {
    depth += (*text == '(') - (*text == ')');
    if (n + 1 < size) token[n++] = *text;
  }
  const char *unit = text + strspn(text, " \t");
  if (strncmp(unit, "deg", 3) == 0 && strchr(" \t,", unit[3]) != NULL && n + 4 < size) {
    memcpy(token + n, "deg", 3);
    n += 3;
    text = unit + 3;
  }
  token[n] = '\0';
  return text;
}

/* Whether no value stands before or behind a comma. */
static bool has_gap(const char *text) {
  bool value = false;
  for (int depth = 0; *text != '\0'; text++) {
    depth += (*text == '(') - (*text == ')');
    if (*text == ',' && depth == 0 && !value) return true;
    value = *text == ',' && depth == 0 ? false : value || !isspace((unsigned char)*text);
  }
  return !value;
}

/* The values of an entry into at most `most` numbers. Returns how many there are, or -1 after a message. */
static int read_values(const entry *e, double *value, int most) {
  char token[256], error[ERROR_SIZE];
  int count = 0;
  if (has_gap(e->values)) {
    complain("%s: %s = %s: a value is missing beside a comma", e->place, e->name, e->values);
    return -1;
  }
  for (const char *at = e->values; (at = next_value(at, token, sizeof token)) != NULL; count++) {
    if (count == most) {
      complain("%s: %s has %d value%s at most, and more are given", e->place, e->name, most, most == 1 ? "" : "s");
      return -1;
    }
    const bool whole = strlen(token) + 1 < sizeof token;
    if (whole && formula_number(token, &value[count], error, sizeof error) == 0) continue;
    if (whole)
      complain("%s: %s = %s", e->place, e->name, error);
    else
      complain("%s: %s = %.40s..: a value has %zu characters at most", e->place, e->name, token, sizeof token - 2);
    return -1;
  }
  return count;
}

/* "name[i]": i, and the length of what stands before; -1 where there is no such index at the end. */
static int last_index(const char *name, size_t *length) {
  const char *open = strrchr(name, '[');
  char *end;
  *length = strlen(name);
  if (open == NULL || name[*length - 1] != ']' || !isdigit((unsigned char)open[1])) return -1;
  const long i = strtol(open + 1, &end, 10);
  if (strcmp(end, "]") != 0 || i > MOST_N) return -1;
  *length = (size_t)(open - name);
  return (int)i;
}

const eom_parameter *setup_parameter(const setup *s, const char *name, int *i) {
  size_t length;
  const eom_parameter *p = model_parameter(&s->model, name, strlen(name));
  *i = -1;
  if (p != NULL) return p;
  *i = last_index(name, &length);
  return *i >= 0 ? model_parameter(&s->model, name, length) : NULL;
}

static int store(setup *s, const entry *e, const eom_parameter *p, int i, double value) {
  const char *wrong = parameter_store(&s->model, p, i, value);
  if (wrong != NULL) complain("%s: %s = %s: %s", e->place, e->name, e->values, wrong);
  return wrong != NULL ? -1 : 0;
}

/* One value for all elements, or values for the first ones. */
static int store_all(setup *s, const entry *e, const eom_parameter *p) {
  const int most = parameter_count(p) > 0 ? parameter_count(p) : 1;
  double *value = calloc((size_t)most, sizeof *value);
  int status = value == NULL ? -1 : 0, count = value == NULL ? 0 : read_values(e, value, most);
  if (count < 0) status = -1;
  for (int i = 0; status == 0 && i < (count == 1 ? most : count); i++) status = store(s, e, p, i, value[count == 1 ? 0 : i]);
  free(value);
  return status;
}

static int store_one(setup *s, const entry *e, const eom_parameter *p, int i) {
  double value;
  if (p->count == 0 || i >= p->count) {
    if (p->count == 0)
      complain("%s: %s: %s is one number and has no elements", e->place, e->name, p->name);
    else
      complain("%s: %s: %s has the elements [0] to [%d]", e->place, e->name, p->name, p->count - 1);
    return -1;
  }
  return read_values(e, &value, 1) == 1 ? store(s, e, p, i, value) : -1;
}

/* Whether the entry names a parameter; stores it, with *status 0 or -1. */
static bool take_parameter(setup *s, const entry *e, int *status) {
  const char *name =
      strncmp(e->name, "p.", 2) == 0 && model_parameter(&s->model, e->name, strlen(e->name)) == NULL ? e->name + 2 : e->name;
  int i;
  const eom_parameter *p = setup_parameter(s, name, &i);
  if (p != NULL) *status = i < 0 ? store_all(s, e, p) : store_one(s, e, p, i);
  return p != NULL;
}

static bool is_state(const char *name) {
  size_t length;
  last_index(name, &length);
  return (length == 1 && name[0] == 'q') || (length == 2 && memcmp(name, "qd", 2) == 0) || strcmp(name, "t0") == 0 ||
         strcmp(name, "line") == 0;
}

const char *component_name(const setup *s, int i) {
  static char ring[4][MOST_NAME];
  static int next;
  char *name = ring[next++ % 4];
  const eom_description *d = s->model.description;
  const int k = i % s->n;
  const bool velocity = i >= s->n;
  if (velocity && d->velocity != NULL)
    snprintf(name, MOST_NAME, "%s", d->velocity[k]);
  else if (d->coordinate != NULL)
    snprintf(name, MOST_NAME, velocity ? "%s_dot" : "%s", d->coordinate[k]);
  else
    snprintf(name, MOST_NAME, i < s->n ? "q[%d]" : "qd[%d]", k);
  return name;
}

int component_named(const setup *s, const char *name) {
  size_t length;
  const int i = last_index(name, &length);
  if (i >= 0 && i < s->n && length == 1 && name[0] == 'q') return i;
  if (i >= 0 && i < s->n && length == 2 && memcmp(name, "qd", 2) == 0) return s->n + i;
  for (int k = 0; k < 2 * s->n; k++)
    if (strcmp(component_name(s, k), name) == 0) return k;
  for (int k = 0; k < s->n && s->model.description->coordinate != NULL; k++) { /* whatever the velocities are called */
    const size_t own = strlen(s->model.description->coordinate[k]);
    if (strncmp(name, s->model.description->coordinate[k], own) == 0 && strcmp(name + own, "_dot") == 0) return s->n + k;
  }
  return -1;
}

static int unknown_name(const setup *s, const entry *e) {
  static const char *const own[] = {"q", "qd", "t0", "line"};
  const char *near = model_nearest(&s->model, e->name);
  size_t length;
  if (near == NULL && strchr(e->name, '[') != NULL) { /* an index that is none */
    char stem[MOST_NAME];
    snprintf(stem, sizeof stem, "%.*s", (int)strcspn(e->name, "["), e->name);
    near = model_nearest(&s->model, stem);
  }
  if (last_index(e->name, &length) >= 0 && is_state(e->name)) {
    complain("%s: %s: there are %d coordinates, [0] to [%d]", e->place, e->name, s->n, s->n - 1);
    return -1;
  }
  for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) near = nearer(e->name, near, own[i]);
  for (int k = 0; k < 2 * s->n && s->model.description->coordinate != NULL; k++)
    if (nearer(e->name, near, component_name(s, k)) != near) near = component_name(s, k);
  if (near != NULL)
    complain("%s: unknown name '%s'; did you mean %s? 'eom info %s' lists all", e->place, e->name, near, s->model.path);
  else
    complain("%s: unknown name '%s'; 'eom info %s' lists all", e->place, e->name, s->model.path);
  return -1;
}

static int take_vector(const setup *s, const entry *e, double *v) {
  double *value = calloc((size_t)s->n, sizeof *value);
  const int count = value != NULL ? read_values(e, value, s->n) : -1;
  if (count >= 0 && count != s->n) complain("%s: %s has %d values for %d coordinates", e->place, e->name, count, s->n);
  if (count == s->n) memcpy(v, value, (size_t)s->n * sizeof *value);
  free(value);
  return count == s->n ? 0 : -1;
}

static int take_state(setup *s, const entry *e) {
  if (strcmp(e->name, "q") == 0) return take_vector(s, e, s->q);
  if (strcmp(e->name, "qd") == 0) return take_vector(s, e, s->qd);
  if (strcmp(e->name, "t0") == 0) return read_values(e, &s->t0, 1) == 1 ? 0 : -1;
  if (strcmp(e->name, "line") == 0) {
    if (s->lines == SETUP_MOST_LINES) {
      complain("%s: at most %d lines can be drawn", e->place, SETUP_MOST_LINES);
      return -1;
    }
    s->line[s->lines] = strdup(e->values);
    return s->line[s->lines++] != NULL ? 0 : -1;
  }
  const int i = component_named(s, e->name);
  if (i < 0) return unknown_name(s, e);
  return read_values(e, &s->q[i], 1) == 1 ? 0 : -1;
}

/* ---- options ---- */

void setup_read(setup *s, int argc, char **argv, const option *table, int count, const manual *text) {
  if (argc > 1 && argv[1][0] != '-') {
    s->model.path = argv[1];
    argv[1] = argv[0];
    ++argv, --argc;
  }
  read_options(argc, argv, table, count, text);
  if (s->model.path == NULL) usage_error("which model? eom %s MODEL.so", text->command);
}

option setup_t_end(double *t_end, const char *help) {
  return (option){
      .name = "--t-end", .kind = OPTION_REAL, .value = t_end, .least = -HUGE_VAL, .most = HUGE_VAL, .operand = "T", .help = help};
}

option setup_every(double *every, const char *help) {
  return (option){.name = "--every", .kind = OPTION_ABOVE, .value = every, .most = HUGE_VAL, .operand = "DT", .help = help};
}

void setup_options(setup *s, option *table) {
  const option own[SETUP_OPTIONS] = {
      {.name = "--start",
       .kind = OPTION_TEXT,
       .value = &s->file,
       .operand = "FILE",
       .help = "parameters and start, lines of name = value"},
      {.name = "--set",
       .kind = OPTION_TEXTS,
       .value = &s->set,
       .operand = "NAME=VALUE",
       .help = "one such line: --set 'mass[0]=2'; may be repeated"},
      {.name = "--q",
       .kind = OPTION_TEXT,
       .value = &s->q_text,
       .operand = "LIST",
       .help = "coordinates at the start: --q 75deg,0; default 0"},
      {.name = "--qd", .kind = OPTION_TEXT, .value = &s->qd_text, .operand = "LIST", .help = "velocities at the start; default 0"},
      {.name = "--t0", .kind = OPTION_TEXT, .value = &s->t0_text, .operand = "T", .help = "time at the start, s; default 0"},
      {.name = "--keep",
       .kind = OPTION_TEXT,
       .value = &s->keep_text,
       .operand = "LIST",
       .help = "what stays where the start is made consistent: --keep 'q[0],qd[0]'"},
  };
  memcpy(table, own, sizeof own);
}

static int add_option(entries *list, const char *given_by, const char *name, const char *text) {
  char place[300], line[4096];
  if (text == NULL) return 0;
  snprintf(place, sizeof place, "%s %s", given_by, text);
  if (snprintf(line, sizeof line, "%s%s%s", name, name[0] != '\0' ? "=" : "", text) < (int)sizeof line)
    return add_entry(list, place, line);
  complain("%s: the text is too long", given_by);
  return -1;
}

static int gather(const setup *s, entries *list) {
  if (s->file != NULL && read_file(list, s->file) != 0) return -1;
  for (int i = 0; i < s->set.count; i++)
    if (add_option(list, "--set", "", s->set.text[i]) != 0) return -1;
  if (add_option(list, "--q", "q", s->q_text) != 0 || add_option(list, "--qd", "qd", s->qd_text) != 0) return -1;
  return add_option(list, "--t0", "t0", s->t0_text);
}

/* How many coordinates there are with these parameters. */
static int size_state(setup *s) {
  s->n = s->model.description->model->dof(s->model.params);
  if (s->n < 1 && s->any_size) return s->n = 0;
  if (s->n < 1 || s->n > MOST_N) {
    complain("%s: with these parameters the model has %d coordinates; set what their number depends on ('eom info %s' lists all)",
             s->model.path, s->n, s->model.path);
    return -1;
  }
  s->q = calloc(2 * (size_t)s->n, sizeof *s->q);
  s->keep = calloc(2 * (size_t)s->n, 1);
  if (s->q == NULL || s->keep == NULL) {
    complain("not enough memory for %d coordinates", s->n);
    return -1;
  }
  s->qd = s->q + s->n;
  return 0;
}

static int read_keep(setup *s) {
  char name[MOST_NAME];
  for (const char *at = s->keep_text; at != NULL && (at = next_value(at, name, sizeof name)) != NULL;) {
    const int i = component_named(s, name);
    if (i < 0) {
      complain("--keep %s: there is no coordinate or velocity '%s'; write q[0] to q[%d], qd[0] to qd[%d]", s->keep_text, name, s->n - 1,
               s->n - 1);
      return -1;
    }
    s->keep[i] = 1;
    s->any_kept[i >= s->n] = true;
  }
  return 0;
}

/* Parameters first: the number of coordinates may depend on them. */
static int take_entries(setup *s, const entries *list) {
  int status = 0;
  for (int i = 0; i < list->count; i++)
    if (!is_state(list->all[i].name) && take_parameter(s, &list->all[i], &status) && status != 0) return -1;
  if (size_state(s) != 0) { /* a mistyped name may be why */
    for (int i = 0; i < list->count; i++)
      if (!is_state(list->all[i].name) && !take_parameter(s, &list->all[i], &status)) unknown_name(s, &list->all[i]);
    return -1;
  }
  for (int i = 0; i < list->count; i++) {
    const entry *e = &list->all[i];
    if (!is_state(e->name) && take_parameter(s, e, &status)) continue;
    if (take_state(s, e) != 0) return -1;
  }
  return read_keep(s);
}

int setup_load(setup *s, const char *path, const eom_options *options) {
  entries list = {NULL, 0};
  if (model_open(&s->model, path) != 0) return -1;
  int status = gather(s, &list);
  if (status == 0) status = take_entries(s, &list);
  free_entries(&list);
  if (status == 0 && s->n > 0) {
    const eom_status started = eom_system_create(&s->sys, s->model.description->model, s->model.params, options);
    if (started != EOM_OK) complain("%s: the model cannot be started: %s", path, eom_status_text(started)), status = -1;
  }
  if (status != 0) setup_close(s);
  return status;
}

void setup_close(setup *s) {
  eom_system_destroy(s->sys);
  for (int i = 0; i < s->lines; i++) free(s->line[i]);
  free(s->q);
  free(s->given);
  free(s->keep);
  model_close(&s->model);
  s->sys = NULL, s->q = s->given = NULL, s->keep = NULL, s->lines = 0;
}

/* ---- messages ---- */

void complain_status(const eom_system *sys, eom_status status, const char *what) {
  char text[2048];
  eom_report report = sys->report;
  if (report.status != status) { /* of another module: the system has nothing to say about it */
    complain("%s: %s", what, eom_status_text(status));
    return;
  }
  eom_report_text(&report, text, sizeof text);
  complain("%s: %s", what, trimmed(text));
}

eom_projection setup_projection(const setup *s) {
  return (eom_projection){.keep_q = s->any_kept[0] ? s->keep : NULL, .keep_qd = s->any_kept[1] ? s->keep + s->n : NULL};
}

int setup_consistent(setup *s) {
  if (s->sys->m == 0) return 0;
  eom_projection p = setup_projection(s);
  double *before = malloc(2 * (size_t)s->n * sizeof *before);
  if (before == NULL) return -1;
  memcpy(before, s->q, 2 * (size_t)s->n * sizeof *before);
  const eom_status status = eom_project(s->sys, s->q, s->qd, s->t0, &p);
  s->given = before;
  if (status != EOM_OK)
    complain_status(s->sys, status, "the start cannot be brought onto the constraints");
  else if (p.most_q < 0 && p.most_qd < 0)
    printf("The start satisfies the constraints.\n");
  else {
    printf("The start was brought onto the constraints:");
    const char *between = "";
    if (p.most_q >= 0) {
      printf(" %s from %.10g to %.10g", component_name(s, p.most_q), before[p.most_q], s->q[p.most_q]);
      between = ",";
    }
    if (p.most_qd >= 0) {
      const int i = s->n + p.most_qd;
      printf("%s %s from %.10g to %.10g", between, component_name(s, i), before[i], s->q[i]);
    }
    printf(" (the largest changes).\n");
  }
  return status == EOM_OK ? 0 : -1;
}

bool setup_driven(const setup *s) {
  const double later[] = {0.1234, 1.718, 37.9}; /* s: no whole part of a usual period */
  double *qdd = malloc((size_t)s->n * sizeof *qdd);
  if (qdd == NULL || eom_acceleration(s->sys, s->q, s->qd, s->t0) != EOM_OK) return free(qdd), true;
  memcpy(qdd, s->sys->qdd, (size_t)s->n * sizeof *qdd);
  bool same = eom_energy(s->sys, s->q, s->qd, s->t0) == EOM_OK;
  const double energy = s->sys->energy;
  for (int i = 0; same && i < 3; i++) {
    const double t = s->t0 + later[i];
    same = eom_acceleration(s->sys, s->q, s->qd, t) == EOM_OK && memcmp(qdd, s->sys->qdd, (size_t)s->n * sizeof *qdd) == 0;
    same = same && eom_energy(s->sys, s->q, s->qd, t) == EOM_OK && !(fabs(s->sys->energy - energy) > 0.0);
  }
  free(qdd);
  return !same;
}

/* The characters of "link[2]" in "link[2].mass": the element of an array of structs that a parameter is in; 0: of none. */
static size_t element_length(const char *name) {
  size_t length = 0;
  for (size_t i = 0; name[i] != '\0'; i++)
    if (name[i] == ']' && name[i + 1] == '.') length = i + 1;
  return length;
}

/* Whether parameters i and k are of one element. */
static bool same_element(const eom_description *d, int i, int k) {
  const char *a = d->parameter[i].name, *b = d->parameter[k].name;
  const size_t length = element_length(a);
  return length > 0 && element_length(b) == length && strncmp(a, b, length) == 0;
}

/* Behind parameter i and those of the same element. */
static int element_end(const eom_description *d, int i) {
  int end = i + 1;
  while (end < d->nparameter && same_element(d, i, end)) end++;
  return end;
}

static bool is_missing(const setup *s, int i) { return !s->model.set[i] && parameter_count(&s->model.description->parameter[i]) > 0; }

/* Parameter i is of an element of which nothing was given. */
static bool all_missing(const setup *s, int i) {
  const eom_description *d = s->model.description;
  if (element_length(d->parameter[i].name) == 0) return false;
  while (i > 0 && same_element(d, i, i - 1)) i--;
  for (const int end = element_end(d, i); i < end; i++)
    if (!is_missing(s, i)) return false;
  return true;
}

/* Whether parameters i and k are of elements of one array. */
static bool same_array(const eom_description *d, int i, int k) {
  const char *a = d->parameter[i].name, *b = d->parameter[k].name;
  size_t n = element_length(a);
  while (n > 0 && a[n] != '[') n--;
  return n > 0 && strncmp(a, b, n + 1) == 0;
}

/* The name of parameter i; of whole elements of an array of structs the first and the last one. Returns what comes behind. */
static int print_missing(const setup *s, int i) {
  const eom_description *d = s->model.description;
  const char *name = d->parameter[i].name;
  int last = i, end = element_end(d, i);
  if (!all_missing(s, i)) return printf("%s", name), i + 1;
  for (; end < d->nparameter && same_array(d, i, end) && all_missing(s, end); end = element_end(d, end)) last = end;
  printf("%.*s", (int)element_length(name), name);
  if (last != i) printf(" to %.*s", (int)element_length(d->parameter[last].name), d->parameter[last].name);
  return end;
}

void setup_print(const setup *s) {
  const eom_description *d = s->model.description;
  int missing = 0;
  printf("Model %s: %d coordinate%s", d->model->name, s->n, s->n == 1 ? "" : "s");
  if (s->sys->m > 0) printf(", %d constraint row%s", s->sys->m, s->sys->m == 1 ? "" : "s");
  putchar('\n');
  for (int i = 0; i < d->nparameter;) {
    if (is_missing(s, i)) {
      fputs(missing++ == 0 ? "Parameters that were not given, and are zero: " : ", ", stdout);
      i = print_missing(s, i);
    } else
      i++;
  }
  if (missing > 0) printf(".\n");
}
