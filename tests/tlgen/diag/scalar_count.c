/* Fewer coordinates passed one by one than the model has, and fewer velocities. */
/* tlgen: --lagrangian L --dof 3 --arg q=x,y --nonholonomic edge --arg qd=vx,vy,w */
double L(double x, double y) { return x * y; } /* expect: scalar-count */
double edge(double vx, double vy) { return vx + vy; } /* expect: scalar-count */
