/* Foucault's pendulum at latitude B, x south, y east, z up, taut string. Terse. */
#include <math.h>
#define S2(a,b,c) ((a)*(a)+(b)*(b)+(c)*(c))
#define W 7.292115e-2 /* 1000 times the Earth's, to see something */
#define B .8527
#define l 3.2
#define m 28.

double L(const double*r,const double*v){double x=r[0],y=r[1],z=r[2],a,b,c,wx=-W*cos(B),wz=W*sin(B);
return a=v[0]-wz*y,b=v[1]+wz*x-wx*z,c=v[2]+wx*y,m*S2(a,b,c)/2-m*9.81*z;}

double f(const double*r){return S2(r[0],r[1],r[2])-l*l;}

void drag(const double*v,double*F){double s=sqrt(S2(v[0],v[1],v[2]));F[0]=-.02*s*v[0],F[1]=-.02*s*v[1],F[2]=-.02*s*v[2];}
