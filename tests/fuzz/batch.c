/* One child process per program: what kills one leaves the others alone. */
#include "batch.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SECONDS = 60 }; /* of the processor's time */

static int child(const fuzz_program *p) {
  const struct rlimit limit = {SECONDS, SECONDS};
  char *arguments[] = {p->name, p->params, NULL};
  setrlimit(RLIMIT_CPU, &limit);
  p->rounded(2, arguments);
  const int status = p->run(2, arguments);
  fflush(stdout);
  return status;
}

static void run(const fuzz_program *p) {
  int status = 0;
  const pid_t id = fork();
  if (id == 0) _exit(child(p));
  if (id < 0 || waitpid(id, &status, 0) < 0) {
    perror("fork");
    exit(2);
  }
  if (WIFSIGNALED(status))
    printf("%s FAULT killed by signal %d\n", p->name, WTERMSIG(status));
  else if (WEXITSTATUS(status) > 1)
    printf("%s FAULT exit status %d\n", p->name, WEXITSTATUS(status));
  fflush(stdout);
}

int fuzz_batch(const fuzz_program *programs, int count) {
  for (int i = 0; i < count; i++) run(&programs[i]);
  return 0;
}
