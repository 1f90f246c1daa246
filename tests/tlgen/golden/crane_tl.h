/* Model "crane" on truncated Taylor series, printed by tlgen from crane.c. Do not edit. */
#ifndef CRANE_TL_H
#define CRANE_TL_H

#include "eom/model.h"

typedef struct {
  double x;
  double y;
} point;

struct crane {
  double mass;
  double load;
  double gravity;
  int sections;
};

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model crane_model;

#ifdef __cplusplus
}
#endif

#endif
