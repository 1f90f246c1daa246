/* Events and output inside the steps of eom_integrate: times at which functions g(t,y) pass zero, and states at given times. Neither
 * changes the steps, until an event changes the state. */
#ifndef EOM_EVENTS_H
#define EOM_EVENTS_H

#include "eom/integrate.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- events ---- */

/* g(t,y): as many numbers as there are events. Returns 0, or any other number where there is no g. */
typedef int eom_root_fn(void *user, tl_real t, const tl_real *y, tl_real *g);

typedef enum eom_event_action {
  EOM_EVENT_GO_ON,   /* nothing has changed */
  EOM_EVENT_CHANGED, /* y, or what f depends on: the integration begins anew there */
  EOM_EVENT_STOP /* eom_integrate returns EOM_STOPPED at the event, with y as the handler leaves it; it may be called again to go on */
} eom_event_action;

/* Called at event number `event` with the state there, y: dim, interpolated and then corrected as it->correct does. */
typedef eom_event_action eom_event_fn(void *user, int event, tl_real t, tl_real *y);

/* Zeros make a choice. To be attached as it.events after eom_integrator_init, and to live as long.
 *
 * An event is where g_i changes its sign, or is exactly zero at a place that was looked at: the ends of each step's parts. A function
 * that passes zero twice within one part is not seen. One that is zero where the integration begins has no event there; nor has it a
 * second one where its event changed the state or stopped. */
typedef struct eom_events {
  int count;
  eom_root_fn *root;
  eom_event_fn *handle; /* null: every event stops */
  void *user;           /* of root and handle */
  const int *direction; /* count: 1 for events where g_i rises as t grows, -1 where it falls, 0 for both; null: both for all */
  tl_real tolerance;    /* of an event's time, s; 0: some units of its last place */
  int parts;       /* of a step; 0: 4. With 1 only ends of steps are looked at, and nothing is interpolated until there is an event */
  tl_real apart;   /* s: no part is longer, however long steps are; 0: any length */
  tl_real *work;   /* eom_events_size(count) numbers */
  long found;      /* filled: events until now, */
  int last;        /* and the last one's number */
  int cut, known;  /* private: an event cut the last step; g in work is that at known_t */
  tl_real known_t; /* private */
} eom_events;

/* Numbers (tl_real) of workspace for count events. */
size_t eom_events_size(int count);

/* ---- output ---- */

/* Called at each time in turn with the state there, y: dim; between the ends of steps it is interpolated and not corrected. */
typedef void eom_output_fn(void *user, tl_real t, const tl_real *y);

/* To be attached as it.outputs after eom_integrator_init, and to live as long. The times are along the way of the integration, none
 * before it begins (NOT_IN_STEP). */
typedef struct eom_outputs {
  eom_output_fn *write;
  void *user;
  const tl_real *times; /* count, s; null: first + k every, k < count */
  tl_real first, every;
  long count;
  long next; /* filled: how many were written; starts at 0 */
} eom_outputs;

#ifdef __cplusplus
}
#endif

#endif
