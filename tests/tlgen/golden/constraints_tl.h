/* Model "constraints" on truncated Taylor series, printed by tlgen from constraints.c. Do not edit. */
#ifndef CONSTRAINTS_TL_H
#define CONSTRAINTS_TL_H

#include "eom/model.h"

#ifndef TLGEN_STRUCT_linkage
#define TLGEN_STRUCT_linkage
struct linkage {
  int coordinates;
  int links;
  double length[2];
  double ratio;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model constraints_model;

#ifdef __cplusplus
}
#endif

#endif
