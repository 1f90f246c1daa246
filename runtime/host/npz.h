/* NumPy's .npz: arrays of doubles by name in one file, as numpy.load reads it. */
#ifndef HOST_NPZ_H
#define HOST_NPZ_H

#include "host/output.h"

#include <stddef.h>

typedef struct npz_entry {
  char name[64]; /* with .npy */
  unsigned long crc, size, at;
} npz_entry;

enum { NPZ_MOST_ENTRIES = 64, NPZ_MOST_DIMENSIONS = 3 };

/* A file being written; its bytes depend on nothing but what is added. */
typedef struct npz {
  output out;
  npz_entry entry[NPZ_MOST_ENTRIES];
  int entries;
} npz;

/* Each returns 0, or -1 after a message; then nothing is left of the file and it is closed.
 * npz_add: an array of the given shape, rows one behind the other. The distance from row to row is `stride` numbers: 0 for rows without
 * gaps. At most NPZ_MOST_ENTRIES arrays, 4 GiB in all, names of letters, digits and _. */
int npz_open(npz *z, const char *path);
int npz_add(npz *z, const char *name, const double *data, int dimensions, const long *shape, long stride);
int npz_close(npz *z);

/* CRC-32 of ISO 3309, bit by bit reflected, as zip has it, of bytes behind those that gave crc; 0 begins. */
unsigned long npz_crc32(unsigned long crc, const void *data, size_t count);

#endif
