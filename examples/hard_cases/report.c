/* What is printed: the list of scenes, and the tables of runs. */
#include "report.h"

#include "host/message.h"
#include "host/output.h"

#include <stdio.h>

enum { PATH_SIZE = 4096, TEXT_SIZE = 80 };

void print_list(void) {
  for (int i = 0; i < nscenes; i++) printf("%-12s %s\n", scenes[i]->name, scenes[i]->about);
}

void print_head(bool markdown) {
  if (markdown)
    printf(
        "| scene | what is hard | n | m | rank | measured | required | reached | energy, J: required | reached | \\|φ\\| or \\|ψ\\| | "
        "method, step or tolerance | time / real time | others |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  else
    printf("%-12s %3s %3s %6s  %-10s %8s  %8s %8s  %8s %8s  %8s %8s  %9s\n", "scene", "n", "m", "rank", "method", "step, tol",
           "required", "error", "energy", "error, J", "|phi|", "|phi_dot|", "time/real");
}

static const char *rank_text(const run *r, char *text) {
  if (r->worst.rank == r->most_rank)
    snprintf(text, TEXT_SIZE, "%d", r->most_rank);
  else
    snprintf(text, TEXT_SIZE, "%d-%d", r->worst.rank, r->most_rank);
  return text;
}

/* A bound or error in two digits; empty where there is none. */
static const char *number(double x, bool there, char *text) {
  text[0] = '\0';
  if (there) snprintf(text, TEXT_SIZE, "%.0e", x);
  return text;
}

/* The step, or the tolerance where steps are chosen by their error. */
static double steps_of(const run *r) { return r->ask.step > 0.0 ? r->ask.step : r->ask.tolerance; }

static void print_cells(const run *r, const char *rank, const char *energy, const char *energy_error, const char *phi) {
  const scene *s = r->ask.scene;
  char steps[TEXT_SIZE];
  snprintf(steps, sizeof steps, r->ask.step > 0.0 ? "%.2g s" : "%.0e", steps_of(r));
  printf("| %s | %s | %d | %d | %s | %s, %g s | %.0e%s%s | %.0e | %s | %s | %s | %s, %s | %.1g | %s |\n", s->name, s->about, r->n, r->m,
         rank, s->measured, r->duration, s->required, s->source != NULL ? ", " : "", s->source != NULL ? s->source : "", r->worst.error,
         energy, energy_error, phi, r->ask.method, steps, r->seconds / r->duration, s->published != NULL ? s->published : "");
}

void print_run(const run *r, bool markdown) {
  const scene *s = r->ask.scene;
  char rank[TEXT_SIZE], energy[TEXT_SIZE], energy_error[TEXT_SIZE], phi[TEXT_SIZE], phi_dot[TEXT_SIZE];
  const bool conserved = s->energy > 0.0;
  number(s->energy, conserved, energy);
  number(r->worst.energy, conserved, energy_error);
  number(r->worst.phi, r->m1 > 0, phi);
  number(r->worst.phi_dot, r->m > 0, phi_dot);
  rank_text(r, rank);
  if (markdown)
    print_cells(r, rank, energy, energy_error, r->m1 > 0 ? phi : phi_dot);
  else
    printf("%-12s %3d %3d %6s  %-10s %8.2g  %8.0e %8.1e  %8s %8s  %8s %8s  %9.2g%s\n", s->name, r->n, r->m, rank, r->ask.method,
           steps_of(r), s->required, r->worst.error, energy, energy_error, phi, phi_dot, r->seconds / r->duration,
           run_passed(r) ? "" : "  MISSED");
  fflush(stdout);
}

void explain(const run *r) {
  char text[2000];
  if (r->status == EOM_OK) return;
  complain("%s ended at t = %g s of %g s: %s", r->ask.scene->name, r->worst.t, r->duration, eom_status_text(r->status));
  if (r->report.status != EOM_OK && eom_report_text(&r->report, text, sizeof text) > 0) fputs(text, stderr);
}

int write_rows(const char *folder, const run *r) {
  char path[PATH_SIZE];
  output o;
  if (snprintf(path, sizeof path, "%s/%s.csv", folder, r->ask.scene->name) >= (int)sizeof path) {
    complain("cannot write into '%s': the name is too long", folder);
    return -1;
  }
  if (output_open(&o, path) != 0) return -1;
  fputs("t,error,energy_error,phi,phi_dot,rank\n", o.file);
  for (int i = 0; i < r->nrow; i++) {
    const run_row *row = &r->rows[i];
    const double numbers[] = {row->t, row->error, row->energy, row->phi, row->phi_dot, row->rank};
    output_row(&o, numbers, sizeof numbers / sizeof numbers[0]);
  }
  return output_commit(&o);
}
