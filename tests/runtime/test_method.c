/* The methods' tables against the order conditions of Runge-Kutta methods, one for each rooted tree. */
#include "close.h"

#include "eom/method.h"

#include <string.h>

/* J. C. Butcher: a step from y is exact to order p where sum_i b_i Phi_i(tree) = 1/gamma(tree) for every rooted tree of at most p
 * nodes. A tree is the product of those at its root's branches: Phi_i = prod over branches of (sum_j a_ij Phi_j(branch)), gamma = nodes
 * times the product of the branches' gamma. */
enum { MOST_NODES = 8, MOST_TREES = 200, MOST_SLOPES = 16 };

typedef struct tree {
  int nodes;
  tl_real gamma;
  tl_real phi[MOST_SLOPES];
  tl_real branch[MOST_SLOPES]; /* sum_j a_ij phi_j: its factor where it is a branch */
} tree;

typedef struct forest {
  const eom_method *method;
  int slopes, count;
  tree of[MOST_TREES];
} forest;

static void add_tree(forest *f, tree t) {
  assert_true(f->count < MOST_TREES);
  for (int i = 0; i < f->slopes; i++) {
    t.branch[i] = 0;
    for (int j = 0; j < i; j++) t.branch[i] += f->method->a[i * (i - 1) / 2 + j] * t.phi[j];
  }
  f->of[f->count++] = t;
}

/* All trees of so many nodes whose root has the branches of root and more, up to tree number `last`. */
static void grow(forest *f, tree root, int missing, int last) {
  if (missing == 0) {
    root.gamma *= (tl_real)root.nodes;
    add_tree(f, root);
    return;
  }
  for (int k = 0; k <= last; k++) {
    const tree *branch = &f->of[k];
    if (branch->nodes > missing) continue;
    tree more = root;
    more.gamma *= branch->gamma;
    for (int i = 0; i < f->slopes; i++) more.phi[i] *= branch->branch[i];
    grow(f, more, missing - branch->nodes, k);
  }
}

/* The trees of up to MOST_NODES nodes: 1, 1, 2, 4, 9, 20, 48, 115 of them. */
static void plant(forest *f, const eom_method *method) {
  memset(f, 0, sizeof *f);
  f->method = method;
  f->slopes = method->stages + 1 + method->dense_stages;
  for (int nodes = 1; nodes <= MOST_NODES; nodes++) {
    tree root = {.nodes = nodes, .gamma = 1};
    for (int i = 0; i < f->slopes; i++) root.phi[i] = 1;
    grow(f, root, nodes - 1, f->count - 1);
  }
  assert_int_equal(f->count, MOST_TREES);
}

/* The largest error of the conditions for a step of theta h with weights w, over the trees of so many nodes. */
static double worst_condition(const forest *f, int nodes, const tl_real *w, int count, tl_real theta) {
  tl_real worst = 0;
  for (int k = 0; k < f->count; k++) {
    const tree *t = &f->of[k];
    if (t->nodes != nodes) continue;
    tl_real miss = -1 / t->gamma;
    for (int n = 0; n < nodes; n++) miss *= theta;
    for (int i = 0; i < count; i++) miss += w[i] * t->phi[i];
    worst = TL_LIBM(fmax)(worst, TL_LIBM(fabs)(miss));
  }
  return (double)worst;
}

/* Rounding of table and sums: the digits of dop853's table end behind the thirtieth, and its largest weight is near 600. */
static double rounding(void) { return 1e4 * (double)TL_EPSILON > 1e-26 ? 1e4 * (double)TL_EPSILON : 1e-26; }

/* Holds to order p, and not beyond. */
static void check_order(const forest *f, int p, const tl_real *w, int count, tl_real theta, const char *what) {
  for (int nodes = 1; nodes <= p; nodes++) {
    const double worst = worst_condition(f, nodes, w, count, theta);
    if (!(worst <= rounding())) fail_msg("%s of %s: condition of order %d missed by %.1e", what, f->method->name, nodes, worst);
  }
  if (p < MOST_NODES) assert_true(worst_condition(f, p + 1, w, count, theta) > 1e-6);
}

static const char *const names[] = {"rk4", "dp5", "dop853"};
enum { NAMES = sizeof names / sizeof names[0] };

static void steps_have_their_order(void **state) {
  (void)state;
  static forest f;
  for (int k = 0; k < NAMES; k++) {
    const eom_method *m = eom_method_find(names[k]);
    assert_non_null(m);
    assert_string_equal(m->name, names[k]);
    plant(&f, m);
    check_order(&f, m->order, m->a + m->stages * (m->stages - 1) / 2, m->stages, 1, "step");
  }
  assert_null(eom_method_find("dp6"));
}

/* The step less its error estimate is a step of lower order. */
static void estimates_have_their_order(void **state) {
  (void)state;
  static const struct {
    const char *name;
    int order[2];
  } of[NAMES] = {{"rk4", {3}}, {"dp5", {4}}, {"dop853", {5, 3}}};
  static forest f;
  for (int k = 0; k < NAMES; k++) {
    const eom_method *m = eom_method_find(of[k].name);
    plant(&f, m);
    for (int row = 0; row < m->error_rows; row++) {
      tl_real w[MOST_SLOPES];
      const tl_real *b = m->a + m->stages * (m->stages - 1) / 2, *e = m->error + row * (m->stages + 1);
      for (int i = 0; i <= m->stages; i++) w[i] = (i < m->stages ? b[i] : 0) - e[i];
      check_order(&f, of[k].order[row], w, m->stages + 1, 1, "estimate");
    }
  }
}

/* The weights of the slopes in the interpolation at theta, by the formula that stands in dense.c, applied to each slope alone. */
static void dense_weights(const eom_method *m, tl_real theta, tl_real *w) {
  const int s = m->stages, count = s + 1 + m->dense_stages;
  const tl_real *b = m->a + s * (s - 1) / 2, rest = 1 - theta;
  for (int i = 0; i < count; i++) {
    const tl_real k0 = i == 0, ks = i == s, change = i < s ? b[i] : 0;
    tl_real d[4] = {0};
    for (int row = 0; row < m->dense_rows; row++) d[row] = m->dense[row * count + i];
    const tl_real inner = d[0] + theta * (d[1] + rest * (d[2] + theta * d[3]));
    w[i] = theta * (change + rest * (k0 - change + theta * (2 * change - k0 - ks + rest * inner)));
  }
}

/* Inside the step to the order of the interpolation; the slopes that make room for it have no weight. */
static void interpolations_have_their_order(void **state) {
  (void)state;
  static forest f;
  for (int k = 0; k < NAMES; k++) {
    const eom_method *m = eom_method_find(names[k]);
    const int count = m->stages + 1 + m->dense_stages;
    plant(&f, m);
    for (int part = 1; part < 8; part++) {
      tl_real w[MOST_SLOPES];
      dense_weights(m, (tl_real)part / 8, w);
      check_order(&f, m->dense_order, w, count, (tl_real)part / 8, "interpolation");
    }
    for (int slot = 1; slot <= m->dense_rows; slot++) {
      for (int row = 0; row < m->dense_rows; row++) assert_same((double)m->dense[row * count + slot], 0);
      for (int i = m->stages + 1; i < count; i++) assert_same((double)m->a[i * (i - 1) / 2 + slot], 0);
    }
  }
}

/* Row sums of a are c; the slope at a step's end is at its end. */
static void rows_sum_to_c(void **state) {
  (void)state;
  for (int k = 0; k < NAMES; k++) {
    const eom_method *m = eom_method_find(names[k]);
    for (int i = 0; i < m->stages + 1 + m->dense_stages; i++) {
      tl_real sum = -m->c[i];
      for (int j = 0; j < i; j++) sum += m->a[i * (i - 1) / 2 + j];
      assert_close((double)sum, 0, 0, rounding());
    }
    assert_same((double)m->c[m->stages], 1);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(steps_have_their_order), cmocka_unit_test(estimates_have_their_order),
                                     cmocka_unit_test(interpolations_have_their_order), cmocka_unit_test(rows_sum_to_c)};
  return cmocka_run_group_tests_name("method", tests, NULL, NULL);
}
