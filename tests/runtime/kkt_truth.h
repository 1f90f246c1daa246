/* Linear equations in quadruple precision, for truth. */
#ifndef TEST_KKT_TRUTH_H
#define TEST_KKT_TRUTH_H

typedef __float128 quad;

/* x = K^-1 x for k right-hand sides, in place, by Gauss-Jordan elimination with row exchange. K: n x n, destroyed; x: n x k. */
void gauss(int n, quad *K, int k, quad *x);

/* (qdd, lambda) of M qdd - A' lambda = Q, A qdd = b; x: n + m. */
void kkt_truth(int n, int m, const double *M, const double *A, const double *Q, const double *b, double *x);

#endif
