/* What wall.c gives to well.c. */
double wall(double x);
