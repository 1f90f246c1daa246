/* Model "crane" on truncated Taylor series, printed by tlgen from crane.c. Do not edit. */
#ifndef CRANE_TL_H
#define CRANE_TL_H

#include "eom/model.h"

#ifndef TLGEN_STRUCT_point
#define TLGEN_STRUCT_point
typedef struct {
  double x;
  double y;
} point;
#endif

#ifndef TLGEN_STRUCT_crane
#define TLGEN_STRUCT_crane
struct crane {
  double mass;
  double load;
  double gravity;
  int sections;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model crane_model;

#ifdef __cplusplus
}
#endif

#endif
