/* The file that reference.py printed: points with blocks of numbers. */
#ifndef TEST_MECHANICS_REFERENCE_H
#define TEST_MECHANICS_REFERENCE_H

enum { MAX_BLOCKS = 9 };

/* A group of numbers in order, as reference.py names it, and the condition of its computation. */
typedef struct block {
  char name[16];
  int count;
  double condition;
  double *numbers; /* count */
} block;

typedef struct point {
  char kind[128]; /* "generic", or why the point is ill-conditioned */
  double *state;  /* q, qd, t: 2n + 1 */
  int nblock;
  block blocks[MAX_BLOCKS];
} point;

typedef struct reference {
  int n, npoint;
  point *points;
} reference;

/* Ends the program where the file cannot be read. */
reference reference_read(const char *path);
void reference_free(reference *r);

/* The block of that name; ends the program where there is none. */
const block *reference_block(const point *p, const char *name);

#endif
