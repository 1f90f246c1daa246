/* Prints the accelerations of a double pendulum that is let go. */
#include "double_pendulum.h"
#include "double_pendulum_tl.h"

#include <eom/eom.h>
#include <stdio.h>

int main(void) {
  const DoublePendulum bars = {{1.0, 1.0, 0.5, 1.0 / 12.0}, {1.0, 1.0, 0.5, 1.0 / 12.0}, 9.81};
  const double q[2] = {1.0, 0.5}, qd[2] = {0.0, 0.0};
  eom_system *sys;
  if (eom_system_create(&sys, &double_pendulum_model, &bars, NULL) != EOM_OK) return 1;
  const eom_status status = eom_acceleration(sys, q, qd, 0.0);
  for (int i = 0; status == EOM_OK && i < 2; i++) printf("qdd[%d] = %9.6f rad/s^2\n", i, sys->qdd[i]);
  eom_system_destroy(sys);
  return status == EOM_OK ? 0 : 1;
}
