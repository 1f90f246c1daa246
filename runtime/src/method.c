/* The explicit Runge-Kutta methods by name. */
#include "eom/method.h"

#include <string.h>

const eom_method *eom_method_find(const char *name) {
  static const eom_method *const all[] = {&eom_rk4, &eom_dp5, &eom_dop853};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
    if (strcmp(all[i]->name, name) == 0) return all[i];
  return NULL;
}
