/* The report as readable text, for hosts: stdio makes it. */
#include "eom/status.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

/* Text that grows at the end and counts on where the buffer is full. */
typedef struct writer {
  char *text;
  size_t size, length;
} writer;

static void put(writer *w, const char *format, ...) {
  va_list args;
  va_start(args, format);
  const size_t room = w->length < w->size ? w->size - w->length : 0;
  const int wrote = vsnprintf(room ? w->text + w->length : NULL, room, format, args);
  va_end(args);
  if (wrote > 0) w->length += (size_t)wrote;
}

static void put_function(writer *w, const eom_report *r) {
  if (!r->function) return;
  put(w, "  in %s", r->function);
  if (r->source) put(w, " (%s)", r->source);
  if (r->index >= 0) put(w, ", number %d (counted from 0)", r->index);
  put(w, "\n");
  if (r->jet.bits == TL_OK) return;
  const bool either = (r->jet.bits & TL_DOMAIN) && (r->jet.bits & TL_SINGULAR);
  put(w, "  %s in %s", either ? "no value or no derivative" : tl_status_text(r->jet.bits), tl_fn_name(r->jet.function));
  if (r->jet.bits & TL_NO_SPACE) put(w, " (does a helper call itself deeper than was said to tlgen?)");
  if (r->jet.line > 0) put(w, ", line %d of %s", r->jet.line, r->jet.file ? r->jet.file : "the model");
  put(w, "\n");
}

static void put_row(writer *w, const eom_row *row) {
  static const char *const kind[] = {"independent", "dependent on the others", "inconsistent with the others", "not satisfied"};
  put(w, "  %s[%d]", row->name, row->row);
  if (row->source) put(w, " (%s)", row->source);
  put(w, ": %s\n", kind[row->kind]);
}

static void put_solve(writer *w, const eom_report *r) {
  if (r->status == EOM_NO_INERTIA) put(w, "  coordinate %d (counted from 0) can move without inertia\n", r->index);
  if (r->status == EOM_NO_EQUILIBRIUM) put(w, "  coordinate %d (counted from 0) still accelerates\n", r->index);
  if (r->status == EOM_NO_STEP) put(w, "  coordinate %d (counted from 0) is not settled\n", r->index);
  if (r->rank < 0) return;
  put(w, "  constraint rank %d", r->rank);
  if (r->condition >= TL_C(0.0)) put(w, ", condition %.2g", (double)r->condition);
  if (r->residual >= TL_C(0.0)) put(w, ", largest |A qdd - b| %.2g", (double)r->residual);
  if (r->pivot >= TL_C(0.0)) put(w, ", smallest pivot of %s %.2g", r->weighted ? "M + A'WA" : "M", (double)r->pivot);
  put(w, "\n");
  const int shown = r->nrow < EOM_REPORT_ROWS ? r->nrow : EOM_REPORT_ROWS;
  for (int i = 0; i < shown; i++) put_row(w, &r->row[i]);
  if (r->nrow > shown) put(w, "  and %d more rows\n", r->nrow - shown);
}

int eom_report_text(const eom_report *report, char *text, size_t size) {
  writer w = {text, size, 0};
  if (size > 0) text[0] = '\0';
  put(&w, "%s\n", eom_status_text(report->status));
  put_function(&w, report);
  put_solve(&w, report);
  return (int)w.length;
}
