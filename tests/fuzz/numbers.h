/* The numbers of one evaluation of a model, in groups that every way of computing them has in common. */
#ifndef FUZZ_NUMBERS_H
#define FUZZ_NUMBERS_H

/* Every group: its name, rows and columns, in terms of n, m1, m2, m = m1 + m2, k directions and np parameters. */
#define FUZZ_GROUPS(X)                                                                                                                 \
  X(LAGRANGIAN, "L", 1, 1)                                                                                                             \
  X(MOMENTUM, "momentum", n, 1)                                                                                                        \
  X(ENERGY, "energy", 1, 1)                                                                                                            \
  X(RATE, "momentum_rate", n, 1)                                                                                                       \
  X(MASS, "M", n, n)                                                                                                                   \
  X(FORCE, "Q", n, 1)                                                                                                                  \
  X(PHI, "phi", m1, 1)                                                                                                                 \
  X(PHI_DOT, "phi_dot", m1, 1)                                                                                                         \
  X(PSI, "psi", m2, 1)                                                                                                                 \
  X(CONSTRAINT, "A", m, n)                                                                                                             \
  X(B, "b", m, 1)                                                                                                                      \
  X(RESIDUAL, "r", n, 1)  /* M qdd - Q at the accelerations in point.trial */                                                          \
  X(R_Y, "r_y", n, 2 * n) /* d(M qdd - Q - A'lambda)/d(q,qd) at point.qdd, point.lambda */                                             \
  X(G_Y, "g_y", m, 2 * n) /* d(A qdd - b)/d(q,qd) */                                                                                   \
  X(R_W, "r_w", n, k)     /* r_y w */                                                                                                  \
  X(G_W, "g_w", m, k)     /* g_y w */                                                                                                  \
  X(R_P, "r_p", n, np)    /* d(M qdd - Q - A'lambda)/dp */                                                                             \
  X(G_P, "g_p", m, np)    /* d(A qdd - b)/dp */                                                                                        \
  X(QDD, "qdd", n, 1)     /* solved */                                                                                                 \
  X(QDD_J, "qdd_j", n, 1) /* the same, as it comes with qdd_y */                                                                       \
  X(QDD_V, "qdd_v", n, 1) /* the same, as it comes with qdd_w */                                                                       \
  X(LAMBDA, "lambda", m, 1)                                                                                                            \
  X(QDD_Y, "qdd_y", n, 2 * n) /* d qdd/d(q,qd) */                                                                                      \
  X(LAMBDA_Y, "lambda_y", m, 2 * n)                                                                                                    \
  X(QDD_W, "qdd_w", n, k) /* qdd_y w */                                                                                                \
  X(LAMBDA_W, "lambda_w", m, k)                                                                                                        \
  X(QDD_P, "qdd_p", n, np) /* d qdd/dp */                                                                                              \
  X(LAMBDA_P, "lambda_p", m, np)

typedef enum fuzz_group {
#define FUZZ_X(id, name, rows, columns) FUZZ_##id,
  FUZZ_GROUPS(FUZZ_X)
#undef FUZZ_X
      FUZZ_GROUP_COUNT
} fuzz_group;

enum { FUZZ_MAX_PARAMETERS = 16 };

typedef struct fuzz_sizes {
  int n, m1, m2, m; /* coordinates; holonomic, nonholonomic and all constraint rows */
  int k;            /* directions */
  int np;           /* parameters by which a derivative is wanted, at most FUZZ_MAX_PARAMETERS */
} fuzz_sizes;

/* The numbers of each group, row by row; null where it is absent: this evaluation has none. */
typedef struct fuzz_numbers {
  fuzz_sizes sizes;
  double *group[FUZZ_GROUP_COUNT];
  double *memory;
} fuzz_numbers;

const char *fuzz_group_name(int group);
int fuzz_group_rows(const fuzz_sizes *s, int group);
int fuzz_group_columns(const fuzz_sizes *s, int group);

/* Makes every group present, full of NaN. Ends the program where there is no memory. */
void fuzz_numbers_start(fuzz_numbers *numbers, fuzz_sizes sizes);
void fuzz_numbers_free(fuzz_numbers *numbers);

/* Makes absent every group from the first up to, not with, the last. */
void fuzz_make_absent(fuzz_numbers *numbers, int first, int last);

/* The group's count of numbers, and the largest of them. */
int fuzz_group_size(const fuzz_sizes *s, int group);
double fuzz_group_largest(const fuzz_numbers *numbers, int group);

/* A state with all that the evaluations take besides. */
typedef struct fuzz_point {
  double *x;      /* 2n+1: q, qd, t */
  double *trial;  /* n: accelerations for the residual */
  double *qdd;    /* n: for the linearised residual: the solved ones where the equations can be solved, else trial */
  double *lambda; /* m */
  double *w;      /* 2n x k */
} fuzz_point;

#endif
