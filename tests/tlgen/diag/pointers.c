/* Pointers to pointers to active numbers. */
static void next(const double **p) { ++*p; }                        /* expect: pointer-to-pointer */
double L(const double *q)
{
  const double *p = q, **pp = &p; /* expect: pointer-to-pointer */
  next(&p);
  return **pp; /* expect: pointer-to-pointer */
}
