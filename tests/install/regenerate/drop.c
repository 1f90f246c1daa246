/* Prints the acceleration of the model. */
#include "fall_tl.h"
#include <eom/eom.h>
#include <stdio.h>

int main(void) {
  const tl_real q = TL_C(1.0), qd = TL_C(0.0);
  eom_system *sys;
  if (eom_system_create(&sys, &fall_model, NULL, NULL) != EOM_OK) return 1;
  const eom_status status = eom_acceleration(sys, &q, &qd, TL_C(0.0));
  printf("%g\n", (double)sys->qdd[0]);
  eom_system_destroy(sys);
  return status == EOM_OK ? 0 : 1;
}
