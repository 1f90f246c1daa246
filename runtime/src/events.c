/* Events and output inside a step: signs at the ends of its parts, roots on the interpolation, and what happens there in order. */
#include "eom/events.h"

#include "step.h"

#include <assert.h>
#include <string.h>

static const tl_real usual_tolerance = TL_C(4.0); /* units of the last place of t */
static const tl_real aside = TL_C(16.0);          /* see next_sign */
enum { USUAL_PARTS = 4, MOST_PARTS = 1 << 20 };

/* The parts of work: g at the start and at the end of a part, g where it is tried, times of roots, and the events that cut the step. */
enum { FROM, TO, TRIED, ROOT, FIRED, KINDS };

static tl_real *of(const eom_events *ev, int kind) { return ev->work + (size_t)kind * (size_t)ev->count; }

size_t eom_events_size(int count) { return (size_t)count * KINDS; }

static tl_real size(tl_real x) { return TL_LIBM(fabs)(x); }
static tl_real larger(tl_real a, tl_real b) { return a > b ? a : b; }

static tl_real tolerance_of(const eom_integrator *it) {
  const tl_real t = larger(size(it->t_before), size(it->t_after));
  return larger(it->events->tolerance, usual_tolerance * TL_EPSILON * t);
}

/* Room for one state while the last step is interpolated: a slope that is not needed any more then. */
static eom_status state_at(eom_integrator *it, tl_real t, tl_real **y) {
  *y = eom_slope(it, it->method->stages - 1);
  return eom_interpolate(it, t, *y);
}

static eom_status values(eom_integrator *it, tl_real t, const tl_real *y, tl_real *g) {
  const eom_events *ev = it->events;
  it->rhs_code = ev->root(ev->user, t, y, g);
  if (it->rhs_code != 0) return EOM_RHS_FAILED;
  return eom_all_finite(g, ev->count) ? EOM_OK : EOM_NOT_FINITE;
}

static eom_status values_at(eom_integrator *it, tl_real t, tl_real *g) {
  tl_real *y;
  const eom_status status = t == it->t_after ? EOM_OK : state_at(it, t, &y);
  return status == EOM_OK ? values(it, t, t == it->t_after ? it->y : y, g) : status;
}

/* How far behind an event its function's next sign is taken: some tolerances, and so far that the sign is not one of rounding, which t
 * alone cannot tell near zero. */
static tl_real next_sign(const eom_integrator *it, tl_real h) {
  const tl_real shift = larger(aside * tolerance_of(it), TL_LIBM(sqrt)(TL_EPSILON) / aside * size(h));
  return shift < size(h) ? TL_LIBM(copysign)(shift, h) : h;
}

/* g at the start of the step. Where it is zero, or its event has just been, a little later on the tangent. */
static eom_status begin(eom_integrator *it) {
  eom_events *ev = it->events;
  tl_real *g = of(ev, FROM), *later = of(ev, TRIED);
  const tl_real *fired = of(ev, FIRED);
  eom_status status = values(it, it->t_before, it->before, g);
  const tl_real shift = next_sign(it, it->t_after - it->t_before);
  tl_real *y;
  if (status == EOM_OK) status = state_at(it, it->t_before, &y);
  if (status != EOM_OK) return status;
  for (int i = 0; i < it->dim; i++) y[i] += shift * it->slope[i];
  status = values(it, it->t_before + shift, y, later);
  for (int i = 0; i < ev->count; i++)
    if (g[i] == TL_C(0.0) || (ev->cut && fired[i] != TL_C(0.0))) g[i] = later[i];
  ev->cut = 0;
  return status;
}

/* ---- roots ---- */

static int sign(tl_real x) { return (x > TL_C(0.0)) - (x < TL_C(0.0)); }

/* g_i has an event between values of which only the second may be zero, on a way in the direction of h. */
static int passes(const eom_events *ev, int i, tl_real h) {
  const int from = sign(of(ev, FROM)[i]), to = sign(of(ev, TO)[i]), wanted = ev->direction ? ev->direction[i] : 0;
  return from != 0 && to != from && (wanted == 0 || wanted == -from * sign(h));
}

/* The time of the root of g_i between a and b, to the tolerance and on the side of b: regula falsi with the weights of Anderson and
 * Bjorck, and bisection where three of its steps have not halved the way. */
static eom_status locate(eom_integrator *it, int i, tl_real a, tl_real b, tl_real *root) {
  const eom_events *ev = it->events;
  const tl_real tolerance = tolerance_of(it);
  tl_real *g = of(ev, TRIED), ga = of(ev, FROM)[i], gb = of(ev, TO)[i], checked = size(b - a);
  for (int tries = 0, moved = 0; size(b - a) > tolerance && gb != TL_C(0.0); tries++) {
    tl_real x = a + (b - a) * (ga / (ga - gb));
    if (tries % 3 == 2) {
      if (size(b - a) > checked / TL_C(2.0)) x = a + (b - a) / TL_C(2.0), moved = 0;
      checked = size(b - a);
    }
    const tl_real nearest = TL_LIBM(copysign)(tolerance / TL_C(2.0), b - a);
    if (size(x - a) < size(nearest)) x = a + nearest;
    if (size(b - x) < size(nearest)) x = b - nearest;
    if (x == a || x == b) break;
    const eom_status status = values_at(it, x, g);
    if (status != EOM_OK) return status;
    const int to = sign(g[i]) != sign(ga); /* x takes the place of b */
    const tl_real kept = TL_C(1.0) - g[i] / (to ? gb : ga);
    const tl_real weight = moved != (to ? 1 : -1) ? TL_C(1.0) : kept > TL_C(0.0) ? kept : TL_C(0.5);
    if (to)
      b = x, gb = g[i], ga *= weight;
    else
      a = x, ga = g[i], gb *= weight;
    moved = to ? 1 : -1;
  }
  *root = b;
  return EOM_OK;
}

/* ---- what happens at an event ---- */

static void cut_step(eom_integrator *it, tl_real t, const tl_real *y) {
  memcpy(it->y, y, (size_t)it->dim * sizeof(tl_real));
  it->t = t;
  it->t0 = t - (tl_real)it->steps * it->h;
  eom_integrator_restart(it);
}

/* The event that comes first, or -1. */
static int first_root(const eom_integrator *it) {
  const tl_real *root = of(it->events, ROOT);
  int first = -1;
  for (int i = 0; i < it->events->count; i++)
    if (TL_ISFINITE(root[i]) && (first < 0 || size(root[i] - it->t_before) < size(root[first] - it->t_before))) first = i;
  return first;
}

/* Handles the events of a part in order, until one cuts the step. Those within the tolerance of that one are handled with it, since
 * their sign at its time is not known. */
static eom_status handle(eom_integrator *it, eom_event_action *action) {
  eom_events *ev = it->events;
  tl_real *root = of(ev, ROOT), *fired = of(ev, FIRED), *y;
  memset(fired, 0, (size_t)ev->count * sizeof(tl_real));
  for (int i = first_root(it); i >= 0; i = first_root(it)) {
    const tl_real t = root[i];
    eom_status status = eom_write_outputs(it, t);
    if (status == EOM_OK) status = state_at(it, t, &y);
    if (status == EOM_OK && it->correct && (it->rhs_code = it->correct(it->user, t, y)) != 0) status = EOM_RHS_FAILED;
    if (status != EOM_OK) return status;
    for (; i >= 0 && size(root[i] - t) <= tolerance_of(it); i = first_root(it)) {
      const eom_event_action asked = ev->handle ? ev->handle(ev->user, i, t, y) : EOM_EVENT_STOP;
      if (asked > *action) *action = asked;
      ev->found++;
      ev->last = i;
      root[i] = (tl_real)NAN;
      fired[i] = TL_C(1.0);
      if (*action == EOM_EVENT_GO_ON) break;
    }
    if (*action == EOM_EVENT_GO_ON) continue;
    cut_step(it, t, y);
    ev->cut = 1;
    return EOM_OK;
  }
  return EOM_OK;
}

/* Events between a and b, where g is in FROM; it is left for b. */
static eom_status watch_part(eom_integrator *it, tl_real a, tl_real b, eom_event_action *action) {
  const eom_events *ev = it->events;
  eom_status status = values_at(it, b, of(ev, TO));
  for (int i = 0; i < ev->count && status == EOM_OK; i++) {
    of(ev, ROOT)[i] = (tl_real)NAN;
    if (passes(ev, i, b - a)) status = locate(it, i, a, b, &of(ev, ROOT)[i]);
  }
  if (status == EOM_OK) status = handle(it, action);
  memcpy(of(ev, FROM), of(ev, TO), (size_t)ev->count * sizeof(tl_real));
  return status;
}

/* As many as asked for, and so many that none is longer than it may be. */
static int parts_of(const eom_events *ev, tl_real h) {
  const int parts = ev->parts > 0 ? ev->parts : USUAL_PARTS;
  if (!(size(h) > ev->apart * (tl_real)parts) || ev->apart == TL_C(0.0)) return parts;
  const tl_real wanted = size(h) / ev->apart;
  return wanted < (tl_real)MOST_PARTS ? (int)wanted + 1 : MOST_PARTS;
}

eom_status eom_watch_step(eom_integrator *it) {
  eom_events *ev = it->events;
  assert(ev->count > 0 && ev->root && ev->work && ev->tolerance >= TL_C(0.0) && ev->apart >= TL_C(0.0));
  const int parts = parts_of(ev, it->t_after - it->t_before);
  const tl_real start = it->t_before, end = it->t_after;
  eom_event_action action = EOM_EVENT_GO_ON;
  eom_status status = it->watched && ev->known && ev->known_t == start ? EOM_OK : begin(it);
  for (int part = 0; part < parts && status == EOM_OK && action == EOM_EVENT_GO_ON; part++) {
    const tl_real from = start + (end - start) * ((tl_real)part / (tl_real)parts);
    const tl_real to = part + 1 == parts ? end : start + (end - start) * ((tl_real)(part + 1) / (tl_real)parts);
    status = watch_part(it, from, to, &action);
  }
  if (status != EOM_OK) return status;
  if (action == EOM_EVENT_GO_ON) it->watched = 1, ev->known = 1, ev->known_t = end;
  return action == EOM_EVENT_STOP ? EOM_STOPPED : EOM_OK;
}

/* ---- output ---- */

/* A time that rounding put behind the end of the step is the end. */
eom_status eom_write_outputs(eom_integrator *it, tl_real until) {
  eom_outputs *out = it->outputs;
  const tl_real ahead = TL_LIBM(copysign)(TL_C(1.0), it->h);
  for (; out && out->next < out->count; out->next++) {
    const tl_real t = out->times ? out->times[out->next] : out->first + (tl_real)out->next * out->every;
    const tl_real left = (until - t) * ahead;
    if (!(left >= usual_tolerance * -TL_EPSILON * size(t))) return EOM_OK;
    tl_real *y = it->y;
    const eom_status status = left <= TL_C(0.0) && until == it->t ? EOM_OK : state_at(it, left < TL_C(0.0) ? until : t, &y);
    if (status != EOM_OK) return status;
    out->write(out->user, t, y);
  }
  return EOM_OK;
}
