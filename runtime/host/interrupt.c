/* Ctrl-C: a flag that a driver looks at between two rows. */
#include "host/interrupt.h"

#include <signal.h>
#include <stdatomic.h>
#include <string.h>

static atomic_int raised; /* lock-free, so that a handler may set it and any thread may read it */

static void raise_flag(int number) {
  (void)number;
  raised = 1;
}

void watch_interrupts(void) {
  struct sigaction action, before;
  memset(&action, 0, sizeof action);
  action.sa_handler = raise_flag;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
  if (sigaction(SIGHUP, NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, NULL); /* else it is nohup's */
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, NULL);
}

bool interrupted(void) { return raised != 0; }
