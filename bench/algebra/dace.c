/* DACE, the core of PyPI's daceypy, through its C functions: truncated polynomials in all variables as sorted lists of monomials.
 * Argument: the path of its shared library. Complete shapes, and jets along a curve as polynomials in one variable. */
#include "contender.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct polynomial { /* DACEDA in its dacecompat.h */
  unsigned length, capacity;
  void *monomials;
} polynomial;

static struct {
  void (*initialize)(unsigned order, unsigned nvar);
  double (*set_epsilon)(double);
  void (*allocate)(polynomial *, unsigned);
  void (*set)(polynomial *, const unsigned *, double);
  double (*get)(const polynomial *, const unsigned *);
  void (*multiply)(const polynomial *, const polynomial *, polynomial *),
      (*divide)(const polynomial *, const polynomial *, polynomial *);
  void (*square_root)(const polynomial *, polynomial *), (*exponential)(const polynomial *, polynomial *);
  void (*sine)(const polynomial *, polynomial *), (*cosine)(const polynomial *, polynomial *);
  void (*power)(const polynomial *, double, polynomial *);
} dace;

static const algebra_task *task;
static polynomial a, b, result[2];

enum { MAX_VARIABLES = 64 };

static int nvariables(const tl_shape *s) { return s->nvar > 0 ? s->nvar : 1; }

static void exponents_of(int at, unsigned *exponent) {
  const int *given = task->exponents + at * (task->shape->nvar + 1);
  exponent[0] = (unsigned)given[0]; /* of a jet along a curve */
  for (int v = 0; v < task->shape->nvar; v++) exponent[v] = (unsigned)given[v + 1];
}

static void load(polynomial *to, const double *from) {
  unsigned exponent[MAX_VARIABLES];
  dace.allocate(to, 0);
  for (int i = 0; from != NULL && i < task->shape->ncoef; i++) {
    exponents_of(i, exponent);
    dace.set(to, exponent, from[i]);
  }
}

static int prepare(const algebra_task *given) {
  const tl_shape *s = given->shape;
  if (s->curve > 0 && s->nvar > 0) return -1;
  task = given;
  dace.initialize((unsigned)s->degree, (unsigned)nvariables(s)); /* forgets all polynomials */
  dace.set_epsilon(0.0);
  load(&a, task->a);
  load(&b, task->b);
  for (int i = 0; i < 2; i++) dace.allocate(&result[i], 0);
  return 0;
}

static void run(void) {
  switch (task->operation) {
  case ALGEBRA_MUL:
    dace.multiply(&a, &b, &result[0]);
    break;
  case ALGEBRA_DIV:
    dace.divide(&a, &b, &result[0]);
    break;
  case ALGEBRA_SQRT:
    dace.square_root(&a, &result[0]);
    break;
  case ALGEBRA_EXP:
    dace.exponential(&a, &result[0]);
    break;
  case ALGEBRA_SINCOS:
    dace.sine(&a, &result[0]);
    dace.cosine(&a, &result[1]);
    break;
  default:
    dace.power(&a, ALGEBRA_EXPONENT, &result[0]);
  }
}

static double difference(const double *c) {
  double worst = 0.0, largest = 0.0;
  const int n = task->shape->ncoef;
  for (int i = 0; i < (task->operation == ALGEBRA_SINCOS ? 2 * n : n); i++) {
    unsigned exponent[MAX_VARIABLES];
    exponents_of(i % n, exponent);
    worst = fmax(worst, fabs(dace.get(&result[i / n], exponent) - c[i]));
    largest = fmax(largest, fabs(c[i]));
  }
  return worst / largest;
}

/* ISO C knows no way from dlsym's void pointer to a function but by its bytes. */
static int find(void *library, const char *name, void *function) {
  void *symbol = dlsym(library, name);
  if (symbol == NULL) fprintf(stderr, "DACE has no %s\n", name);
  memcpy(function, &symbol, sizeof symbol);
  return symbol != NULL;
}

int algebra_open(const char *argument, algebra_contender *contender) {
  void *library = dlopen(argument, RTLD_NOW);
  if (library == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    return -1;
  }
  *contender = (algebra_contender){.name = "DACE", .prepare = prepare, .run = run, .difference = difference};
  return find(library, "daceInitialize", &dace.initialize) && find(library, "daceSetEpsilon", &dace.set_epsilon) &&
                 find(library, "daceAllocateDA", &dace.allocate) && find(library, "daceSetCoefficient", &dace.set) &&
                 find(library, "daceGetCoefficient", &dace.get) && find(library, "daceMultiply", &dace.multiply) &&
                 find(library, "daceDivide", &dace.divide) && find(library, "daceSquareRoot", &dace.square_root) &&
                 find(library, "daceExponential", &dace.exponential) && find(library, "daceSine", &dace.sine) &&
                 find(library, "daceCosine", &dace.cosine) && find(library, "dacePowerDouble", &dace.power)
             ? 0
             : -1;
}
