/* A motion followed from a start, with its rows: what run, compare and watch share. */
#ifndef PROGRAM_MOTION_H
#define PROGRAM_MOTION_H

#include "derivatives.h"
#include "events.h"
#include "method.h"

typedef struct motion_request {
  const setup *s;
  const method *how;
  double t_end, every;         /* s; every > 0 */
  const option_texts *columns; /* "NAME=FORMULA" each; null: none */
  const option_texts *events;  /* null: none */
  const char *sensitivity;     /* names with commas between them; null: none */
  bool quiet;                  /* no line of progress */
} motion_request;

typedef enum motion_end { MOTION_COMPLETE, MOTION_EVENT, MOTION_INTERRUPTED, MOTION_FAILED } motion_end;

typedef struct motion {
  motion_request ask;
  series rows; /* t, q, qd, energy, energy_change, with constraints phi and phi_dot, then derivatives and the user's columns */
  events met;
  derivatives derivatives;
  motion_end end;
  double t;                                    /* where it ended, s */
  double *y;                                   /* 2n: there */
  double energy0, energy_change, phi, phi_dot; /* at the start; the largest at a row: |E - E0|, |phi|, and |phi_dot| or |psi| */
  eom_trajectory_work work;
  /* private */
  eom_system *sys; /* for the rows: that of the trajectory is in the middle of a step */
  formula *column[OPTION_MOST_TEXTS];
  void *line;
  bool projects;
  eom_status broken; /* a row could not be measured */
  bool no_memory;
} motion;

/* Prepares rows, columns and events. Returns 0, or -1 after a message; then there is nothing to close. */
int motion_open(motion *m, const motion_request *ask);

/* Follows the motion; m->end says how it ended, after a message unless it is MOTION_COMPLETE or MOTION_EVENT. */
void motion_follow(motion *m);
void motion_close(motion *m);

#endif
