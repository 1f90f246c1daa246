/* Motion functions for any model, answered by a system of their own that calls the model's jets. What the runtime makes of them must be
 * what it makes of calls. */
#ifndef TEST_ECHO_MOTION_H
#define TEST_ECHO_MOTION_H

#include "eom/system.h"

typedef struct echo {
  eom_model model;   /* with motion functions that answer for it; they know one echo at a time, the last that was started */
  eom_motion motion; /* without solved forms and parameters; may be changed before a system is made of the model */
  const eom_motion *list[1];
  eom_system *inner;
  int refusal; /* what every function returns instead of its results where it is not 0 */
} echo;

/* Starts *e for a model; e must stay where it is. Ends with echo_end. */
void echo_start(echo *e, const eom_model *model, const void *params);
void echo_end(echo *e);

#endif
