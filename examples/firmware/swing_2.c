/* Two poles: along the motion of reference.h, as push = its push - K (y - its y). K is best for the machine as it is linearised now and
 * the cost of all later steps, which is stored. The motion begins where the poles hang still: they are brought
 * there first, and again where they have been lost on the way. */
#include "matrix.h"
#include "reference.h"
#include "swing.h"

static const tl_real PI = TL_C(3.14159265358979323846);

static int hangs_still(const tl_real *y, const tl_real *hanging) {
  tl_real e[D];
  controller_away(e, y, hanging);
  for (int i = 0; i < D; i++)
    if (!(matrix_size(e[i]) < (i < N ? TL_C(0.05) : TL_C(0.2)))) return 0;
  return 1;
}

control_mode swing_choose(controller *c) {
  const tl_real up[D] = {0}, hanging[D] = {TL_C(0.0), PI, PI};
  tl_real target[D], push;
  if (c->mode == CONTROL_SWING && c->swung < REFERENCE_STEPS) {
    reference_motion(c->swung, target, &push);
    return controller_within(c->y, target, TL_C(0.8)) ? CONTROL_SWING : CONTROL_REST;
  }
  if (controller_within(c->y, up, TL_C(0.3))) return CONTROL_HOLD;
  if (!hangs_still(c->y, hanging)) return CONTROL_REST;
  c->swung = 0;
  return CONTROL_SWING;
}

/* Far from hanging the cart is on a spring with a damper, which takes energy out of the poles wherever they are; near it, regulated. */
static int come_to_rest(controller *c, tl_real *push) {
  const tl_real hanging[D] = {TL_C(0.0), PI, PI};
  if (controller_within(c->y, hanging, TL_C(0.5))) return controller_regulate(c, hanging, push);
  *push = TL_C(-10.0) * c->y[0] - TL_C(6.0) * c->y[N];
  return 0;
}

int swing_push(controller *c, tl_real *push) {
  if (c->mode == CONTROL_REST) return come_to_rest(c, push);
  tl_real target[D], e[D];
  reference_motion(c->swung, target, push);
  reference_cost(c->swung + 1, c->work.H);
  c->swung++;
  if (!riccati_gain_of(c->K, c->work.H, c->A, c->B, CONTROL_WEIGHT_PUSH)) return EOM_MOTION_PIVOT;
  controller_away(e, c->y, target);
  *push -= matrix_dot(D, c->K, e, 1);
  return 0;
}
