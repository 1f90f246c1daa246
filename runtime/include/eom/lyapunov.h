/* Lyapunov exponents of y = (q,qd) along a motion (eqs 72-81): all of them or the first k, with intervals, checks and checkpoints.
 *
 * k tangents, the columns of X (2n x k), follow the motion, X' = F X. Before they are alike they are made orthonormal again, X = Q R,
 * and rho_i += log R_ii: the logarithm of the growth of the i-th orthogonal direction. lambda_i = rho_i/(t - t0), 1/s.
 *
 * On constraints there are d = 2(n - m1) - m2 exponents, for m1 holonomic and m2 nonholonomic rows that are independent; without any
 * d = 2n. States are then projected onto the constraints after each step (eom/project.h), tangents onto the motions that they allow at
 * each QR: C x = 0 with C = d(phi, phi_dot, psi)/dy.
 *
 * Time is divided by marks, t0 + j interval. A run goes from mark to mark; everything that is read from it is that of the last mark. */
#ifndef EOM_LYAPUNOV_H
#define EOM_LYAPUNOV_H

#include "eom/integrate.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum eom_lyapunov_scheme {
  EOM_LYAPUNOV_DISCRETE,   /* X' = F X, Householder QR at each mark and wherever growth asks for it; the default */
  EOM_LYAPUNOV_CONTINUOUS, /* Q' = F Q - Q T, T upper triangular, rho_i' = (Q'FQ)_ii; Q made orthonormal again after each step */
  EOM_LYAPUNOV_PAPER       /* eqs 75-80 as printed, Q' = Q S, and Q never made orthonormal again; all exponents, no constraints */
} eom_lyapunov_scheme;

/* How F X is computed. */
typedef enum eom_lyapunov_product {
  EOM_LYAPUNOV_BY_COST,      /* the Jacobian for all exponents, else what costs less of what the system was asked for; the default */
  EOM_LYAPUNOV_BY_JACOBIAN,  /* d qdd/dy, then the product: EOM_NEED_LINEARISE */
  EOM_LYAPUNOV_BY_DIRECTIONS /* k directional derivatives, d qdd/dy is never formed: EOM_NEED_TANGENT. Leaves the divergence unknown */
} eom_lyapunov_product;

typedef struct eom_lyapunov_options {
  eom_lyapunov_scheme scheme;
  eom_lyapunov_product product;
  int k;                     /* the first k exponents, 0: all d */
  const eom_method *method;  /* null: eom_dop853 */
  int taylor;                /* 1: the motion by Taylor series, where eom_taylor_init takes sys; method is that of the tangents alone */
  tl_real interval;          /* s, from mark to mark; negative: backwards in time */
  tl_real h;                 /* s: fixed steps, of at most this length, that divide the interval; 0: steps are chosen by */
  eom_step_control control;  /* what y, 2n numbers, may be wrong by, */
  tl_real tangent_tolerance; /* and the tangents, in parts of 1 + |X_ij|; infinite: whatever they are */
  const tl_real *start;    /* 2n x k: the first directions, made orthonormal; to live until the start only. Null: of all d, unit vectors
                              where    there are no constraints, else a basis of the motions that they allow; of fewer, some that lie
                              across    all of    these, since what begins in a part of them that the motion keeps to never leaves it */
  int stop_exponent;       /* eom_lyapunov_settled: of which exponent, from 0, */
  tl_real stop_half_width; /* 1/s: the half-width at which it is known well enough; 0: never */
  tl_real stop_after;      /* s: and not before that much time */
} eom_lyapunov_options;

/* Discrete, chosen steps: rtol = atol = 1e-10 for y, 1e-6 for tangents. Without an interval: that is to be given. */
eom_lyapunov_options eom_lyapunov_options_default(void);

#define EOM_LYAPUNOV_BLOCKS 64 /* most blocks of time kept for intervals; when all are full, neighbours are merged */

typedef struct eom_lyapunov {
  eom_system *sys;
  eom_lyapunov_options options; /* as they hold: method, product and k chosen, h shortened */
  eom_integrator it;            /* of (y, X, rho, divergence); of y alone where chosen steps of y are so many that it pays */
  eom_integrator tangents;      /* to take steps of (X, rho, divergence) apart from them, along the interpolated motion */
  int d, k;                     /* exponents that there are, and that are computed */

  tl_real t0, t; /* s: of the start, of the last mark */
  long marks;    /* until t */
  long qrs;      /* since the start */

  const tl_real *y;        /* 2n: q, qd */
  const tl_real *Q;        /* 2n x k: the directions, in columns */
  tl_real *rho;            /* k */
  tl_real divergence;      /* what all d rho must sum to: the integral of trace F from t0 less what constraints take off; see checks */
  tl_real energy0, energy; /* at t0 and t, J */
  tl_real energy_error;    /* the largest |E - E0| at a mark, J */

  /* blocks of equal time for the intervals */
  int nblock;           /* full blocks */
  long block_marks;     /* marks per block */
  long block_fill;      /* marks in the block under way */
  tl_real *block;       /* EOM_LYAPUNOV_BLOCKS x k: rho gained in each block */
  tl_real *block_start; /* k: rho at the start of the block under way */

  struct eom_lyapunov_work *work; /* private */
} eom_lyapunov;

/* ---- start and end ---- */

/* Bytes of memory that eom_lyapunov_init needs; 0 where an option is outside its range. */
size_t eom_lyapunov_bytes(const eom_system *sys, const eom_lyapunov_options *options);

/* Starts at (t, y), y: 2n, which must satisfy the constraints (eom_project). sys serves nothing else until the run's end. BAD_OPTION,
 * also where sys lacks a need or k is more than d; NO_MEMORY; OFF_CONSTRAINTS; NOT_FINITE where the start directions are dependent;
 * errors of eom_energy and eom_acceleration. */
eom_status eom_lyapunov_init(eom_lyapunov *ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                             void *memory, size_t bytes);

/* The same with memory from malloc. *ly is null unless EOM_OK. Destroy takes null. */
eom_status eom_lyapunov_create(eom_lyapunov **ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y);
void eom_lyapunov_destroy(eom_lyapunov *ly);

/* ---- a run ---- */

/* On to the next mark. At a failure everything is as at the last one: errors of eom_linearise, eom_tangent and eom_project (see
 * sys->report); of eom_integrate; NOT_FINITE where a number overflowed, as it will with EOM_LYAPUNOV_PAPER; RANK_FELL where constraints
 * that were independent at the start no longer are. */
eom_status eom_lyapunov_step(eom_lyapunov *ly);

/* Called at each mark; any other number than 0 ends with EOM_STOPPED. */
typedef int eom_lyapunov_observe_fn(void *observer, const eom_lyapunov *ly);

/* Mark by mark until the first one at or behind t_end, or until the run has settled. observe may be null. BAD_OPTION where the interval
 * leads away from t_end. */
eom_status eom_lyapunov_to(eom_lyapunov *ly, tl_real t_end, eom_lyapunov_observe_fn *observe, void *observer);

/* ---- what is read from it ---- */

/* lambda_i in the order of the directions; not sorted. lambda: k; zeros at t0. */
void eom_lyapunov_exponents(const eom_lyapunov *ly, tl_real *lambda);

/* The mean of lambda_i over all full blocks with its half-width, at least 95 % by what the run itself shows: the variance of the mean
 * is summed up from the autocovariances of the block means (Geyer's initial monotone sequence), and Student's t of as many degrees of
 * freedom as these leave. It assumes that the growth is stationary and that the run has seen all of its motion many times: correlations
 * that are longer than a fair part of the run, as where a motion sticks to an island of order, leave no trace in one run, and the
 * interval is too narrow then (bench/lyapunov/run --coverage counts it). Returns the number of blocks; below 8 there is no interval,
 * half_width is TL_MAX and 0 is returned. */
int eom_lyapunov_interval(const eom_lyapunov *ly, int i, tl_real *mean, tl_real *half_width);

/* 1 where the half-width of options.stop_exponent is at most stop_half_width, not before stop_after; else 0. */
int eom_lyapunov_settled(const eom_lyapunov *ly);

/* What tells whether the numbers can be trusted. TL_MAX stands for an overflow, -1 for what is not known. */
typedef struct eom_lyapunov_checks {
  tl_real orthogonality; /* max |Q'Q - I| */
  tl_real sum;           /* of lambda_i, 1/s */
  tl_real divergence;    /* mean divergence of the motion, 1/s; 0 where it is not known */
  tl_real sum_error;     /* their difference, rounding and the tangents' error; -1 unless k = d and by the Jacobian */
  tl_real pairing_error; /* max |lambda_i + lambda_(d+1-i)| of the sorted spectrum, 1/s, which falls to zero with time where energy is
                            conserved and no constraint is nonholonomic; -1 unless k = d */
  tl_real zero[2];       /* the least two |lambda_i|, 1/s: the first tends to zero in any motion that does not come to rest and whose
                            equations do not contain t, both where energy is conserved too; -1 unless k = d */
  tl_real energy_error;  /* the largest |E - E0| at a mark, J */
} eom_lyapunov_checks;

void eom_lyapunov_check(const eom_lyapunov *ly, eom_lyapunov_checks *checks);

/* ---- checkpoints ---- */

/* A run as bytes that mean the same on any machine: written at any mark, read by a run that was started with the same model, parameters
 * and options (at whatever state), which then goes on to the same bits. */
size_t eom_lyapunov_image_bytes(const eom_lyapunov *ly);
void eom_lyapunov_save(const eom_lyapunov *ly, void *image);

/* BAD_CHECKPOINT where the bytes are no such image, of another version, cut short or changed; OTHER_CHECKPOINT where they are of
 * another model, size, number type or options, or this program computes other bits at the state; then *ly is as before. */
eom_status eom_lyapunov_restore(eom_lyapunov *ly, const void *image, size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
