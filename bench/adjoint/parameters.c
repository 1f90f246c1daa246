/* The parameter struct of -DMODEL for the contender "adjoint": apart from the generated source, which has the struct's layout for
 * itself. */
#include "parameters.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

void *adjoint_parameters(const bench_case *problem);

void *adjoint_parameters(const bench_case *problem) {
  static struct MODEL p;
  p = JOIN(MODEL, _parameters)(problem);
  return &p;
}
