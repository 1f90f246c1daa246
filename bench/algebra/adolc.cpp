/* ADOL-C: the operation on a tape, and its forward mode along paths x + x_1 s + .. + x_d s^d. A jet along a curve is one path; a jet of
 * first order one path of first order for each variable; a complete shape T(v,m) the paths of degree m along all binomial(v+m-1, m)
 * directions from which tensor_eval would interpolate its coefficients. The interpolation is not done, nor timed. */
#include "contender.h"

#include <adolc/adolc.h>

#include <cmath>
#include <vector>

namespace {

const short tape_number = 1;

const algebra_task *task;
int degree, paths, inputs, outputs;
double x[2], y[2];
double ***in, ***out;           // inputs x paths x degree: the operands' coefficients from 1 up; outputs alike
double **in_first, **out_first; // inputs x paths
double *one_in[2], *one_out[2]; // of one path
std::vector<std::vector<double>> directions;

/* All multi-indices of order m: their number is that of paths. */
void list_directions(int nvar, int order) {
  directions.clear();
  const tl_shape *s = task->shape;
  for (int i = 0; i < s->ncoef; i++) {
    const int *e = task->exponents + i * (nvar + 1) + 1;
    int sum = 0;
    for (int v = 0; v < nvar; v++) sum += e[v];
    if (sum == order) directions.emplace_back(e, e + nvar);
  }
}

/* Coefficient k of the jet along a path. */
double along(const double *jet, int path, int k) {
  const tl_shape *s = task->shape;
  if (s->nvar == 0) return jet[k];
  double sum = 0.0;
  for (int i = 0; i < s->ncoef; i++) {
    const int *e = task->exponents + i * (s->nvar + 1) + 1;
    int order = 0;
    double term = jet[i];
    for (int v = 0; v < s->nvar; v++) {
      order += e[v];
      for (int j = 0; j < e[v]; j++) term *= directions[path][v];
    }
    if (order == k) sum += term;
  }
  return sum;
}

void tape() {
  adouble a, b, c[2];
  double value;
  trace_on(tape_number);
  a <<= task->a[0];
  if (inputs == 2) b <<= task->b[0];
  switch (task->operation) {
  case ALGEBRA_MUL:
    c[0] = a * b;
    break;
  case ALGEBRA_DIV:
    c[0] = a / b;
    break;
  case ALGEBRA_SQRT:
    c[0] = sqrt(a);
    break;
  case ALGEBRA_EXP:
    c[0] = exp(a);
    break;
  case ALGEBRA_SINCOS:
    c[0] = sin(a);
    c[1] = cos(a);
    break;
  default:
    c[0] = pow(a, ALGEBRA_EXPONENT);
  }
  for (int i = 0; i < outputs; i++) c[i] >>= value;
  trace_off();
}

void allocate() {
  if (in) myfree3(in), myfree3(out), myfree2(in_first), myfree2(out_first);
  in = myalloc3(inputs, paths, degree);
  out = myalloc3(outputs, paths, degree);
  in_first = myalloc2(inputs, paths);
  out_first = myalloc2(outputs, paths);
  for (int i = 0; i < inputs; i++) one_in[i] = in[i][0];
  for (int i = 0; i < outputs; i++) one_out[i] = out[i][0];
}

int prepare(const algebra_task *given) {
  const tl_shape *s = given->shape;
  if (s->curve > 0 && s->nvar > 0) return -1;
  task = given;
  inputs = task->b ? 2 : 1;
  outputs = task->operation == ALGEBRA_SINCOS ? 2 : 1;
  degree = s->degree;
  list_directions(s->nvar, degree);
  paths = s->nvar == 0 ? 1 : static_cast<int>(directions.size());
  allocate();
  for (int i = 0; i < inputs; i++) {
    const double *jet = i == 0 ? task->a : task->b;
    x[i] = jet[0];
    for (int p = 0; p < paths; p++) {
      for (int k = 1; k <= degree; k++) in[i][p][k - 1] = along(jet, p, k);
      in_first[i][p] = in[i][p][0];
    }
  }
  tape();
  return 0;
}

void run() {
  if (degree == 1)
    fov_forward(tape_number, outputs, inputs, paths, x, in_first, y, out_first);
  else if (paths == 1)
    hos_forward(tape_number, outputs, inputs, degree, 0, x, one_in, y, one_out);
  else
    hov_forward(tape_number, outputs, inputs, degree, paths, x, in, y, out);
}

double difference(const double *c) {
  double worst = 0.0, largest = 0.0;
  for (int i = 0; i < outputs; i++)
    for (int p = 0; p < paths; p++)
      for (int k = 1; k <= degree; k++) {
        const double ours = along(c + i * task->shape->ncoef, p, k), theirs = degree == 1 ? out_first[i][p] : out[i][p][k - 1];
        worst = std::fmax(worst, std::fabs(ours - theirs));
        largest = std::fmax(largest, std::fabs(ours));
      }
  return worst / largest;
}

} // namespace

int algebra_open(const char *, algebra_contender *contender) {
  *contender = {"ADOL-C", prepare, run, difference};
  return 0;
}
