/* The comparison of one function of a model, order by order. */
#ifndef TLGEN_SELFTEST_CHECK_H
#define TLGEN_SELFTEST_CHECK_H

#include "input.h"

enum { MAX_ORDER = 3 };

/* What was found for all derivatives of one order, at all points. */
typedef struct verdict {
  long compared;        /* derivatives, rows counted apart */
  long unsettled;       /* of these the differences with step h and 2h disagree: nothing is known */
  double error;         /* the largest of the others, relative to the row's scale */
  int row, point;       /* where, from 0 */
  int index[MAX_ORDER]; /* by which variables, of q, qd, t */
  double actual, expected;
} verdict;

typedef struct settings {
  double rtol;
  double step;   /* h of a variable; step*|x| is tried too where |x| > 1 */
  int max_order; /* 0..MAX_ORDER */
} settings;

/* Compares function f, whose plain C is quad, at all points; preset is what an unwritten row counts as in the jets. Adds to
 * verdicts[0..max_order]. False, with a message on stdout, where a derivative does not exist. */
int check_function(const input *in, const settings *s, const eom_function *f, tlgen_quad_fn *quad, double preset, verdict *verdicts);

#endif
