/* Independent tasks on all processors, with progress. */
#include "workers.h"

#include "host/progress.h"

#include <pthread.h>
#include <stdatomic.h>
#include <time.h>
#include <unistd.h>

enum { MOST_WORKERS = 16 };

typedef struct pool {
  const task *tasks;
  int count;
  atomic_int next, done;
} pool;

static void *worker(void *user) {
  pool *p = user;
  for (int i = p->next++; i < p->count; i = p->next++) {
    p->tasks[i].work(p->tasks[i].data);
    p->done++;
  }
  return NULL;
}

static double fraction_done(const pool *p) {
  double done = 0.0, all = 0.0;
  for (int i = 0; i < p->count; i++) {
    all += p->tasks[i].share;
    if (p->tasks[i].done != NULL) done += p->tasks[i].share * *p->tasks[i].done;
  }
  return done / all;
}

static void wait_with_progress(const pool *p, const char *label, progress *line) {
  const struct timespec nap = {.tv_nsec = 20000000};
  while (p->done < p->count) {
    progress_show(line, label, fraction_done(p));
    nanosleep(&nap, NULL);
  }
}

double do_tasks(const task *tasks, int count, const char *label) {
  pool p = {.tasks = tasks, .count = count};
  pthread_t threads[MOST_WORKERS];
  progress line;
  long processors = sysconf(_SC_NPROCESSORS_ONLN);
  int wanted = processors < 1 ? 1 : processors > MOST_WORKERS ? MOST_WORKERS : (int)processors;
  int started = 0;

  progress_start(&line);
  while (started < wanted && started < count && pthread_create(&threads[started], NULL, worker, &p) == 0) started++;
  if (started == 0) worker(&p);
  wait_with_progress(&p, label, &line);
  for (int i = 0; i < started; i++) pthread_join(threads[i], NULL);
  return progress_end(&line);
}
