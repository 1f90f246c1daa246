/* Single precision in between. */
static float low(float x) { return x * 2.0f; } /* expect: float-active */
struct f { float x; };
double L(const double *q)
{
  float a = (float)q[0];     /* expect: float-active */
  float b = 0.5f;
  struct f c;
  c.x = (float)q[0];         /* expect: float-active */
  return low((float)q[0]) +  /* expect: float-active */
         a + c.x + b;        /* expect: float-active */
}
