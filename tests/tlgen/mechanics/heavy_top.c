/* Heavy symmetric top, one point fixed, Euler angles phi theta psi (z x z). Scalars in, scalar out, all in one breath. */
#include <math.h>
#define SQ(x) ((x)*(x))
static const double A = 0.0042, C = 0.0017, mgl = 0.31;   /* transverse and axial moments about the tip, weight times arm */
double L(double phi, double th, double psi, double phid, double thd, double psid)
{ double s=sin(th), c=cos(th), w1=phid*s, w3=psid+phid*c; (void)phi, (void)psi; return A*(SQ(thd)+SQ(w1))/2 + C*SQ(w3)/2 - mgl*c; }
