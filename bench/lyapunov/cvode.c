/* The spectrum by SUNDIALS' CVODE (Adams, functional iteration) with any contender's Jacobian: a rival's generated code.
 * Built with -DLINKS=n; the environment's JACOBIAN names the shared object (bench/contender.h). Steps are chosen by the error of y
 * alone, as in hand.c: a weight of nearly 0 leaves the tangents out of CVODE's norm. */
#include "contender.h"
#include "spectrum.h"

#include <cvode/cvode.h>
#include <dlfcn.h>
#include <nvector/nvector_serial.h>
#include <string.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

enum { SIZE = D + D * D };

static const double INTERVAL = 1.0; /* s, between two QR, each of which restarts CVODE at order 1: the fastest of 0.2, 0.5, 1 and 2 s */

static bench_contender contender;

/* (y, P)' */
static int flow(double t, N_Vector state, N_Vector slope, void *user) {
  const double *z = N_VGetArrayPointer(state);
  double *zdot = N_VGetArrayPointer(slope);
  _Alignas(64) double q[D], qdd[D], qdd_y[4 * D * D];
  (void)t, (void)user;
  memcpy(q, z, sizeof q);
  memcpy(zdot, z + LINKS, LINKS * sizeof *z);
  if (contender.jacobian(contender.self, q, q + LINKS, qdd, qdd_y) != 0) return 1;
  memcpy(zdot + LINKS, qdd, LINKS * sizeof *z);
  spectrum_tangents(qdd_y, z + D, zdot + D);
  return 0;
}

static double tolerance_now;

/* Weights of CVODE's norm, the root of the mean square over all unknowns: the mean is to be one over y. */
static int weigh(N_Vector state, N_Vector weight, void *user) {
  const double *z = N_VGetArrayPointer(state);
  double *w = N_VGetArrayPointer(weight);
  (void)user;
  for (int i = 0; i < D; i++) w[i] = sqrt((double)SIZE / D) / (tolerance_now * (1.0 + fabs(z[i])));
  for (int i = D; i < SIZE; i++) w[i] = 1e-30;
  return 0;
}

static int open_jacobian(void) {
  static double ones[LINKS];
  const char *path = getenv("JACOBIAN");
  void *object = path ? dlopen(path, RTLD_NOW) : NULL;
  int (*open)(const bench_case *, bench_contender *) = NULL;
  if (object) *(void **)&open = dlsym(object, "bench_open");
  for (int i = 0; i < LINKS; i++) ones[i] = 1.0;
  static bench_case links = {"pendulum", LINKS, 9.81, ones, ones};
  if (open && open(&links, &contender) == 0 && contender.jacobian) return 0;
  fprintf(stderr, "cvode: no Jacobian: %s\n", object ? path : dlerror());
  return 1;
}

static int spectrum_run(double t_end, double tolerance, spectrum *result) {
  if (!contender.jacobian && open_jacobian() != 0) return 1;
  SUNContext context;
  if (SUNContext_Create(NULL, &context) != 0) return 1;
  N_Vector state = N_VNew_Serial(SIZE, context);
  double *z = N_VGetArrayPointer(state);
  memset(z, 0, SIZE * sizeof *z);
  spectrum_start(z);
  for (int i = 0; i < D; i++) z[D + i * D + i] = 1.0;
  tolerance_now = tolerance;
  void *cvode = CVodeCreate(CV_ADAMS, context);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(state, 0, context);
  int failed = CVodeInit(cvode, flow, 0.0, state) || CVodeWFtolerances(cvode, weigh) || CVodeSetNonlinearSolver(cvode, iteration) ||
               CVodeSetMaxNumSteps(cvode, -1);
  const long periods = lround(t_end / INTERVAL);
  for (long i = 1; i <= periods && !failed; i++) {
    double t;
    failed = CVodeSetStopTime(cvode, (double)i * INTERVAL) || CVode(cvode, (double)i * INTERVAL, state, &t, CV_NORMAL) < 0;
    spectrum_orthonormalise(z + D, result->rho);
    spectrum_check(result, z);
    long steps;
    failed = failed || CVodeGetNumSteps(cvode, &steps);
    result->steps += steps;
    result->t = t;
    failed = failed || CVodeReInit(cvode, t, state);
  }
  CVodeFree(&cvode);
  SUNNonlinSolFree(iteration);
  N_VDestroy(state);
  SUNContext_Free(&context);
  return failed;
}
