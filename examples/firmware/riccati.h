/* The discrete algebraic Riccati equation of order D with one input, by a fixed number of doublings. */
#ifndef RICCATI_H
#define RICCATI_H

#include "plant.h"

enum { RICCATI_DOUBLINGS = 12 }; /* a horizon of 2^12 control steps, 4 s */

/* Workspace. */
typedef struct riccati {
  tl_real A[D * D], At[D * D], G[D * D], H[D * D], W[D * D], V[D * 2 * D], V1[D * D], V2[D * D], P[D * D];
} riccati;

/* The gain K (D numbers) that makes push = -K y least costly for y+ = A y + B push and the cost sum of y' diag(weights) y + weight
 * push^2: K = B'X A / (weight + B'X B),     X = A'X (I + B B'X/weight)^-1 A + diag(weights). A: D x D, B and weights: D numbers. 0
 * where a matrix is singular or the gain is not finite, and then K is as it was; else 1. */
int riccati_gain(tl_real *K, const tl_real *A, const tl_real *B, const tl_real *weights, tl_real weight, riccati *work);

/* The same from a known X, D x D: the cost of all steps after this one. 0 where the gain is not finite, and then K is as it was. */
int riccati_gain_of(tl_real *K, const tl_real *X, const tl_real *A, const tl_real *B, tl_real weight);

#endif
