/* Parameters of many types. */
#ifndef HABITS_H
#define HABITS_H
#include <float.h>
#include <stdbool.h>
#define DBL_MAX_HERE DBL_MAX
typedef enum mode { SOFT, HARD } mode;
typedef struct tuning {
  double exp[3][2];
  unsigned char rows;
  bool flag;
  mode mode;
  float single;
  const double *more;
  short more_count;
  struct part { long long big; double rest; } part[2];
} tuning;
#endif
