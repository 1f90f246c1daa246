/* Private parts of a system: the stages of evaluation, the factorisation, and how memory is laid out. */
#ifndef EOM_WORKSPACE_H
#define EOM_WORKSPACE_H

#include "eom/bytes.h"
#include "linalg.h"

#include <stdbool.h>

/* A kind of evaluation: a shape, the tangents that the seeds carry, and the memory its context takes. */
typedef enum eom_stage_id {
  STAGE_ENERGY,                /* {1} x C(2n,1) */
  STAGE_MASS,                  /* {1} x C(n,2), tangents on qd */
  STAGE_FORCE,                 /* {1,s} x C(2n,1) */
  STAGE_GAMMA,                 /* {1} */
  STAGE_HOLONOMIC,             /* {1,s,s2} x C(n,1), tangents on q */
  STAGE_NONHOLONOMIC,          /* {1,s} x C(n,1), tangents on qd */
  STAGE_LINEARISE,             /* {1,s} x C(2n,2) */
  STAGE_GAMMA_LINEARISE,       /* {1} x C(2n,1) */
  STAGE_DISSIPATION,           /* {1} x C(n,1), tangents on qd */
  STAGE_DISSIPATION_LINEARISE, /* {1} x C(2n,2) */
  STAGE_CURVATURE,             /* {1} x C(n,2), tangents on q */
  STAGE_NONHOLONOMIC_Q,        /* {1} x C(n,1), tangents on q */
  STAGE_LOCATE,                /* {1,s,s2} */
  STAGE_COUNT
} eom_stage_id;

typedef struct eom_stage {
  bool used;
  tl_spec spec;
  int first_q, first_qd; /* number of the tangent on coordinate 0, velocity 0; -1 for none */
  size_t frame;          /* jets of frame stack */
  size_t context;        /* numbers for the context */
  size_t rows;           /* result jets */
  tl_shape *shape;       /* null until memory is laid out */
} eom_stage;

/* calM = M + A'WA = S^-1 L L' S^-1, B = L^-1 S A' with columns of unit length: B D P = Q [R11 R12; 0 R22], and where the rank r is
 * below the number of rows also [R11 R12]' = U [T; 0]. */
typedef struct eom_factor {
  bool weighted;
  bool kept;          /* L and S are those of kept_M, */
  tl_real kept_pivot; /* with this smallest pivot */
  tl_real *kept_M;    /* n x n; null where M is not known to be constant */
  int count;          /* rows of A in use, */
  int *row;           /* m: and which */
  int rank;
  tl_real *L;     /* n x n */
  tl_real *S;     /* n: powers of two that bring the diagonal of calM near 1 */
  tl_real *W;     /* m: weights in use */
  tl_real *B;     /* count vectors of n: the QR factorisation */
  tl_real *D;     /* m: one over the length of each column of L^-1 S A' */
  tl_real *tau;   /* min(n,m) */
  int *pivot;     /* count: column j of B P is row pivot[j] of A */
  tl_real *U;     /* rank vectors of count */
  tl_real *tau_u; /* m */
  tl_real *y, *v; /* n, m: inside a solve */
  tl_real *w;     /* m */
  tl_real *work;  /* linear algebra */
  int nwork;
} eom_factor;

/* The decision that eom_project made about the rows' rank, for the solves that follow. */
typedef struct eom_held {
  int rank_q;     /* of the holonomic rows, */
  int rank;       /* and of all; -1: nothing is held */
  int *row;       /* m: rank rows that are independent */
  tl_real *pivot; /* m: all rows' pivots then */
  tl_real speed;  /* the largest velocity of a projected state so far, coordinates scaled to unit inertia */
} eom_held;

/* Rows of lanes for eom_lanes_solve. */
typedef struct eom_lanes {
  tl_real (*R1)[EOM_LANES], (*R2)[EOM_LANES];             /* n, m: right-hand sides */
  tl_real (*dq)[EOM_LANES], (*dl)[EOM_LANES];             /* n, m: solutions */
  tl_real (*r1)[EOM_LANES], (*r2)[EOM_LANES];             /* n, m: residuals */
  tl_real (*change_q)[EOM_LANES], (*change_l)[EOM_LANES]; /* n, m: corrections */
  tl_real (*v)[EOM_LANES], (*w)[EOM_LANES];               /* m: inside a pass */
} eom_lanes;

struct eom_workspace {
  eom_stage stage[STAGE_COUNT];
  tl_ctx cx;
  tl_real *jets; /* seeds of q, qd, t and the results, of the stage in use */
  tl_real *jet_q, *jet_qd, *jet_t, *jet_out;
  tl_real *context; /* memory of cx */
  size_t njets, ncontext;

  const eom_linalg *linalg;
  tl_real *weights; /* m: the user's W; null where there is none */
  eom_factor factor;
  eom_held held;
  tl_real *b_size;      /* m: size of the terms that cancel in b */
  tl_real *r1, *r2;     /* n, m: residuals of the equations */
  tl_real *dq, *dl;     /* n, m: corrections */
  tl_real *was, *miss;  /* 2n, m: the state and the rows of a projection */
  tl_real *rhs1, *rhs2; /* right-hand sides of n, of m: 2n of them where calls linearise, else one; null where none are solved for */
  tl_real *sol1, *sol2; /* n, m: a solution */
  eom_lanes lanes;      /* likewise */
  tl_real *pull;        /* 2n: derivative of Baumgarte's terms of one row; likewise, where there are such */

  eom_emitter emitter[EOM_TASK_COUNT]; /* AUTO: not needed */
  tl_real *motion_work;
};

/* Memory handed out from front to back; with base null it only counts. */
typedef struct eom_arena {
  char *base;
  size_t used;
  bool overflow;
} eom_arena;

#define EOM_ALIGNMENT EOM_MOTION_ALIGNMENT

/* An arena at the first aligned place of memory: needs EOM_ALIGNMENT bytes more than what will be taken. */
eom_arena eom_arena_at(void *memory);

void *eom_arena_take(eom_arena *arena, size_t count, size_t size);

/* A tl_real vector of count numbers. */
tl_real *eom_arena_reals(eom_arena *arena, size_t count);

#endif
