/* Landau and Lifshitz, Mechanics, paragraph 5, problem 4: two masses m1 on four rods of length a, a sleeve m2 on the vertical axis; the
   whole turns with the angular velocity Omega. From the Lagrangian as printed; theta from the downward vertical. */

#include <math.h>

#define M1 0.5
#define M2 1.2
#define A 0.4
#define OMEGA 9.0
#define G 9.81

#define SIN2(x) (sin(x) * sin(x))
#define DOT(x) x##_dot
#define SQUARE(x) ((x) * (x))
#define KINETIC(theta) \
  (M1 * A * A * (SQUARE(DOT(theta)) + OMEGA * OMEGA * SIN2(theta)) + 2 * M2 * A * A * SIN2(theta) * SQUARE(DOT(theta)))
#define POTENTIAL(theta) (-2 * (M1 + M2) * G * A * cos(theta))
#define LAGRANGIAN(theta) (KINETIC(theta) - POTENTIAL(theta))

double governor(double theta, double theta_dot) { return LAGRANGIAN(theta); }
