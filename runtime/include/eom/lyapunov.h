/* The full spectrum of Lyapunov exponents of y = (q,qd) along a motion (eqs 72-81).
 *
 * All schemes integrate trajectory and tangents together in steps of fixed length. rho_i is the logarithm of the growth of the
 * i-th orthogonal direction; the running exponents are lambda_i = rho_i/(t - t0), 1/s. */
#ifndef EOM_LYAPUNOV_H
#define EOM_LYAPUNOV_H

#include "eom/integrate.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum eom_lyapunov_scheme {
  EOM_LYAPUNOV_DISCRETE,   /* tangent map P' = F P, Householder QR of P every few steps, rho_i += log R_ii; the default */
  EOM_LYAPUNOV_CONTINUOUS, /* Q' = Q S, rho_i' = (Q'FQ)_ii, Q re-orthonormalised by Householder QR after each step */
  EOM_LYAPUNOV_PAPER       /* eqs 75-80 as printed: the same and Q never re-orthonormalised */
} eom_lyapunov_scheme;

typedef struct eom_lyapunov_options {
  eom_lyapunov_scheme scheme; /* default EOM_LYAPUNOV_DISCRETE */
  int every;                  /* DISCRETE: steps from one QR to the next, >= 1; default 1 */
  const eom_method *method;   /* null, the default: eom_dp5 */
} eom_lyapunov_options;

eom_lyapunov_options eom_lyapunov_options_default(void);

#define EOM_LYAPUNOV_BLOCKS 64 /* most blocks of time kept for intervals; when all are full, neighbours are merged */

typedef struct eom_lyapunov {
  eom_system *sys;
  eom_lyapunov_options options;
  eom_integrator it; /* of (y, P, divergence) for DISCRETE, of (y, Q, rho, divergence) otherwise */
  int dim;           /* 2n */

  tl_real t0;              /* s */
  tl_real t;               /* s: time of y and energy */
  tl_real t_rho;           /* s: time of Q, rho and divergence; behind t only for DISCRETE with every > 1 */
  const tl_real *y;        /* 2n: q, qd */
  tl_real *Q;              /* 2n x 2n: the directions, in columns */
  tl_real *rho;            /* 2n */
  tl_real divergence;      /* integral of trace F from t0: what the rho must sum to */
  tl_real energy0, energy; /* at t0 and t, J */

  /* blocks of equal time for the intervals */
  int nblock;           /* full blocks */
  long block_steps;     /* steps per block */
  long block_fill;      /* steps in the block under way */
  tl_real *block;       /* EOM_LYAPUNOV_BLOCKS x 2n: rho gained in each block */
  tl_real *block_start; /* 2n: rho at the start of the block under way */

  struct eom_lyapunov_work *work; /* private */
} eom_lyapunov;

/* Bytes of memory that eom_lyapunov_init needs. */
size_t eom_lyapunov_bytes(const eom_system *sys, const eom_lyapunov_options *options);

/* Starts at (t, y), y: 2n, with step h, Q = I, rho = 0. sys must have EOM_NEED_LINEARISE and serve nothing else in the meantime.
 * options null for the defaults. BAD_OPTION, NO_MEMORY, errors of eom_energy. */
eom_status eom_lyapunov_init(eom_lyapunov *ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                             tl_real h, void *memory, size_t bytes);

/* The same with memory from malloc. *ly is null unless EOM_OK. Destroy takes null. */
eom_status eom_lyapunov_create(eom_lyapunov **ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                               tl_real h);
void eom_lyapunov_destroy(eom_lyapunov *ly);

/* One step. At a failure everything is as before the step: errors of eom_linearise (see sys->report); NOT_FINITE where the state
 * overflowed, as it will with EOM_LYAPUNOV_PAPER. */
eom_status eom_lyapunov_step(eom_lyapunov *ly);

/* lambda_i = rho_i/(t_rho - t0) in the order of the directions; not sorted. lambda: 2n; zeros at t0. */
void eom_lyapunov_exponents(const eom_lyapunov *ly, tl_real *lambda);

/* Checks: max |Q'Q - I|; |sum rho - divergence|/(t_rho - t0), 1/s, 0 at t0; max |lambda_i + lambda_(2n+1-i)| of the sorted spectrum,
 * 1/s, which falls to zero with time for a conservative system without constraints. TL_MAX stands for an overflow. */
tl_real eom_lyapunov_orthogonality(const eom_lyapunov *ly);
tl_real eom_lyapunov_sum_error(const eom_lyapunov *ly);
tl_real eom_lyapunov_pairing_error(const eom_lyapunov *ly);

/* The mean of lambda_i with its 95 % half-width from the block means: blocks are merged until neighbours no longer correlate (but to
 * not fewer than 8), then Student's t on the rest. Returns the number of blocks used; below 8 there is no interval, half_width is
 * TL_MAX and 0 is returned. */
int eom_lyapunov_interval(const eom_lyapunov *ly, int i, tl_real *mean, tl_real *half_width);

#ifdef __cplusplus
}
#endif

#endif
