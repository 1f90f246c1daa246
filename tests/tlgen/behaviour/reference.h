/* Derivatives of a plain function by differences in quad precision: shares no code with the jets. */
#ifndef TEST_REFERENCE_H
#define TEST_REFERENCE_H

/* Values and partial derivatives up to order 3 with respect to x = (q, qd, t), for each of the function's rows.
 *   out       rows numbers: the partial derivative by x[index[0]], .., x[index[order-1]]
 *   function  number of the function, as in plain.h
 *   x         2n+1 numbers: q, qd, t */
void reference_derivative(double *out, int rows, int function, int n, const double *x, int order, const int *index);

#endif
