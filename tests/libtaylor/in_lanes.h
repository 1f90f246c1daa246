/* One of libtaylor's operations on jets with lanes, of which one lane belongs to the caller. Means the same to files with lanes and
 * without, and names no tl_real. */
#ifndef TEST_IN_LANES_H
#define TEST_IN_LANES_H

#include "one_lane.h"

enum { IN_LANES_A, IN_LANES_B, IN_LANES_E, IN_LANES_C, IN_LANES_D, IN_LANES_JETS };

/* The arguments of an operation of one_lane.h: a jet of one number each, null where it has none. Two may be the same. */
typedef struct lane_arguments {
  tl_number *jet[IN_LANES_JETS];
  tl_number x;
} lane_arguments;

/* Operation `which` with `mine` in this lane and `others` in all the other lanes, in which it does not fail. Fills mine's c and d.
 * Returns the status bits; *function and *at_line are what failed first and its line, where the context had this line. Ends the program
 * where another lane than this is said to have failed. */
unsigned in_lanes(int which, const tl_shape *shape, const lane_arguments *mine, const lane_arguments *others, long long n, int lane,
                  int line, int *function, int *at_line);

/* Numbers that the operation reads of the jet at this place, ncoef or fewer. */
int in_lanes_length(int which, const tl_shape *shape, int place);

#endif
