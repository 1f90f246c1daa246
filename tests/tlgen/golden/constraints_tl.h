/* Model "constraints" on truncated Taylor series, printed by tlgen from constraints.c. Do not edit. */
#ifndef CONSTRAINTS_TL_H
#define CONSTRAINTS_TL_H

#include "eom/description.h"

#ifndef TLGEN_STRUCT_linkage
#define TLGEN_STRUCT_linkage
struct linkage {
  int coordinates;
  int links;
  tl_real length[2];
  tl_real ratio;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model constraints_model;
extern const eom_description constraints_description;

#ifdef __cplusplus
}
#endif

#endif
