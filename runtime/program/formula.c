/* Formulas of a user: read by recursive descent into nodes, which stand in one array in the order of evaluation. */
#include "formula.h"

#include "host/nearest.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 512, MOST_DEPTH = 64, MOST_NAME = 96 };

typedef double one_argument(double);
typedef double two_arguments(double, double);

static const struct {
  const char *name;
  one_argument *one;
  two_arguments *two;
} functions[] = {
    {"sin", sin, NULL},     {"cos", cos, NULL},   {"tan", tan, NULL},     {"asin", asin, NULL},   {"acos", acos, NULL},
    {"atan", atan, NULL},   {"sinh", sinh, NULL}, {"cosh", cosh, NULL},   {"tanh", tanh, NULL},   {"exp", exp, NULL},
    {"log", log, NULL},     {"sqrt", sqrt, NULL}, {"cbrt", cbrt, NULL},   {"fabs", fabs, NULL},   {"abs", fabs, NULL},
    {"floor", floor, NULL}, {"ceil", ceil, NULL}, {"atan2", NULL, atan2}, {"hypot", NULL, hypot}, {"pow", NULL, pow},
    {"fmod", NULL, fmod},   {"min", NULL, fmin},  {"max", NULL, fmax},
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

typedef enum operation { NUMBER, Q, QD, TIME, X, Y, K, PARAMETER, NEGATE, ADD, SUBTRACT, MULTIPLY, DIVIDE, POWER, CALL } operation;

typedef struct node {
  operation op;
  double value;           /* NUMBER */
  const eom_parameter *p; /* PARAMETER */
  int function;           /* CALL */
  int a, b;               /* operands, or index: nodes; -1 for none */
} node;

struct formula {
  int count, root;
  node nodes[];
};

/* ---- reading ---- */

typedef struct reader {
  const char *text, *at;
  formula_names names;
  const model *m;
  formula *f;
  int depth;
  char *error;
  size_t size;
} reader;

static int fail(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Keeps the first complaint. Returns -1, the node that is none. */
static int fail(reader *r, const char *format, ...) {
  if (r->error[0] != '\0') return -1;
  char what[256];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(what, sizeof what, format, arguments);
  va_end(arguments);
  snprintf(r->error, r->size, "'%s': %s at character %d", r->text, what, (int)(r->at - r->text) + 1);
  return -1;
}

/* What stands where nothing can: a character, all bytes of it. */
static int fail_here(reader *r) {
  int bytes = 1;
  while (((unsigned char)r->at[bytes] & 0xC0) == 0x80) bytes++; /* UTF-8's further ones */
  return fail(r, "'%.*s' does not belong here", bytes, r->at);
}

static int put(reader *r, node n) {
  if (r->f->count == MOST_NODES) return fail(r, "the formula is too long");
  r->f->nodes[r->f->count] = n;
  return r->f->count++;
}

static void skip(reader *r) {
  while (isspace((unsigned char)*r->at)) r->at++;
}

static bool take(reader *r, char c) {
  skip(r);
  if (*r->at != c) return false;
  r->at++;
  return true;
}

static int sum(reader *r);

static int wanted(reader *r, char c) { return take(r, c) ? 0 : fail(r, "'%c' is missing", c); }

/* The characters of a name from `at` on; elements and members of structs belong to it: "link[2].mass", but not a last index. */
static size_t name_length(const reader *r, const char *at) {
  size_t n = 0;
  while (isalnum((unsigned char)at[n]) || at[n] == '_') n++;
  if (n == 0 || r->m == NULL) return n;
  for (size_t m = n; at[m] != '\0'; m++) {
    if (model_parameter(r->m, at, m)) n = m;
    if (!isalnum((unsigned char)at[m]) && strchr("_.[]", at[m]) == NULL) break;
  }
  return n;
}

/* "[index]", or -1 where there is none. */
static int read_index(reader *r) {
  if (!take(r, '[')) return -1;
  const int i = sum(r);
  return wanted(r, ']') == 0 ? i : -1;
}

static double value(const formula *f, int at, const formula_point *p);

/* Whether nothing but numbers and parameters stands in a node: then its value is known. */
static bool is_constant(const formula *f, int at) {
  const node *n = &f->nodes[at];
  if (n->op == Q || n->op == QD || n->op == TIME || n->op == X || n->op == Y || n->op == K) return false;
  return (n->a < 0 || is_constant(f, n->a)) && (n->b < 0 || is_constant(f, n->b));
}

/* Whether the number of a point in a drawing stands in a node, and nothing that changes with the motion: then it is one of few. */
static bool is_counted(const formula *f, int at) {
  const node *n = &f->nodes[at];
  if (n->op == Q || n->op == QD || n->op == TIME || n->op == X || n->op == Y) return false;
  return (n->a < 0 || is_counted(f, n->a)) && (n->b < 0 || is_counted(f, n->b));
}

/* Refuses an index that is not known before the motion, and one that is outside of the array or between its elements. */
static int check_index(reader *r, const char *before, const node *n) {
  const int count = n->op == PARAMETER ? n->p->count : r->m->description->model->dof(r->m->params);
  if (!is_constant(r->f, n->a)) {
    if (is_counted(r->f, n->a)) return 0; /* a point that is not a number is refused there */
    r->at = before;
    return fail(r, "an index may not change with the motion; what does stands");
  }
  const double i = value(r->f, n->a, &(formula_point){.m = r->m});
  if (i >= 0.0 && i < count && !(i > floor(i))) return 0;
  r->at = before;
  return fail(r, "the elements are [0] to [%d]; what is wrong stands", count - 1);
}

static int element(reader *r, node n, bool array) {
  const char *before = r->at;
  n.a = read_index(r);
  if (r->error[0] != '\0') return -1;
  if ((n.a >= 0) != array) {
    r->at = before;
    return array ? fail(r, "an index like [0] is missing") : fail(r, "this is one number and has no elements");
  }
  return array && check_index(r, before, &n) != 0 ? -1 : put(r, n);
}

static int call(reader *r, int function) {
  node n = {.op = CALL, .function = function, .a = -1, .b = -1};
  if (wanted(r, '(') != 0) return -1;
  n.a = sum(r);
  if (functions[function].two != NULL) {
    if (wanted(r, ',') != 0) return -1;
    n.b = sum(r);
  }
  return wanted(r, ')') == 0 ? put(r, n) : -1;
}

static bool is(const char *name, const char *word) { return strcmp(name, word) == 0; }

/* Which of the coordinates or velocities has that name; -1 for none, also where names is null. */
static int component(const model *m, const char *const *names, const char *name) {
  const int n = names != NULL ? m->description->model->dof(m->params) : 0;
  for (int i = 0; i < n; i++)
    if (is(name, names[i])) return i;
  return -1;
}

static int unknown(reader *r, const char *name, size_t length) {
  const char *near = NULL;
  if (r->names != FORMULA_CONSTANTS) near = model_nearest(r->m, name);
  for (int i = 0; i < FUNCTIONS; i++) near = nearer(name, near, functions[i].name);
  r->at -= length;
  if (near != NULL) return fail(r, "there is no '%s' here; did you mean %s? It stands", name, near);
  return fail(r, "there is no '%s' here; it stands", name);
}

static int named(reader *r) {
  static const struct {
    const char *name;
    operation op;
    formula_names least;
    bool array;
  } own[] = {{"q", Q, FORMULA_STATE, true},    {"qd", QD, FORMULA_STATE, true},  {"t", TIME, FORMULA_STATE, false},
             {"x", X, FORMULA_DRAWING, false}, {"y", Y, FORMULA_DRAWING, false}, {"k", K, FORMULA_DRAWING, false}};
  char name[MOST_NAME];
  const size_t length = name_length(r, r->at);
  if (length >= sizeof name) return fail(r, "the name is too long");
  memcpy(name, r->at, length);
  name[length] = '\0';
  r->at += length;
  for (size_t i = 0; i < sizeof own / sizeof own[0]; i++)
    if (r->names >= own[i].least && is(name, own[i].name)) return element(r, (node){.op = own[i].op, .a = -1, .b = -1}, own[i].array);
  const eom_parameter *p = r->names >= FORMULA_STATE ? model_parameter(r->m, name, length) : NULL;
  if (p != NULL) return element(r, (node){.op = PARAMETER, .p = p, .a = -1, .b = -1}, p->count > 0);
  for (operation op = Q; r->names >= FORMULA_STATE && op <= QD; op++) {
    const eom_description *d = r->m->description;
    const int i = component(r->m, op == Q ? d->coordinate : d->velocity, name);
    if (i >= 0) return put(r, (node){.op = op, .a = put(r, (node){.op = NUMBER, .value = i, .a = -1, .b = -1}), .b = -1});
  }
  if (is(name, "pi")) return put(r, (node){.op = NUMBER, .value = acos(-1.0), .a = -1, .b = -1});
  for (int f = 0; f < FUNCTIONS; f++)
    if (is(name, functions[f].name)) return call(r, f);
  return unknown(r, name, length);
}

static int primary(reader *r) {
  if (take(r, '(')) {
    const int inside = sum(r);
    return wanted(r, ')') == 0 ? inside : -1;
  }
  if (isdigit((unsigned char)*r->at) || *r->at == '.') {
    char *end;
    const double value = strtod(r->at, &end);
    if (end == r->at) return fail(r, "this is no number");
    r->at = end;
    return put(r, (node){.op = NUMBER, .value = value, .a = -1, .b = -1});
  }
  if (isalpha((unsigned char)*r->at) || *r->at == '_') return named(r);
  return *r->at == '\0' ? fail(r, "something is missing") : fail_here(r);
}

static int factor(reader *r);

/* a ^ b binds tighter than a sign on its left, and from right to left. */
static int power(reader *r) {
  const int a = primary(r);
  if (a < 0 || !take(r, '^')) return a;
  const int b = factor(r);
  return b < 0 ? -1 : put(r, (node){.op = POWER, .a = a, .b = b});
}

static int factor(reader *r) {
  if (r->depth == MOST_DEPTH) return fail(r, "too deeply nested");
  r->depth++;
  int result;
  if (take(r, '-')) {
    const int a = factor(r);
    result = a < 0 ? -1 : put(r, (node){.op = NEGATE, .a = a, .b = -1});
  } else {
    result = take(r, '+') ? factor(r) : power(r);
  }
  r->depth--;
  return result;
}

/* A chain of operands with operators of one rank between them. */
static int chain(reader *r, int (*operand)(reader *r), char first, operation one, char second, operation other) {
  int a = operand(r);
  while (a >= 0) {
    const operation op = take(r, first) ? one : take(r, second) ? other : NUMBER;
    if (op == NUMBER) return a;
    const int b = operand(r);
    a = b < 0 ? -1 : put(r, (node){.op = op, .a = a, .b = b});
  }
  return -1;
}

static int product(reader *r) { return chain(r, factor, '*', MULTIPLY, '/', DIVIDE); }
static int sum(reader *r) { return chain(r, product, '+', ADD, '-', SUBTRACT); }

formula *formula_parse(const char *text, formula_names names, const model *m, char *error, size_t size) {
  formula *f = malloc(sizeof *f + MOST_NODES * sizeof f->nodes[0]);
  error[0] = '\0';
  if (f == NULL) {
    snprintf(error, size, "not enough memory");
    return NULL;
  }
  f->count = 0;
  reader r = {.text = text, .at = text, .names = names, .m = m, .f = f, .error = error, .size = size};
  f->root = sum(&r);
  skip(&r);
  if (error[0] == '\0' && *r.at != '\0') fail_here(&r);
  if (error[0] == '\0') return f;
  free(f);
  return NULL;
}

void formula_free(formula *f) { free(f); }

/* ---- evaluating ---- */

static double state(const double *v, int n, double i) { return v != NULL && i >= 0.0 && i < n ? v[(int)i] : (double)NAN; }

static double value(const formula *f, int at, const formula_point *p) {
  if (at < 0) return (double)NAN;
  const node *n = &f->nodes[at];
  const double a = n->a >= 0 ? value(f, n->a, p) : 0.0, b = n->b >= 0 ? value(f, n->b, p) : 0.0;
  switch (n->op) {
  case NUMBER:
    return n->value;
  case Q:
    return state(p->q, p->n, a);
  case QD:
    return state(p->qd, p->n, a);
  case TIME:
    return p->t;
  case X:
    return p->x;
  case Y:
    return p->y;
  case K:
    return p->k;
  case PARAMETER:
    return a >= 0.0 && a < 1e9 ? parameter_value(p->m, n->p, (long)a) : (double)NAN;
  case NEGATE:
    return -a;
  case ADD:
    return a + b;
  case SUBTRACT:
    return a - b;
  case MULTIPLY:
    return a * b;
  case DIVIDE:
    return a / b;
  case POWER:
    return pow(a, b);
  case CALL:
    return functions[n->function].one != NULL ? functions[n->function].one(a) : functions[n->function].two(a, b);
  }
  return (double)NAN;
}

double formula_value(const formula *f, const formula_point *at) { return value(f, f->root, at); }

int formula_number(const char *text, double *result, char *error, size_t size) {
  char number[256];
  size_t length = strlen(text);
  double unit = 1.0;
  if (length >= sizeof number) {
    snprintf(error, size, "'%.20s...': too long for a number", text);
    return -1;
  }
  memcpy(number, text, length + 1);
  if (length > 3 && strcmp(number + length - 3, "deg") == 0) {
    number[length - 3] = '\0';
    unit = acos(-1.0) / 180.0;
  }
  formula *f = formula_parse(number, FORMULA_CONSTANTS, NULL, error, size);
  if (f == NULL) return -1;
  *result = unit * formula_value(f, &(formula_point){.n = 0});
  formula_free(f);
  if (isfinite(*result)) return 0;
  snprintf(error, size, "'%s': not a finite number", text);
  return -1;
}
