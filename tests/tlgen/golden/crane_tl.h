/* Model "crane" on truncated Taylor series, printed by tlgen from crane.c. Do not edit. */
#ifndef CRANE_TL_H
#define CRANE_TL_H

#include "eom/description.h"

#ifndef TLGEN_STRUCT_point
#define TLGEN_STRUCT_point
typedef struct {
  tl_real x;
  tl_real y;
} point;
#endif

#ifndef TLGEN_STRUCT_crane
#define TLGEN_STRUCT_crane
struct crane {
  tl_real mass;
  tl_real load;
  tl_real gravity;
  int sections;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model crane_model;
extern const eom_description crane_description;

#ifdef __cplusplus
}
#endif

#endif
