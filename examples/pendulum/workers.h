/* Independent tasks on all processors, with progress. */
#ifndef PENDULUM_WORKERS_H
#define PENDULUM_WORKERS_H

typedef struct task {
  void (*work)(void *data); /* called once, in any thread */
  void *data;
  double share;               /* of the time of all tasks, in any unit: a guess, for the progress */
  const _Atomic double *done; /* part of the task that is done, 0..1; or null */
} task;

/* Does all tasks, the first ones first (put the long ones there), as many at a time as there are processors. Returns the time that it
 * took, s. */
double do_tasks(const task *tasks, int count, const char *label);

#endif
