/* The closed loop from several starts, with several seeds of the sensors' noise and with a machine that is not quite the one that the
 * controller thinks of: the poles must stand at the end of each. Prints a line for each. With -DSTARTS_SOME only some of them: an
 * emulated board takes seconds for one. */
#include "console.h"
#include "loop.h"
#include "text.h"

#ifdef STARTS_SOME
enum { STANDING = 500 /* control steps */, SEEDS = 1, EACH = 4 };
#else
enum { STANDING = 500, SEEDS = 2, EACH = 1 };
#endif

typedef struct start {
  const char *name;
  double angle[2], position, speed; /* of poles from hanging, rad; of the cart, m and m/s */
  double mass, length;              /* the poles', in parts of what the controller thinks */
  int seconds;                      /* until the poles must have come to stand */
} start;

static const start starts[] = {
    {"hangs", {0.02, 0.0}, 0.0, 0.0, 1.0, 1.0, 4},
    {"aside, one way", {0.05, -0.1}, 0.0, 0.0, 1.0, 1.0, 4},
    {"aside, other way", {-0.1, 0.05}, 0.0, 0.0, 1.0, 1.0, 4},
    {"off the centre", {0.02, 0.0}, 0.1, -0.1, 1.0, 1.0, 4},
    {"5 % more mass", {0.02, 0.0}, 0.0, 0.0, 1.05, 1.0, 4},
    {"5 % less mass", {0.02, 0.0}, 0.0, 0.0, 0.95, 1.0, 4},
    {"10 % more mass", {0.02, 0.0}, 0.0, 0.0, 1.10, 1.0, 4},
    {"10 % less mass", {0.02, 0.0}, 0.0, 0.0, 0.90, 1.0, 4},
    {"1 % longer", {0.02, 0.0}, 0.0, 0.0, 1.0, 1.01, 4},
    {"1 % shorter", {0.02, 0.0}, 0.0, 0.0, 1.0, 0.99, 4},
    {"2 % longer", {0.02, 0.0}, 0.0, 0.0, 1.0, 1.02, 4},
    {"2 % shorter", {0.02, 0.0}, 0.0, 0.0, 1.0, 0.98, 4},
    {"anywhere", {1.0, -0.5}, 0.3, 0.5, 1.0, 1.0, 12},
};

static void scale(plant_params *params, const start *s) {
#if PLANT_POLES == 1
  params->pole_mass *= (tl_real)s->mass;
  params->pole_length *= (tl_real)s->length;
#else
  for (int i = 0; i < 2; i++) params->pole_mass[i] *= (tl_real)s->mass, params->pole_length[i] *= (tl_real)s->length;
#endif
}

/* Control steps until the poles have come to stand for good; -1 where they have not. */
static int run(loop *l, const start *s, uint32_t seed) {
  const tl_real up[D] = {0};
  tl_real y[D] = {(tl_real)s->position, TL_C(3.14159265), TL_C(3.14159265)};
  int since = 0;
  for (int i = 1; i < N; i++) y[i] = TL_C(3.14159265) + (tl_real)s->angle[i - 1];
  for (int i = N; i < D; i++) y[i] = i == N ? (tl_real)s->speed : TL_C(0.0);
  loop_init(l, y, seed);
  scale(&l->params, s);
  for (int step = 0; step < 1000 * s->seconds; step++) {
    loop_sense(l);
    if (controller_step(&l->control, l->measured) != 0 || loop_move(l) != 0) return -1;
    if (!controller_within(loop_state(l), up, TL_C(0.1))) since = step;
  }
  return since + STANDING < 1000 * s->seconds ? since : -1;
}

int main(void) {
  static loop l;
  int fallen = 0;
  for (size_t i = 1 % EACH; i < sizeof starts / sizeof *starts; i += EACH)
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
      const int steps = run(&l, starts + i, seed);
      text line = {.length = 0};
      text_add(&line, starts[i].name);
      text_add_name(&line, ", seed ", (int)seed);
      if (steps < 0) {
        text_add(&line, ": not up");
      } else {
        text_add_name(&line, ": up, ms ", steps);
        text_add_bits(&line, D, loop_state(&l));
      }
      text_end(&line);
      fallen += steps < 0;
    }
  return fallen > 0;
}
