/* The factorisation of the equations M dq - A' dl = r1, A dq = r2, made once per state and used for any number of right-hand sides. */
#ifndef EOM_FACTOR_H
#define EOM_FACTOR_H

#include "workspace.h"

#define EOM_REFINEMENTS 10 /* passes, at most */

/* The rows of A that a factorisation takes, and how many of them are independent. */
typedef struct eom_selection {
  const int *row;    /* count of them; null: the first ones */
  int count;         /* the others get no multiplier */
  int rank;          /* at most so many are independent, */
  tl_real tolerance; /* those whose pivots are above this */
} eom_selection;

/* Factors sys->M and the rows; fills rank, pivot, condition and weighted of the report. NO_INERTIA. */
eom_status eom_factor_make(eom_system *sys, const eom_selection *rows);

/* Pivot j of the rows last factored: what row j in the order of exchange adds to those before it, in parts of its length. */
tl_real eom_factor_pivot(const eom_system *sys, int j);

/* How many of them have a pivot above the tolerance. */
int eom_factor_rank(const eom_system *sys, tl_real tolerance);

/* One pass through the factors; eom_kkt_solve refines it. dq: n, dl: m, r1: n, r2: m; outputs may not be inputs. */
void eom_factor_apply(eom_system *sys, tl_real *dq, tl_real *dl, const tl_real *r1, const tl_real *r2);

/* The solution with iterative refinement. Same arguments. */
void eom_kkt_solve(eom_system *sys, tl_real *dq, tl_real *dl, const tl_real *r1, const tl_real *r2);

#endif
