/* The test programs that `tlgen --selftest` prints: every derivative of a generated model against differences, in quad precision, of
 * the C that it was made from. A printed file fills a tlgen_selftest and hands it to tlgen_selftest_main. Needs __float128 and
 * libquadmath. */
#ifndef TLGEN_SELFTEST_H
#define TLGEN_SELFTEST_H

#include "eom/model.h"

#include <stddef.h>

/* double and float, where quad.h has given these words another meaning. */
typedef double tlgen_double;
typedef float tlgen_single;

/* A function of the model as plain C in quad precision. out: its rows; q, qd: n numbers each, the function's own copies; params: the
 * parameter struct of quad.h's C. */
typedef void tlgen_quad_fn(__float128 *out, __float128 *q, __float128 *qd, __float128 t, void *params);

typedef enum tlgen_kind { TLGEN_DOUBLE, TLGEN_FLOAT, TLGEN_SIGNED, TLGEN_UNSIGNED } tlgen_kind;

/* A number of the parameter struct, or an array of numbers, or a pointer to some. */
typedef struct tlgen_member {
  const char *name; /* as in C behind "p->": "arm[0].length" */
  tlgen_kind kind;
  size_t size, quad_size;     /* bytes of one number; where quad.h makes it a __float128 */
  size_t count;               /* numbers; 0 for a pointer, which takes as many as are given */
  size_t offset, quad_offset; /* in the struct, and in that of quad.h's C, bytes */
} tlgen_member;

/* A row for a member of both structs; our_number and number are its type in each. The name stands as it is written, whatever quad.h
 * calls it. */
#define TLGEN_MEMBER(ours, theirs, kind, our_number, number, count, member)                                                            \
  {#member, kind, sizeof(our_number), sizeof(number), count, offsetof(ours, member), offsetof(theirs, member)}

typedef struct tlgen_params {
  size_t size, quad_size; /* of the struct, bytes */
  size_t count;           /* of the members */
  const tlgen_member *members;
} tlgen_params;

typedef struct tlgen_selftest {
  const eom_model *model;
  tlgen_quad_fn *const *functions; /* those the model has: Lagrangian, force, holonomic, nonholonomic constraints */
  const tlgen_params *params;      /* null where the model has none */
  int takes_time;                  /* whether some function takes t */
  int single; /* whether single precision depends on the coordinates: the differences are of the C without its rounding */
} tlgen_selftest;

/* The whole program: reads options, points and parameters, prints a table. Exit status: 0 all derivatives agree, 1 some do not, 2 wrong
 * usage. */
int tlgen_selftest_main(int argc, char **argv, const tlgen_selftest *test);

/* Partial derivatives of order 0 to 3 by nested five-point central differences,
 *
 *     f'(x) = (f(x-2h) - 8 f(x-h) + 8 f(x+h) - f(x+2h))/(12h) + h^4 f'''''/30 + ..
 *
 *   out      rows numbers: the derivative by x[index[0]], .., x[index[order-1]]
 *   x        2n+1 numbers q, qd, t; changed during the call
 *   step     2n+1 numbers: h of each variable
 *   scratch  4*rows + 2n+1 numbers */
void tlgen_difference(__float128 *out, int rows, tlgen_quad_fn *f, int n, __float128 *x, void *params, const __float128 *step,
                      int order, const int *index, __float128 *scratch);

#endif
