/* Indices of partial derivatives, each derivative once. */
#ifndef TEST_INDEX_H
#define TEST_INDEX_H

#include <stdbool.h>

/* The next index[order] with index[0] <= index[1] <= .. < count, from all zero on; false after the last. */
bool next_index(int *index, int order, int count);

#endif
