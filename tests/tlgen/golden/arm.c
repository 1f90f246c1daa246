/* Parameters of all sorts, with comments beside them, and coordinates that are arguments one by one. */
#include <math.h>

struct link {
  double mass;   /**< kg, of a "rod"
                  * that is uniform */
  float at[2];   // m, its ends
};

struct arm {
  struct link link[2], tool; /* from the wall on */
  int stages;                /* of the gear */
  _Bool loaded;
  unsigned short code;       /* \ on its plate */
  double table[2][3];
  const char *label;         /* for people */
  double (*law)(double);
};

double lagrangian(double x, double theta, double xd, double thetad, const struct arm *p)
{
  return 0.5 * p->link[0].mass * xd * xd + p->tool.mass * thetad * thetad - p->stages * cos(theta) - x;
}
