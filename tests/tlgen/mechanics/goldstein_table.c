/* Goldstein, Classical Mechanics, exercise of chapter 1: two masses on a string through a hole in a smooth table; here m2 below is free
to swing. y[1..4] are r and phi of m1, theta and psi of m2; the string has the length ell. In the Numerical Recipes' way: all starts
at 1. */

#include <math.h>

#define NVAR 4
static const float onehalf=0.5f;

static double dsqr(double a)
{
	return (a == 0.0 ? 0.0 : a*a);
}

static void hanging(double y[],double yp[],double ell,double *speed2,double *depth)
/* Returns the squared speed of the mass at the end of the free string of length ell-y[1], and its depth below the table. */
{
	double s=ell-y[1];

	*speed2=dsqr(yp[1])+dsqr(s*yp[3])+dsqr(s*sin(y[3])*yp[4]);
	*depth=s*cos(y[3]);
}

double table(const double q[],const double qd[])
{
	double y[NVAR+1],yp[NVAR+1];
	double m1=1.1,m2=0.7,ell=1.6,g=9.81,speed2,depth,kin;
	const double *qq=q-1,*qqd=qd-1;
	int i;

	for (i=1;i<=NVAR;i++) {
		y[i]=qq[i];
		yp[i]=qqd[i];
	}
	hanging(y,yp,ell,&speed2,&depth);
	kin=onehalf*m1*(dsqr(yp[1])+dsqr(y[1]*yp[2]));
	kin += onehalf*m2*speed2;
	return kin+m2*g*depth;
}
