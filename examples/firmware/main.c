/* Plant and controller in one program, for a host and for boards: prints as CSV what both do, each number in decimals and, for those
 * that another build is held against, in bits. At the end what a control step takes, and how the poles stand what goes wrong in it. */
#include "console.h"
#include "loop.h"
#include "text.h"

enum { ROW_EVERY = 20, STEPS = 3400, FAULT_STEPS = 120, FAULT_FROM = 40, FAULT_TO = 60 }; /* control steps */

static loop machine;
static plant_model model;
static text line;

#if PLANT_POLES == 1
static const tl_real hanging[D] = {TL_C(0.0), TL_C(3.0)}, leaning[D] = {TL_C(0.0), TL_C(0.05)};
#else
static const tl_real hanging[D] = {TL_C(0.0), TL_C(3.12), TL_C(3.15)}, leaning[D] = {TL_C(0.0), TL_C(0.05), TL_C(-0.02)};
#endif

static const char *const mode_names[CONTROL_MODES] = {"rest", "swing", "hold"};

static void write_names(void) {
  text_add(&line, "ms,mode,push,instructions");
  for (int i = 0; i < D; i++) text_add_name(&line, ",y", i);
  for (int i = 0; i < D; i++) text_add_name(&line, ",estimate", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",measured", i);
  text_add(&line, ",push_bits");
  for (int i = 0; i < D; i++) text_add_name(&line, ",y_bits", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",qdd_bits", i);
  for (int i = 0; i < N * D; i++) text_add_name(&line, ",qdd_y_bits", i);
  for (int i = 0; i < N; i++) text_add_name(&line, ",qdd_push_bits", i);
  text_end(&line);
}

/* A row; the plant is linearised for it, at its true state and the push that follows. */
static int write_row(int step, uint32_t instructions) {
  const controller *control = &machine.control;
  const tl_real *y = loop_state(&machine);
  plant_params params = machine.params;
  params.push = control->params.push;
  const int status = plant_linearise(&model, &params, y);
  text_add_count(&line, (uint32_t)step);
  text_add(&line, ",");
  text_add(&line, mode_names[control->mode]);
  text_add(&line, ",");
  text_add_decimal(&line, params.push);
  text_add(&line, ",");
  text_add_count(&line, instructions);
  text_add_decimals(&line, D, y);
  text_add_decimals(&line, D, control->y);
  text_add_decimals(&line, N, machine.measured);
  text_add_bits(&line, 1, &params.push);
  text_add_bits(&line, D, y);
  text_add_bits(&line, N, model.qdd);
  text_add_bits(&line, N * D, model.qdd_y);
  text_add_bits(&line, N, model.qdd_push);
  text_end(&line);
  return status;
}

static void write_result(const char *of, const char *name, uint32_t count) {
  text_add(&line, "# ");
  text_add(&line, of);
  text_add(&line, name);
  text_add(&line, " ");
  text_add_count(&line, count);
  text_end(&line);
}

/* Instructions of the longest control step of each mode. */
static uint32_t longest[CONTROL_MODES];

static int run(void) {
  int status = 0;
  for (int step = 0; step <= STEPS && status == 0; step++) {
    loop_sense(&machine);
    const uint32_t before = console_ticks();
    status = controller_step(&machine.control, machine.measured);
    const uint32_t instructions = console_instructions(before, console_ticks());
    if (instructions > longest[machine.control.mode]) longest[machine.control.mode] = instructions;
    if (status == 0 && step % ROW_EVERY == 0) status = write_row(step, instructions);
    if (status == 0) status = loop_move(&machine);
  }
  return status;
}

/* What goes wrong: the controller's machine has lost its mass; a sensor tells an angle so large that its sine means nothing; a sensor
 * tells no number. */
static void lose_mass(void) {
  plant_params *params = &machine.control.params;
  const tl_real push = params->push;
  *params = (plant_params){.push = push};
}

static void tell_too_much(void) { machine.measured[1] = (tl_real)INFINITY; }

static void tell_nothing(void) { machine.measured[1] = (tl_real)NAN; }

/* Something goes wrong for some control steps while the poles are held. */
static void run_fault(const char *name, void (*wrong)(void)) {
  const tl_real up[D] = {0};
  uint32_t told = 0;
  int first = 0;
  loop_init(&machine, leaning, 1);
  for (int step = 0; step < FAULT_STEPS; step++) {
    loop_sense(&machine);
    machine.control.params = machine.params;
    if (step >= FAULT_FROM && step < FAULT_TO) wrong();
    const int status = controller_step(&machine.control, machine.measured);
    if (status != 0 && told++ == 0) first = status;
    if (loop_move(&machine) != 0) break;
  }
  write_result(name, ", minus status", (uint32_t)-first);
  write_result(name, ", control steps with a status", told);
  write_result(name, ", the poles stand",
               machine.control.mode == CONTROL_HOLD && controller_within(loop_state(&machine), up, TL_C(0.2)));
}

int main(void) {
  loop_init(&machine, hanging, 1);
  write_names();
  const int status = run();
  for (int mode = 0; mode < CONTROL_MODES; mode++) {
    if (longest[mode] > 0) write_result(mode_names[mode], ", instructions of the longest", longest[mode]);
  }
  run_fault("without mass", lose_mass);
  run_fault("infinite angle", tell_too_much);
  run_fault("no number", tell_nothing);
  write_result("", "status", (uint32_t)status);
  return status;
}
