/* Indices of partial derivatives. */
#include "index.h"

bool next_index(int *index, int order, int count) {
  for (int k = order - 1; k >= 0; k--) {
    if (index[k] + 1 >= count) continue;
    int value = index[k] + 1;
    for (int i = k; i < order; i++) index[i] = value;
    return true;
  }
  return false;
}
