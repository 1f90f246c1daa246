/* Model "arm" on truncated Taylor series, printed by tlgen from arm.c. Do not edit. */
#ifndef ARM_TL_H
#define ARM_TL_H

#include <stdbool.h>
#include "eom/description.h"

#ifndef TLGEN_STRUCT_link
#define TLGEN_STRUCT_link
struct link {
  tl_real mass;
  float at[2];
};
#endif

#ifndef TLGEN_STRUCT_arm
#define TLGEN_STRUCT_arm
struct arm {
  struct link link[2];
  struct link tool;
  int stages;
  bool loaded;
  unsigned short code;
  tl_real table[2][3];
  const char *label;
  void *law;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model arm_model;
extern const eom_description arm_description;

#ifdef __cplusplus
}
#endif

#endif
