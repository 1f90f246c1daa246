/* Explicit Runge-Kutta methods for y' = f(t,y) as tables of numbers, by name. */
#ifndef EOM_METHOD_H
#define EOM_METHOD_H

#include "eom/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A method of s stages, and what estimates its error and interpolates its steps. With the slopes
 *
 *     k_i = f(t + c_i h, y + h sum_(j<i) a_ij k_j),    i = 0, 1, ..
 *
 * the step from y ends at y1 = y + h sum_(j<s) a_sj k_j: row s of a holds what books call b, and k_s = f(t + h, y1) is slope 0 of the
 * next step. Slopes behind k_s are for dense output only. */
typedef struct eom_method {
  const char *name;
  int order;        /* p: one step is wrong by O(h^(p+1)) */
  int stages;       /* s: evaluations of f per step */
  int error_rows;   /* 1: error = h sum_(j<=s) e_j k_j; 2: that of both rows together, |error_0|^2 / sqrt(|error_0|^2 + |error_1|^2/100)
                     */
  int error_power;  /* the error estimate is O(h^error_power) */
  int dense_order;  /* r: the interpolation of one step is wrong by O(h^(r+1)) */
  int dense_stages; /* evaluations it takes where it is used */
  int dense_rows;   /* of dense; slopes 1..dense_rows have no weight in it and give it their place */
  const tl_real *c; /* s + 1 + dense_stages */
  const tl_real *a; /* strict lower triangle row by row: a_ij is a[i*(i-1)/2 + j]; s + 1 + dense_stages rows, row 0 empty */
  const tl_real *error; /* error_rows x (s + 1) */
  const tl_real *dense; /* dense_rows x (s + 1 + dense_stages): see eom_integrator_at */
} eom_method;

extern const eom_method eom_rk4;    /* "rk4": the classical method; error estimate of order 3, cubic interpolation */
extern const eom_method eom_dp5;    /* "dp5": Dormand and Prince 5(4), interpolation of order 4 */
extern const eom_method eom_dop853; /* "dop853": Dormand and Prince 8(5,3) of Hairer, Norsett and Wanner, interpolation of order 7 */

/* The method of that name, or null. */
const eom_method *eom_method_find(const char *name);

#ifdef __cplusplus
}
#endif

#endif
