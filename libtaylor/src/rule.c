/* Functions with a rule of the user's, and the composition with a series in several variables. */
#include "taylor/rule.h"
#include "block.h"

void tl_apply(tl_ctx *cx, tl_real *c, const tl_real *a, tl_rule *rule, const void *user) {
  tl_real f[TL_MAX_CURVE + TL_MAX_ORDER + 1];
  const unsigned bits = rule(f, a[0], cx->shape->degree, user);
  if (bits != TL_OK)
    tl_reject(cx, c, bits, TL_FN_compose);
  else
    tl_compose(cx, c, a, f);
}

/* binomial(nargs + degree, nargs) by the partial products binomial(degree + i, i). */
int tl_rule_size(int nargs, int degree) {
  int n = 1;
  assert(nargs >= 0 && nargs <= TL_RULE_ARGS && degree >= -1);
  for (int i = 1; i <= nargs; i++) n = n * (degree + i) / i;
  return n;
}

/* Before x_1^e_1 .. x_n^e_n stand all monomials of lower degree, and those of the same degree with a higher power of x_1, which are as
 * many as there are monomials in x_2..x_n of degree below e_2 + .. + e_n; and so on without x_1. */
int tl_rule_index(int nargs, const int *alpha) {
  int degree = 0, place = 0;
  assert(nargs >= 1 && nargs <= TL_RULE_ARGS);
  for (int i = nargs - 1; i >= 0; i--) {
    degree += alpha[i];
    place += tl_rule_size(nargs - i, degree - 1);
  }
  return place;
}

/* The polynomial in the jets h_i = args_i - args_i(0) whose coefficients f holds, by Horner's scheme in the last of them, whose
 * coefficients are polynomials in those before, of which it is the same. Scratch jet i = such a part, for the exponents of the
 * arguments above i as they stand, their powers left out. Only blocks of weight at most degree - used can reach the result, used being
 * the sum of those exponents. */
void tl_compose_n_blocks(tl_ctx *cx, tl_real *c, int nargs, const tl_real *const *args, const tl_real *f) {
  const tl_shape *s = cx->shape;
  int exponent[TL_RULE_ARGS], used[TL_RULE_ARGS];
  int i = nargs - 1;
  used[i] = 0;
  exponent[i] = s->degree;
  tl_row_zero(s->ncoef, tl_scratch(cx, i));
  while (i < nargs) {
    tl_real *part = tl_scratch(cx, i);
    if (exponent[i] >= 0 && i > 0) { /* a coefficient of this part comes first */
      used[i - 1] = used[i] + exponent[i];
      exponent[i - 1] = s->degree - used[i - 1];
      tl_row_zero(s->ncoef, tl_scratch(cx, --i));
    } else if (exponent[i] >= 0) {
      tl_horner_step(s, part, args[0], f[tl_rule_index(nargs, exponent)], s->degree - used[0] - exponent[0]);
      exponent[0]--;
    } else if (++i < nargs) { /* it is there */
      tl_real *of = tl_scratch(cx, i);
      tl_horner_step(s, of, args[i], part[0], s->degree - used[i] - exponent[i]);
      for (int k = 1; k < s->ncoef; k++) of[k] += part[k];
      exponent[i]--;
    }
  }
  const tl_real *sum = tl_scratch(cx, nargs - 1);
  for (int k = 0; k < s->ncoef; k++) c[k] = sum[k];
}

void tl_apply_n(tl_ctx *cx, tl_real *c, int nargs, const tl_real *const *args, tl_rule_n *rule, const void *user) {
  tl_real f[TL_RULE_MAX], x[TL_RULE_ARGS];
  const int degree = cx->shape->degree;
  assert(nargs >= 1 && nargs <= TL_RULE_ARGS);
  for (int i = 0; i < nargs; i++) {
    x[i] = args[i][0];
    if (!tl_accept(cx, c, x[i], TL_FN_compose)) return;
  }
  const int n = tl_rule_size(nargs, degree);
  if (n > TL_RULE_MAX) {
    tl_reject(cx, c, TL_NO_SPACE, TL_FN_compose);
    return;
  }
  for (int i = 0; i < n; i++) f[i] = TL_FROM(NAN);
  const unsigned bits = rule(f, x, degree, user);
  if (bits != TL_OK) {
    tl_reject(cx, c, bits, TL_FN_compose);
    return;
  }
  tl_compose_n_blocks(cx, c, nargs, args, f);
  tl_check(cx, c, TL_FN_compose);
}
