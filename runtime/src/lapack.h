/* LAPACKE for the files that end in _lapacke.c, which alone include it. LAPACK stores columns one after the other. The _work functions
 * allocate nothing. */
#ifndef EOM_LAPACK_H
#define EOM_LAPACK_H

#include "taylor/real.h"

#include <lapacke.h>

#if TL_REAL == TL_FLOAT
#define LAPACK(name) LAPACKE_s##name##_work
#else
#define LAPACK(name) LAPACKE_d##name##_work
#endif

/* OpenBLAS wakes its other threads for matrices of order 2 already (measured: 18 us for 0.2 us of work). It is kept to one thread
 * during a call up to a moderate order n, and given back what the program had set. Put around calls; end takes what begin returned. */
int eom_lapack_begin(int n);
void eom_lapack_end(int threads);

#endif
