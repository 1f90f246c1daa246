/* Plant and controller in one program, for a host and for boards: prints as CSV what both do, each number in decimals and, for those
 * that another build is held against, in bits. At the end what a control step takes, and what a machine without mass leads to. */
#include "console.h"
#include "controller.h"
#include "text.h"

#include <eom/integrate.h>

enum { ROW_EVERY = 20, STEPS = 4000 }; /* control steps */

static plant_params params;
static eom_integrator integrator;
static tl_real work[EOM_INTEGRATOR_SIZE(4, 0, D)];
static controller control;
static plant_model model;
static text line;

#if PLANT_POLES == 1
static const tl_real start[D] = {TL_C(0.0), TL_C(3.0)}; /* hangs, nearly */
#else
static const tl_real start[D] = {TL_C(0.0), TL_C(0.1), TL_C(-0.05)}; /* stands, leaning */
#endif

/* y' of y = (q,qd). */
static int rhs(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  for (int i = 0; i < N; i++) ydot[i] = y[N + i];
  return PLANT(acceleration)(user, y, y + N, t, ydot + N, NULL);
}

/* Marsaglia's xorshift of 32 bits: the same numbers everywhere. */
static uint32_t next_random(uint32_t *state) {
  *state ^= *state << 13;
  *state ^= *state >> 17;
  *state ^= *state << 5;
  return *state;
}

/* A sensor's count: the coordinate and noise of up to one count, rounded to a whole one. */
static tl_real sense(tl_real q, tl_real resolution, uint32_t *state) {
  const tl_real noise = (tl_real)(int32_t)(next_random(state) >> 16) / TL_C(32768.0) - TL_C(1.0);
  const tl_real counts = q / resolution + noise;
  return resolution * (tl_real)(int32_t)(counts + (counts < TL_C(0.0) ? TL_C(-0.5) : TL_C(0.5)));
}

static void write_names(void) {
  text_clear(&line);
  text_add(&line, "ms,mode,push,instructions");
  for (int i = 0; i < D; i++) text_add_name(&line, ",y", i);
  for (int i = 0; i < D; i++) text_add_name(&line, ",estimate", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",measured", i);
  text_add(&line, ",push_bits");
  for (int i = 0; i < D; i++) text_add_name(&line, ",y_bits", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",qdd_bits", i);
  for (int i = 0; i < N * D; i++) text_add_name(&line, ",qdd_y_bits", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",qdd_push_bits", i);
  text_add(&line, "\n");
  console_write(line.chars);
}

/* A row; the plant is linearised for it, at its true state. */
static int write_row(int step, uint32_t instructions, const tl_real *measured) {
  const int status = plant_linearise(&model, &params, integrator.y);
  text_clear(&line);
  text_add_count(&line, (uint32_t)step);
  text_add(&line, control.mode == CONTROL_HOLD ? ",hold," : ",swing,");
  text_add_decimal(&line, params.push);
  text_add(&line, ",");
  text_add_count(&line, instructions);
  text_add_decimals(&line, D, integrator.y);
  text_add_decimals(&line, D, control.y);
  text_add_decimals(&line, N, measured);
  text_add_bits(&line, 1, &params.push);
  text_add_bits(&line, D, integrator.y);
  text_add_bits(&line, N, model.qdd);
  text_add_bits(&line, N * D, model.qdd_y);
  text_add_bits(&line, N, model.qdd_push);
  text_add(&line, "\n");
  console_write(line.chars);
  return status;
}

static void write_result(const char *name, uint32_t count) {
  text_clear(&line);
  text_add(&line, name);
  text_add(&line, " ");
  text_add_count(&line, count);
  text_add(&line, "\n");
  console_write(line.chars);
}

/* Instructions of the longest control step of each mode. */
static uint32_t longest[2];

static int run(void) {
  uint32_t random = 1;
  int status = 0;
  for (int step = 0; step <= STEPS && status == 0; step++) {
    tl_real measured[N];
    for (int i = 0; i < N; i++) measured[i] = sense(integrator.y[i], i == 0 ? SENSOR_CART : SENSOR_POLE, &random);
    const uint32_t before = console_ticks();
    status = controller_step(&control, measured);
    const uint32_t instructions = console_instructions(before, console_ticks());
    if (instructions > longest[control.mode]) longest[control.mode] = instructions;
    params.push = control.params.push;
    if (status == 0 && step % ROW_EVERY == 0) status = write_row(step, instructions, measured);
    eom_integrator_restart(&integrator);
    if (status == 0) status = (int)eom_integrator_step(&integrator);
  }
  return status;
}

/* The control step of a machine without mass: its status, by which no push follows. */
static int run_without_mass(void) {
  tl_real measured[N] = {TL_C(0.0)};
  plant_params none = plant_default();
  none.cart_mass = TL_C(0.0);
#if PLANT_POLES == 1
  none.pole_mass = TL_C(0.0);
#else
  none.pole_mass[0] = none.pole_mass[1] = TL_C(0.0);
#endif
  controller_init(&control, &none, start);
  return controller_step(&control, measured);
}

int main(void) {
  params = plant_default();
  eom_integrator_init(&integrator, &eom_rk4, rhs, &params, D, TL_C(0.0), start, CONTROL_PERIOD, work);
  controller_init(&control, &params, start);
  write_names();
  const int status = run();
  write_result("# longest swing, instructions", longest[CONTROL_SWING]);
  write_result("# longest hold, instructions", longest[CONTROL_HOLD]);
  write_result("# without mass, minus status", (uint32_t)-run_without_mass());
  write_result("# without mass, push is zero", control.params.push == TL_C(0.0));
  write_result("# status", (uint32_t)status);
  return status;
}
