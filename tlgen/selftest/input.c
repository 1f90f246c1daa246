/* Texts like  m=1.5 length=1,2  as numbers of a parameter struct and of points. */
#include "input.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const separators = " \t\r\n,;";

void *input_memory(size_t count, size_t size) {
  void *memory = calloc(count ? count : 1, size);
  if (!memory) {
    fprintf(stderr, "out of memory\n");
    exit(2);
  }
  return memory;
}

static int wrong(const input *in, const char *format, ...) {
  va_list arguments;
  fprintf(stderr, "%s_selftest: ", in->test->model->name);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  return 0;
}

void input_add(input *in, const char *word, const char *text) {
  const size_t length = strlen(word) + strlen(text) + 2;
  char *line = input_memory(length, 1);
  snprintf(line, length, "%s %s", word, text);
  char **texts = input_memory((size_t)in->ntexts + 1, sizeof *texts);
  if (in->ntexts) memcpy(texts, in->texts, (size_t)in->ntexts * sizeof *texts);
  free(in->texts);
  in->texts = texts;
  texts[in->ntexts++] = line;
  in->asked += strcmp(word, "point") == 0;
}

static int starts_with(const char *text, const char *word) {
  const size_t length = strlen(word);
  return strncmp(text, word, length) == 0 && (!text[length] || strchr(separators, text[length]));
}

int input_read(input *in, const char *path) {
  char line[4096];
  FILE *file = fopen(path, "r");
  if (!file) return wrong(in, "cannot read %s: %s", path, strerror(errno));
  for (int number = 1; fgets(line, sizeof line, file); number++) {
    const int whole = strchr(line, '\n') || feof(file);
    line[strcspn(line, "#\n")] = '\0';
    const char *start = line + strspn(line, separators);
    const char *word = starts_with(start, "params") ? "params" : starts_with(start, "point") ? "point" : NULL;
    if (*start && (!word || !whole)) {
      fclose(file);
      return wrong(in, word ? "%s:%d: the line is too long" : "%s:%d: a line begins with 'params' or 'point'", path, number);
    }
    if (word) input_add(in, word, start + strlen(word));
  }
  const int bad = ferror(file);
  fclose(file);
  return bad ? wrong(in, "cannot read %s", path) : 1;
}

/* "name=v,v .." cut into words: the values of one name. */
typedef struct list {
  char *name; /* null at the end of the text */
  char *values[1024];
  int count;
  int fill; /* ".." behind the last: it stands for all that follow */
} list;

static int fits(const list *l, size_t count) { return l->fill ? (size_t)l->count <= count : (size_t)l->count == count; }

static const char *value(const list *l, size_t i) { return l->values[i < (size_t)l->count ? i : (size_t)l->count - 1]; }

/* The next list of the text at *rest, which is cut up. False, with a message, where a value stands without a name. */
static int next_list(const input *in, char **rest, list *l) {
  char *equals, *word = *rest + strspn(*rest, separators);
  l->name = NULL;
  l->count = l->fill = 0;
  while (*word) {
    char *end = word + strcspn(word, separators), *following = end + strspn(end, separators);
    equals = memchr(word, '=', (size_t)(end - word));
    if (equals && l->name) break;
    *end = '\0';
    if (!equals && !l->name) return wrong(in, "'%s' has no name: write NAME=%s", word, word);
    if (equals) {
      *equals = '\0';
      l->name = word;
      word = equals + 1;
    }
    if (l->count == (int)(sizeof l->values / sizeof *l->values)) return wrong(in, "'%s' has too many numbers", l->name);
    if (*word) l->values[l->count++] = word;
    word = following;
  }
  l->fill = l->count > 1 && strcmp(l->values[l->count - 1], "..") == 0;
  l->count -= l->fill;
  *rest = word;
  return 1;
}

static int parse_double(const input *in, const char *name, const char *text, double *x) {
  char *end;
  *x = strtod(text, &end);
  return !*end && end != text ? 1 : wrong(in, "%s: '%s' is not a number", name, text);
}

/* Stores an integer of that size; false where it does not fit. */
static int store_integer(const tlgen_member *m, void *to, const char *text) {
  char *end;
  const int bits = (int)(8 * m->size);
  long long s;
  errno = 0;
  if (m->kind == TLGEN_SIGNED) {
    s = strtoll(text, &end, 0);
    if (bits < 64 && (s < -(1LL << (bits - 1)) || s >= 1LL << (bits - 1))) return 0;
  } else {
    const unsigned long long u = strtoull(text, &end, 0);
    if (strchr(text, '-') || (bits < 64 && u >> bits)) return 0;
    s = (long long)u;
  }
  if (errno || *end || end == text) return 0;
  const signed char i8 = (signed char)s;
  const short i16 = (short)s;
  const int i32 = (int)s;
  const void *from = m->size == 1 ? (const void *)&i8 : m->size == 2 ? (const void *)&i16 : m->size == 4 ? (const void *)&i32 : &s;
  memcpy(to, from, m->size);
  return 1;
}

/* One number of a member in both structs. */
static int store(const input *in, const tlgen_member *m, const char *text, char *to, char *quad) {
  double x;
  if (m->kind == TLGEN_DOUBLE || m->kind == TLGEN_FLOAT) {
    if (!parse_double(in, m->name, text, &x)) return 0;
    const float single = (float)x;
    const __float128 wide = (__float128)x;
    memcpy(to, m->kind == TLGEN_FLOAT ? (const void *)&single : &x, m->size);
    const __float128 wide_single = (__float128)single;
    if (m->kind == TLGEN_FLOAT && m->quad_size == sizeof single)
      memcpy(quad, &single, m->size);
    else
      memcpy(quad, m->kind == TLGEN_FLOAT ? &wide_single : &wide, sizeof wide);
    return 1;
  }
  if (!store_integer(m, to, text)) return wrong(in, "%s: '%s' is not an integer of its type", m->name, text);
  memcpy(quad, to, m->size);
  return 1;
}

static int store_member(input *in, const tlgen_member *m, const list *l) {
  char *to = (char *)in->params + m->offset, *quad = (char *)in->quad_params + m->quad_offset;
  const size_t count = m->count ? m->count : (size_t)l->count;
  if (!fits(l, count) || (l->fill && !m->count)) return wrong(in, "parameter '%s' has %zu numbers, not %d", m->name, count, l->count);
  if (m->count == 0) {
    char *numbers = input_memory(count, m->size), *quads = input_memory(count, m->quad_size);
    memcpy(to, &numbers, sizeof numbers);
    memcpy(quad, &quads, sizeof quads);
    to = numbers, quad = quads;
  }
  for (size_t i = 0; i < count; i++)
    if (!store(in, m, value(l, i), to + i * m->size, quad + i * m->quad_size)) return 0;
  return 1;
}

static int resolve_params(input *in) {
  const tlgen_params *p = in->test->params;
  if (!p) {
    for (int k = 0; k < in->ntexts; k++)
      if (starts_with(in->texts[k], "params")) return wrong(in, "the model has no parameters");
    return 1;
  }
  in->params = input_memory(1, p->size);
  in->quad_params = input_memory(1, p->quad_size);
  char *seen = input_memory(p->count, 1);
  int good = 1;
  for (int k = 0; good && k < in->ntexts; k++) {
    char *rest = in->texts[k] + strlen("params");
    list l = {0};
    if (!starts_with(in->texts[k], "params")) continue;
    while (good && (good = next_list(in, &rest, &l)) && l.name) {
      size_t i = 0;
      while (i < p->count && strcmp(p->members[i].name, l.name) != 0) i++;
      if (i == p->count)
        good = wrong(in, "the parameter struct has no member '%s'", l.name);
      else if (seen[i]++)
        good = wrong(in, "parameter '%s' is given twice", l.name);
      else
        good = store_member(in, &p->members[i], &l);
    }
  }
  for (size_t i = 0; good && i < p->count; i++)
    if (!seen[i]) good = wrong(in, "parameter '%s' is missing: add --params %s=..", p->members[i].name, p->members[i].name);
  free(seen);
  return good;
}

/* The point number in->npoints. */
static int resolve_point(input *in, char *text, double *x) {
  int seen[3] = {0};
  static const char *const names[] = {"q", "qd", "t"};
  const int where[] = {0, in->n, 2 * in->n}, counts[] = {in->n, in->n, 1};
  list l = {0};
  char *rest = text + strlen("point");
  for (;;) {
    int i = 0;
    if (!next_list(in, &rest, &l)) return 0;
    if (!l.name) break;
    while (i < 3 && strcmp(names[i], l.name) != 0) i++;
    if (i == 3) return wrong(in, "point %d: '%s' is none of q, qd and t", in->npoints, l.name);
    if (seen[i]++) return wrong(in, "point %d: %s is given twice", in->npoints, l.name);
    if (!fits(&l, (size_t)counts[i]))
      return wrong(in, "point %d: %s has %d numbers, not %d", in->npoints, names[i], counts[i], l.count);
    for (int k = 0; k < counts[i]; k++)
      if (!parse_double(in, l.name, value(&l, (size_t)k), &x[where[i] + k])) return 0;
  }
  for (int i = 0; i < 3; i++)
    if (!seen[i] && (i < 2 || in->test->takes_time)) return wrong(in, "point %d: %s is missing", in->npoints, names[i]);
  return 1;
}

int input_resolve(input *in) {
  const eom_model *m = in->test->model;
  if (m->params_size != (in->test->params ? in->test->params->size : 0))
    return wrong(in, "the parameter struct of the model has another size than in this program: were both compiled alike?");
  if (!resolve_params(in)) return 0;
  in->n = m->dof(in->params);
  if (in->n < 1) return wrong(in, "these parameters make %d coordinates", in->n);
  in->points = input_memory((size_t)in->ntexts, sizeof *in->points);
  for (int k = 0; k < in->ntexts; k++) {
    if (starts_with(in->texts[k], "params")) continue;
    in->points[in->npoints] = input_memory(2 * (size_t)in->n + 1, sizeof(double));
    if (!resolve_point(in, in->texts[k], in->points[in->npoints++])) return 0;
  }
  return 1;
}

void input_example(const tlgen_selftest *test) {
  const tlgen_params *p = test->params;
  fprintf(stderr, "  %s_selftest", test->model->name);
  for (size_t i = 0; p && i < p->count; i++) {
    const tlgen_member *m = &p->members[i];
    const char *number = m->kind == TLGEN_DOUBLE || m->kind == TLGEN_FLOAT ? "1.5" : "2";
    fprintf(stderr, "%s%s=%s", i ? " " : " --params \"", m->name, number);
    for (size_t k = 1; k < m->count && k < 3; k++) fprintf(stderr, ",%s", number);
    fprintf(stderr, "%s%s", m->count > 3 ? ",.." : m->count == 0 ? ",1.5" : "", i + 1 == p->count ? "\"" : "");
  }
  fprintf(stderr, " --point \"q=0.3,.. qd=-0.7,..%s\"\n", test->takes_time ? " t=0.5" : "");
}

void input_free(input *in) {
  const tlgen_params *p = in->test->params;
  for (size_t i = 0; in->params && i < p->count; i++) {
    void *numbers;
    if (p->members[i].count) continue;
    memcpy(&numbers, (char *)in->params + p->members[i].offset, sizeof numbers);
    free(numbers);
    memcpy(&numbers, (char *)in->quad_params + p->members[i].quad_offset, sizeof numbers);
    free(numbers);
  }
  for (int k = 0; k < in->npoints; k++) free(in->points[k]);
  for (int k = 0; k < in->ntexts; k++) free(in->texts[k]);
  free(in->points);
  free(in->texts);
  free(in->params);
  free(in->quad_params);
}
