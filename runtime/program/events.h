/* Events of a user: times at which formulas pass zero, as options say. */
#ifndef PROGRAM_EVENTS_H
#define PROGRAM_EVENTS_H

#include "eom/events.h"
#include "formula.h"
#include "host/options.h"
#include "series.h"
#include "setup.h"

typedef struct events {
  const setup *s;
  eom_events watched; /* for the trajectory */
  int direction[OPTION_MOST_TEXTS];
  bool stops[OPTION_MOST_TEXTS];
  formula *g[OPTION_MOST_TEXTS];
  char text[OPTION_MOST_TEXTS][128];
  series found; /* event, t, q, qd of each */
  int stopped;  /* the number of the event that ended the motion, -1 */
  int broken;   /* the one whose formula is not a number at t_broken, s, the last time that was tried; -1: none */
  double t_broken;
  bool no_memory;
} events;

/* Each text is "FORMULA [rising|falling] [stop]". Returns 0, or -1 after a message. */
int events_open(events *e, const option_texts *texts, const setup *s);
void events_close(events *e);

/* Prints the first ones. */
void events_print(const events *e);

#endif
