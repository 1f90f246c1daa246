/* The memory of a system as a constant expression, for programs without a heap:
 *
 *     static _Alignas(EOM_MOTION_ALIGNMENT) unsigned char memory[EOM_SYSTEM_BYTES(EOM_NEED_LINEARISE, CRANE_SIZES)];
 *     eom_system_init(&sys, &crane_model, NULL, &options, memory, sizeof memory);
 *
 * It is what eom_system_bytes returns, in a build without LAPACKE, for options.emitter = EOM_EMITTER_MOTION without weights and
 * Baumgarte's terms; EOM_SYSTEM_BYTES_MORE says what those take. tlgen --export defines a model's sizes (CRANE_SIZES). */
#ifndef EOM_BYTES_H
#define EOM_BYTES_H

#include "eom/system.h"

/* sizes, numbers: n, m1, m2, work and constant_mass as in eom_motion, and for the holonomic, the nonholonomic and all functions of the
 * model: the most rows and the largest frame of one of them, 0 where there is none. */
#define EOM_SYSTEM_BYTES(needs, ...) EOM_SYSTEM_BYTES_OF(needs, __VA_ARGS__)

/* Bytes on top, for options.weights and options.baumgarte together, of a system that linearises. */
#define EOM_SYSTEM_BYTES_MORE(n, m1, m2) (EOM_ROUNDED_REALS((m1) + (m2)) + EOM_ROUNDED_REALS(2 * (n)))

#define EOM_ROUNDED(bytes) (((bytes) + EOM_MOTION_ALIGNMENT - 1) / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT)
#define EOM_ROUNDED_REALS(count) EOM_ROUNDED((size_t)(count) * sizeof(tl_real))

/* An eom_workspace, at most: it is private. */
#define EOM_WORKSPACE_BYTES (126 * sizeof(void *) + 2 * sizeof(tl_real) + 320)

#define EOM_LANES 8 /* right-hand sides that are solved for together: one vector register of the widest kind */

/* Numbers of workspace for the dense linear algebra of a matrix of order n and m vectors of n: of LAPACK alone. */
#ifdef EOM_HAVE_LAPACKE
#define EOM_LINALG_WORK(n, m) (32 * ((n) + (m)) + 2 * (m) + (n) + 64)
#else
#define EOM_LINALG_WORK(n, m) (0 * ((n) + (m)))
#endif

/* Every array of a system: X(its pointer in the system or its workspace, type, numbers). linearise, solves, stabilised, weighted,
 * constant_mass: 1 where there is such, else 0; vectors: right-hand sides of a linearisation. */
#define EOM_SYSTEM_ARRAYS(X, n, m1, m2, linearise, solves, vectors, constant_mass, weighted, stabilised, work, njets, ncontext)        \
  EOM_PUBLIC_ARRAYS(X, n, m1, m2, (m1 + m2), linearise)                                                                                \
  X(ws->weights, tl_real, weighted *(m1 + m2))                                                                                         \
  EOM_FACTOR_ARRAYS(X, n, (m1 + m2), (n < m1 + m2 ? n : m1 + m2), constant_mass)                                                       \
  EOM_SOLVE_ARRAYS(X, n, (m1 + m2))                                                                                                    \
  EOM_MANY_ARRAYS(X, (solves * n), (solves * (m1 + m2)), vectors, stabilised)                                                          \
  X(ws->motion_work, tl_real, work)                                                                                                    \
  X(ws->jets, tl_real, njets)                                                                                                          \
  X(ws->context, tl_real, ncontext)

#define EOM_PUBLIC_ARRAYS(X, n, m1, m2, m, linearise)                                                                                  \
  X(sys->momentum, tl_real, n)                                                                                                         \
  X(sys->momentum_rate, tl_real, n)                                                                                                    \
  X(sys->M, tl_real, n *n)                                                                                                             \
  X(sys->Q, tl_real, n)                                                                                                                \
  X(sys->A, tl_real, m *n)                                                                                                             \
  X(sys->b, tl_real, m)                                                                                                                \
  X(sys->phi, tl_real, m1)                                                                                                             \
  X(sys->phi_dot, tl_real, m1)                                                                                                         \
  X(sys->psi, tl_real, m2)                                                                                                             \
  X(sys->qdd, tl_real, n)                                                                                                              \
  X(sys->lambda, tl_real, m)                                                                                                           \
  X(sys->Qc, tl_real, n)                                                                                                               \
  X(sys->row_kind, eom_row_kind, m)                                                                                                    \
  X(sys->qdd_y, tl_real, linearise * 2 * n * n)                                                                                        \
  X(sys->lambda_y, tl_real, linearise * 2 * m * n)

#define EOM_FACTOR_ARRAYS(X, n, m, least, constant_mass)                                                                               \
  X(ws->factor.L, tl_real, n *n)                                                                                                       \
  X(ws->factor.kept_M, tl_real, constant_mass *n *n)                                                                                   \
  X(ws->factor.S, tl_real, n)                                                                                                          \
  X(ws->factor.y, tl_real, n)                                                                                                          \
  X(ws->factor.W, tl_real, m)                                                                                                          \
  X(ws->factor.B, tl_real, m *n)                                                                                                       \
  X(ws->factor.D, tl_real, m)                                                                                                          \
  X(ws->factor.tau, tl_real, least)                                                                                                    \
  X(ws->factor.pivot, int, m)                                                                                                          \
  X(ws->factor.row, int, m)                                                                                                            \
  X(ws->factor.U, tl_real, least *m)                                                                                                   \
  X(ws->factor.tau_u, tl_real, least)                                                                                                  \
  X(ws->factor.v, tl_real, m)                                                                                                          \
  X(ws->factor.w, tl_real, m)                                                                                                          \
  X(ws->factor.work, tl_real, (m > 0 ? EOM_LINALG_WORK((n > m ? n : m), m) : 0))

#define EOM_SOLVE_ARRAYS(X, n, m)                                                                                                      \
  X(ws->held.row, int, m)                                                                                                              \
  X(ws->held.pivot, tl_real, m)                                                                                                        \
  X(ws->b_size, tl_real, m)                                                                                                            \
  X(ws->r1, tl_real, n)                                                                                                                \
  X(ws->r2, tl_real, m)                                                                                                                \
  X(ws->dq, tl_real, n)                                                                                                                \
  X(ws->dl, tl_real, m)                                                                                                                \
  X(ws->was, tl_real, 2 * n)                                                                                                           \
  X(ws->miss, tl_real, m)

#define EOM_MANY_ARRAYS(X, n, m, vectors, stabilised)                                                                                  \
  X(ws->rhs1, tl_real, vectors *n)                                                                                                     \
  X(ws->rhs2, tl_real, vectors *m)                                                                                                     \
  X(ws->sol1, tl_real, n)                                                                                                              \
  X(ws->sol2, tl_real, m)                                                                                                              \
  X(ws->lanes.R1, tl_real, n *EOM_LANES)                                                                                               \
  X(ws->lanes.R2, tl_real, m *EOM_LANES)                                                                                               \
  X(ws->lanes.dq, tl_real, n *EOM_LANES)                                                                                               \
  X(ws->lanes.dl, tl_real, m *EOM_LANES)                                                                                               \
  X(ws->lanes.r1, tl_real, n *EOM_LANES)                                                                                               \
  X(ws->lanes.r2, tl_real, m *EOM_LANES)                                                                                               \
  X(ws->lanes.change_q, tl_real, n *EOM_LANES)                                                                                         \
  X(ws->lanes.change_l, tl_real, m *EOM_LANES)                                                                                         \
  X(ws->lanes.v, tl_real, m *EOM_LANES)                                                                                                \
  X(ws->lanes.w, tl_real, m *EOM_LANES)                                                                                                \
  X(ws->pull, tl_real, stabilised * 2 * n)

/* What is left to calls where motion functions serve every need: {1,s,s2} x C(n,1) of the holonomic functions, {1} x C(n,1) of the
 * nonholonomic ones for derivatives, and {1,s,s2} of all. They share one array of 2n + 1 + rows jets and one for the context. */
#define EOM_STAGES(needs, m1, m2) (((m1) > 0) + EOM_BY_COORDINATES(needs, m2) + 1)
#define EOM_STAGE_NUMBERS(jets1, jets2, jets, needs, n, m1, m2)                                                                        \
  EOM_LARGER((jets) * 3, EOM_LARGER(((m1) > 0) * (jets1) * 3 * (1 + (n)), EOM_BY_COORDINATES(needs, m2) * (jets2) * (1 + (n))))
#define EOM_BY_COORDINATES(needs, m2) ((m2) > 0 && ((needs) & (EOM_NEED_LINEARISE | EOM_NEED_TANGENT)) != 0)
#define EOM_LINEARISES(needs) (((needs) & EOM_NEED_LINEARISE) != 0)
#define EOM_SOLVES(needs) (((needs) & (EOM_NEED_LINEARISE | EOM_NEED_TANGENT | EOM_NEED_PARAMETERS)) != 0)
#define EOM_LARGER(a, b) ((a) > (b) ? (a) : (b))

#define EOM_ARRAY_BYTES(place, type, count) +EOM_ROUNDED((size_t)(count) * sizeof(type))
#define EOM_SYSTEM_BYTES_OF(needs, n, m1, m2, work, constant_mass, rows1, frame1, rows2, frame2, rows, frame)                          \
  (EOM_MOTION_ALIGNMENT + EOM_ROUNDED(EOM_WORKSPACE_BYTES) +                                                                           \
   EOM_STAGES(needs, m1, m2) *                                                                                                         \
       EOM_ROUNDED(sizeof(tl_shape)) EOM_SYSTEM_ARRAYS(                                                                                \
           EOM_ARRAY_BYTES, n, m1, m2, EOM_LINEARISES(needs), EOM_SOLVES(needs), 1, constant_mass, 0, 0, work,                         \
           EOM_STAGE_NUMBERS(2 * (n) + 1 + (rows1), 2 * (n) + 1 + (rows2), 2 * (n) + 1 + (rows), needs, n, m1, m2),                    \
           EOM_STAGE_NUMBERS((frame1) + TL_NSCRATCH, (frame2) + TL_NSCRATCH, (frame) + TL_NSCRATCH, needs, n, m1, m2)))

#endif
