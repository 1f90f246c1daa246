/* LDL' of straight-line code (see ldl.h), for numbers of type TL_T: included once for each.
 *
 *     TL_T_NAME(name)        the name of a function or type for this type
 *     TL_T_OF(x)             the tl_real x
 *     TL_T_WHERE(c, a, b)    a where the comparison c of two of them holds, b elsewhere
 *     TL_T_UNROLL            before each loop
 *
 * All five are undefined at the end. */

/* The extreme values of M_ii/d_i and 1/d_i so far. */
typedef struct TL_T_NAME(tl_ldl_range) {
  TL_T largest, least;
} TL_T_NAME(tl_ldl_range);

/* A pivot's inverse and its entry of M. Where a pivot is no number, all that follow are none, and so is least at the end. */
TL_INLINE void TL_T_NAME(tl_ldl_extend)(TL_T_NAME(tl_ldl_range) * range, const TL_T *inverse, const TL_T *entry) {
  const TL_T quotient = *entry * *inverse;
  range->largest = TL_T_WHERE(range->largest > quotient, range->largest, quotient);
  range->least = TL_T_WHERE(range->least < *inverse, range->least, *inverse);
}

TL_INLINE TL_T TL_T_NAME(tl_ldl_ratio)(const TL_T_NAME(tl_ldl_range) * range) {
  return TL_T_WHERE(range->least > TL_C(0.0), range->largest, TL_T_OF((tl_real)HUGE_VAL));
}

/* M_ij - sum_k<count L_ik u_kj. Where it decides on a pivot the last product is (u_ki u_kj)/d_k, which waits less for 1/d_k. */
TL_INLINE TL_T TL_T_NAME(tl_ldl_left)(const TL_T *w, int ld, const TL_T *d, int i, int j, int count, int pivotal) {
  const int last = count - 1, plain = pivotal ? last : count;
  TL_T sum = w[i * ld + j];
  TL_T_UNROLL for (int k = 0; k < plain; k++) sum -= w[i * ld + k] * w[k * ld + j];
  if (pivotal && count > 0) sum -= w[last * ld + i] * w[last * ld + j] * d[last];
  return sum;
}

/* Rows i and i+1: u to the right of the diagonal, L below it. */
TL_INLINE void TL_T_NAME(tl_ldl_pair)(int n, TL_T *w, int ld, TL_T *d, int i, TL_T_NAME(tl_ldl_range) * range) {
  TL_T *upper = w + i * ld, *lower = upper + ld;
  const TL_T first = upper[i], second = lower[i + 1];
  const TL_T a = TL_T_NAME(tl_ldl_left)(w, ld, d, i, i, i, 1), b = TL_T_NAME(tl_ldl_left)(w, ld, d, i, i + 1, i, 1);
  const TL_T c = TL_T_NAME(tl_ldl_left)(w, ld, d, i + 1, i + 1, i, 1);
  d[i] = TL_C(1.0) / a;
  d[i + 1] = a * (TL_C(1.0) / (a * c - b * b));
  TL_T_NAME(tl_ldl_extend)(range, &d[i], &first);
  TL_T_NAME(tl_ldl_extend)(range, &d[i + 1], &second);
  const TL_T l = b * d[i];
  lower[i] = l;
  TL_T_UNROLL for (int j = i + 2; j < n; j++) {
    upper[j] = TL_T_NAME(tl_ldl_left)(w, ld, d, i, j, i, 0);
    lower[j] = TL_T_NAME(tl_ldl_left)(w, ld, d, i + 1, j, i, 0) - l * upper[j];
    w[j * ld + i] = upper[j] * d[i];
    w[j * ld + i + 1] = lower[j] * d[i + 1];
  }
}

TL_INLINE TL_T TL_T_NAME(tl_ldl_factor_scalar)(int n, TL_T *w, int ld, TL_T *d) {
  TL_T_NAME(tl_ldl_range) range = {TL_T_OF(TL_C(0.0)), TL_T_OF(TL_MAX)};
  TL_T_UNROLL for (int i = 0; i + 1 < n; i += 2) TL_T_NAME(tl_ldl_pair)(n, w, ld, d, i, &range);
  if (n % 2 == 1) {
    const int i = n - 1;
    const TL_T entry = w[i * ld + i];
    d[i] = TL_C(1.0) / TL_T_NAME(tl_ldl_left)(w, ld, d, i, i, i, 1);
    TL_T_NAME(tl_ldl_extend)(&range, &d[i], &entry);
  }
  return TL_T_NAME(tl_ldl_ratio)(&range);
}

/* x = M^-1 x. */
TL_INLINE void TL_T_NAME(tl_ldl_solve_scalar)(int n, TL_T *x, const TL_T *w, int ld, const TL_T *d) {
  TL_T_UNROLL for (int k = 0; k < n; k++) TL_T_UNROLL for (int i = k + 1; i < n; i++) x[i] -= w[i * ld + k] * x[k];
  TL_T_UNROLL for (int i = 0; i < n; i++) x[i] *= d[i];
  TL_T_UNROLL for (int k = n - 1; k > 0; k--) TL_T_UNROLL for (int i = 0; i < k; i++) x[i] -= w[k * ld + i] * x[k];
}

#undef TL_T
#undef TL_T_NAME
#undef TL_T_OF
#undef TL_T_WHERE
#undef TL_T_UNROLL
