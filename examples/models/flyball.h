/* The flyball governor of the IFToMM multibody benchmark (A05): two arms with balls at their ends turn with a shaft, and lift a slider
 * through spring-dampers so stiff that explicit methods need short steps. q = (psi, alpha1, alpha2, s): turn of the shaft, angles of the
 * arms below the horizontal, rad; height of the slider, m. */
#ifndef FLYBALL_H
#define FLYBALL_H

enum { FLYBALL_ARMS = 2, FLYBALL_COORDINATES = 4 };

typedef struct flyball {
  double arm_length, arm_mass, section;       /* m, kg, side of the square section of arms and shaft, m */
  double ball_mass;                           /* kg */
  double shaft_mass, slider_mass, slider_side; /* kg, kg, m */
  double hinge_radius, hinge_height;          /* m */
  double stiffness, damping, rest;            /* N/m, N s/m, m */
  double gravity;                             /* m/s^2 */
} flyball;

/* The benchmark's values and start: alpha = 30 degrees, s = 0.5 m, one turn per second. */
flyball flyball_parameters(void);
void flyball_start(double *q, double *qd);

double flyball_lagrangian(const double *q, const double *qd, const flyball *p);

/* out[i]: generalized force of the dampers on coordinate i. */
void flyball_dampers(const double *q, const double *qd, const flyball *p, double *out);

#endif
