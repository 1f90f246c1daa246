/* An orbit in the central field, integrated in the redundant coordinates (r, u), and what it should conserve. */
#include "orbit.h"

#include "agreement.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/output.h"
#include "host/progress.h"

#include <math.h>
#include <stdlib.h>

enum { N = 4, DIM = 2 * N };

/* Cosine and sine of the angle between the orbit's plane and the plane u3 = 0. */
static const double tilt_cos = 0.8, tilt_sin = 0.6;

static const double steps_per_scale = 400.0;

typedef struct invariants {
  double energy, momentum[3]; /* J; |L| = m r^2 u x ud, kg m^2/s */
} invariants;

typedef struct flight {
  eom_system *sys;
  const struct central_field *field;
  invariants start;
  double phi, energy_error, momentum_error; /* largest so far; the last two relative */
  double t_end;
  output csv;
  bool writing;
  eom_status status;
  progress line;
} flight;

static double pericentre(double e) { return 1.0 - e; }

/* Angular rate at the pericentre, v/r = sqrt(1+e) / (1-e)^(3/2). */
static double pericentre_rate(double e) { return sqrt((1.0 + e) / (1.0 - e)) / (1.0 - e); }

static double period(void) { return 2.0 * acos(-1.0); }

static eom_status measure(flight *f, const double *y, double t, invariants *now) {
  const double *u = y + 1, *ud = y + N + 1;
  const double scale = f->field->m * y[0] * y[0];
  eom_status status = eom_energy(f->sys, y, y + N, t);
  now->energy = f->sys->energy;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    now->momentum[i] = scale * (u[j] * ud[k] - u[k] * ud[j]);
  }
  return status;
}

static double norm3(const double *a) { return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

static int observe(void *user, const eom_integrator *it) {
  flight *f = user;
  invariants now;
  double change[3];
  f->status = measure(f, it->y, it->t, &now);
  if (f->status != EOM_OK) return 1;
  for (int i = 0; i < 3; i++) change[i] = now.momentum[i] - f->start.momentum[i];
  double row[] = {it->t,
                  it->y[0],
                  it->y[1],
                  it->y[2],
                  it->y[3],
                  central_field_unit(it->y),
                  fabs((now.energy - f->start.energy) / f->start.energy),
                  norm3(change) / norm3(f->start.momentum)};
  f->phi = fmax(f->phi, fabs(row[5]));
  f->energy_error = fmax(f->energy_error, row[6]);
  f->momentum_error = fmax(f->momentum_error, row[7]);
  if (f->writing) output_row(&f->csv, row, sizeof row / sizeof row[0]);
  progress_show(&f->line, program, it->t / f->t_end);
  return interrupted();
}

static void print_orbit(const orbit_request *ask, const flight *f, const eom_integrator *it, const double *start) {
  double x[3];
  for (int i = 0; i < 3; i++) x[i] = it->y[0] * it->y[i + 1] - start[0] * start[i + 1];
  printf("Orbit with eccentricity %g, %g periods, %ld steps of %.4g s:\n", ask->eccentricity, it->t / period(), it->steps, it->h);
  printf("  largest |phi| = ||u|^2 - 1|              %.1e\n", f->phi);
  printf("  largest energy error, relative           %.1e\n", f->energy_error);
  printf("  largest angular momentum error, relative %.1e\n", f->momentum_error);
  if (ask->periods == floor(ask->periods) && it->t > f->t_end - 0.5 * it->h)
    printf("  distance from the start, m               %.1e\n", norm3(x));
}

static int report(const flight *f, eom_status status, const eom_integrator *it) {
  char text[2000];
  if (status == EOM_OK) return EXIT_DONE;
  if (interrupted()) {
    complain("stopped by the user at t = %g s of %g s", it->t, f->t_end);
    return EXIT_INTERRUPTED;
  }
  complain("the orbit ended at t = %g s of %g s: %s; a shorter --step may help", it->t, f->t_end, eom_status_text(status));
  if (f->sys->report.status != EOM_OK && eom_report_text(&f->sys->report, text, sizeof text) > 0) fputs(text, stderr);
  return EXIT_FAILED;
}

static int fly(const orbit_request *ask, flight *f) {
  const double rate = pericentre_rate(ask->eccentricity);
  const double start[DIM] = {pericentre(ask->eccentricity), 1.0, 0.0, 0.0, 0.0, 0.0, rate * tilt_cos, rate * tilt_sin};
  double step = ask->step > 0.0 ? ask->step : period() / (rate * steps_per_scale);
  double *work = malloc(eom_integrator_size(&eom_dp5, DIM) * sizeof *work);
  eom_integrator it;
  if (work == NULL) return report(f, EOM_NO_MEMORY, &it);
  f->t_end = ask->periods * period();
  progress_start(&f->line);
  eom_integrator_init(&it, &eom_dp5, eom_rhs, f->sys, DIM, 0.0, start, f->t_end / ceil(f->t_end / step), work);
  eom_status status = measure(f, start, 0.0, &f->start);
  if (status == EOM_OK) status = eom_integrate(&it, f->t_end, observe, f);
  if (f->status != EOM_OK) status = f->status;
  progress_end(&f->line);
  print_orbit(ask, f, &it, start);
  free(work);
  return report(f, status, &it);
}

static int begin_csv(flight *f, const char *path) {
  if (path == NULL) return 0;
  if (output_open(&f->csv, path) != 0) return -1;
  fputs("t,r,u1,u2,u3,phi,energy_error,momentum_error\n", f->csv.file);
  f->writing = output_flush(&f->csv) == 0;
  return f->writing ? 0 : -1;
}

int orbit(const orbit_request *ask) {
  const struct central_field field = {.m = 1.0, .mu = 1.0};
  eom_options options = eom_options_default();
  flight f = {.field = &field};
  options.needs = EOM_NEED_SIMULATE;
  if (begin_csv(&f, ask->csv) != 0) return EXIT_FAILED;
  eom_status made = eom_system_create(&f.sys, model_of(ask->kind), &field, &options);
  if (made != EOM_OK) complain("no system: %s", eom_status_text(made));
  int status = made == EOM_OK ? fly(ask, &f) : EXIT_FAILED;
  if (f.writing && output_commit(&f.csv) != 0) status = EXIT_FAILED;
  eom_system_destroy(f.sys);
  return status;
}
