/* Fewer coordinates passed one by one than the model has. */
/* tlgen: --lagrangian L --dof 3 --arg q=x,y */
double L(double x, double y) { return x * y; } /* expect: bad-dof */
