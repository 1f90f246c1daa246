/* Parameters of the blade. */
#ifndef TEST_BLADE_H
#define TEST_BLADE_H

typedef struct blade {
  double mass, inertia; /* kg, kg m^2 */
} blade;

#endif
