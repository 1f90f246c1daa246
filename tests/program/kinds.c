/* Parameters of every kind, one of them with the name of the coordinates; two named coordinates on springs. */
struct spring {
  double stiffness;
  float rest[2];
};

struct kinds {
  struct spring spring[2];
  int steps;
  int selected; /* of offset */
  _Bool loaded;
  unsigned short code;
  signed char sign;
  long long big;
  double table[2][3];
  double offset[3];
  double q;
  const char *label; /* for people */
};

double lagrangian(double x, double y, double xd, double yd, const struct kinds *p) {
  double lx = x - p->spring[0].rest[0], ly = y - p->spring[1].rest[1];
  return 0.5 * p->q * (xd * xd + yd * yd) - 0.5 * (p->spring[0].stiffness * lx * lx + p->spring[1].stiffness * ly * ly) +
         p->table[1][2] * p->steps * x + p->offset[p->selected];
}
