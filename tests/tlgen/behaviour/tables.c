/* Constant tables: of numbers, structs and rows, with gaps, in functions and beside them, looked up by integers, enums and characters. */
#include <math.h>

#define COUNT(a) (int)(sizeof(a) / sizeof((a)[0]))
#define SQUARE(x) ((x) * (x))

enum axis { X, Y, Z, AXES };
enum sign { MINUS = -1, PLUS = 1 };

typedef struct { double gain, phase; } term;

static const double ladder[] = {1.0, -0.5, 1.0 / 3, 1e-1, 0x1.8p0, .5, 2e0};
static const term terms[AXES] = {[Z] = {0.75, 0.25}, [X] = {.phase = 0.5}};
static const double sparse[4][2] = {[1] = {1.0, 2.0}, [3] = {[1] = -1.5}};
static const struct row { enum axis axis; term t[2]; char letter; } rows[2] = {{Y, {{1.0, 2.0}, {3.0, 4.0}}, 'b'}, {.axis = X, .t[1].phase = 5.0}};
static const int order[AXES] = {Z, X, Y};
static const double scale = 0.125, offset = -0.125;

static double horner(const double *c, int n, double x)
{
  double y = 0.0;
  while (n-- > 0) y = y * x + c[n];
  return y;
}

static double series(double x)
{
  static const double local[2][3] = {{1.0, 2.0}, {[2] = 3.0}};
  static const term gap[3] = {[1] = {4.0, 5.0}};
  double plain[3][2] = {[2] = {0.5, 1.5}};
  const term mine[3] = {[2] = {1.0, -1.0}};
  double s = 0.0;
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 3; j++) s += local[i][j] * x + plain[j][i] * x * x;
  for (int i = 0; i < 3; i++) s += gap[i].gain * gap[i].phase * x + mine[i].gain - x * mine[i].phase * (i + 1);
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double L = horner(ladder, COUNT(ladder), q[0]) + horner(ladder + 2, 3, t) + horner(ladder, 3, scale);
  enum axis a = q[0] > 0.0 ? X : Z;

  for (int i = 0; i < AXES; i++) L += terms[order[i]].gain * sin(q[1] + terms[i].phase * qd[0]);
  for (int i = 0; i < 8; i++) L += sparse[i / 2][i % 2] * pow(qd[1], i);
  L += rows[0].t[1].gain * q[0] + rows[1].t[1].phase * qd[1] + rows[0].axis * t + rows[rows[0].letter - 'a'].t[0].gain * t;
  L += terms[a].phase * SQUARE(q[1] + t) + ladder['c' - 'a'] * qd[0] + MINUS * q[0] + (ladder + 2)[MINUS] * q[1];
  return L + series(q[1]) + offset * series(t) + series(2.0);
}
