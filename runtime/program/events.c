/* Events of a user: times at which formulas pass zero, as options say. */
#include "events.h"

#include "host/message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PRINTED = 10 };

static int root(void *user, tl_real t, const tl_real *y, tl_real *g) {
  events *e = user;
  const formula_point at = {.m = &e->s->model, .n = e->s->n, .q = y, .qd = y + e->s->n, .t = t};
  for (int i = 0; i < e->watched.count; i++) {
    g[i] = formula_value(e->g[i], &at);
    if (isfinite(g[i])) continue;
    e->broken = i;
    e->t_broken = t;
    return -1;
  }
  e->broken = -1;
  return 0;
}

static eom_event_action handle(void *user, int event, tl_real t, tl_real *y) {
  events *e = user;
  double *row = series_row(&e->found);
  if (row == NULL) {
    e->no_memory = true;
    return EOM_EVENT_STOP;
  }
  row[0] = event;
  row[1] = t;
  memcpy(row + 2, y, 2 * (size_t)e->s->n * sizeof *y);
  if (!e->stops[event]) return EOM_EVENT_GO_ON;
  e->stopped = event;
  return EOM_EVENT_STOP;
}

/* Cuts a word off the end of a text, where it stands there behind a blank. */
static bool cut_word(char *text, const char *word) {
  size_t n = strlen(text), m = strlen(word);
  while (n > 0 && text[n - 1] == ' ') text[--n] = '\0';
  if (n <= m || strcmp(text + n - m, word) != 0 || text[n - m - 1] != ' ') return false;
  text[n - m - 1] = '\0';
  return true;
}

static int read_event(events *e, int i, const char *text) {
  char formula_text[sizeof e->text[0]], error[512];
  if (strlen(text) >= sizeof formula_text) {
    complain("--event '%.40s..': more than %zu characters", text, sizeof formula_text - 1);
    return -1;
  }
  strcpy(e->text[i], text);
  strcpy(formula_text, text);
  for (bool more = true; more;) {
    more = false;
    if (cut_word(formula_text, "stop")) more = e->stops[i] = true;
    if (cut_word(formula_text, "rising")) e->direction[i] = 1, more = true;
    if (cut_word(formula_text, "falling")) e->direction[i] = -1, more = true;
  }
  e->g[i] = formula_parse(formula_text, FORMULA_STATE, &e->s->model, error, sizeof error);
  if (e->g[i] == NULL) {
    complain("--event %s", error);
    return -1;
  }
  const formula_point at = {.m = &e->s->model, .n = e->s->n, .q = e->s->q, .qd = e->s->qd, .t = e->s->t0};
  if (isfinite(formula_value(e->g[i], &at))) return 0;
  complain("--event '%s': not a number at the start; there are q[0] to q[%d], qd[0] to qd[%d]", text, e->s->n - 1, e->s->n - 1);
  return -1;
}

int events_open(events *e, const option_texts *texts, const setup *s) {
  *e = (events){.s = s, .stopped = -1, .broken = -1};
  e->watched = (eom_events){.count = texts->count, .root = root, .handle = handle, .user = e, .direction = e->direction};
  for (int i = 0; i < texts->count; i++)
    if (read_event(e, i, texts->text[i]) != 0) return events_close(e), -1;
  if (series_group_add(&e->found, "event", 0) != 0 || series_group_add(&e->found, "t", 0) != 0 ||
      series_group_add(&e->found, "q", s->n) != 0 || series_group_add(&e->found, "qd", s->n) != 0)
    return events_close(e), -1;
  for (int i = 0; i < 2 * s->n; i++) snprintf(e->found.name[2 + i], sizeof e->found.name[0], "%s", component_name(s, i));
  e->watched.work = calloc(eom_events_size(texts->count > 0 ? texts->count : 1), sizeof(tl_real));
  return e->watched.work != NULL ? 0 : (events_close(e), -1);
}

void events_close(events *e) {
  for (int i = 0; i < e->watched.count; i++) formula_free(e->g[i]);
  free(e->watched.work);
  series_free(&e->found);
  e->watched = (eom_events){.count = 0};
}

void events_print(const events *e) {
  if (e->watched.count == 0) return;
  printf("Events: %ld\n", e->found.count);
  for (long k = 0; k < e->found.count && k < PRINTED; k++) {
    const double *row = e->found.rows + k * e->found.width;
    printf("  t = %-14.9g %s\n", row[1], e->text[(int)row[0]]);
  }
  if (e->found.count > PRINTED) printf("  and %ld more\n", e->found.count - PRINTED);
}
