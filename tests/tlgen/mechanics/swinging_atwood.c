/* Swinging Atwood's machine with pulleys of finite size, in the layout of the GNU coding standards and with scalar arguments.  */

#include <math.h>

static const double swing_mass = 0.8, counter_mass = 1.9;
static const double pulley_radius = 0.05, pulley_inertia = 4.0e-4;
static const double gravity = 9.81;

/* Speed of the string, from the free length R, and from the angle
   THETA at which it leaves the pulley.  */

static double
string_speed (double rdot, double thetadot)
{
  return rdot - pulley_radius * thetadot;
}

/* Height of the swinging mass over the pulley's centre.  */

static double
swing_height (double r, double theta)
{
  return pulley_radius * sin (theta) - r * cos (theta);
}

double
atwood_lagrangian (double r, double theta, double rdot, double thetadot)
{
  double v = string_speed (rdot, thetadot);
  double along_string, across_string, potential;

  along_string = (counter_mass + swing_mass
                  + 2 * pulley_inertia / (pulley_radius * pulley_radius))
                 * v * v / 2;
  across_string = swing_mass * (r * thetadot) * (r * thetadot) / 2;
  potential = swing_mass * gravity * swing_height (r, theta)
              + counter_mass * gravity * (r - pulley_radius * theta);

  return along_string + across_string - potential;
}
