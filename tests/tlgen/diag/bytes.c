/* Bytes of numbers that depend on q. */
typedef unsigned char byte;
static int top_bit(const double *x) { return ((const byte *)x)[7] >> 7; } /* expect: pointer-cast */
static void flip(void *x) { ((char *)x)[7] ^= 0x80; } /* expect: pointer-cast type */
static void copy(char *to, const char *from, int n)
{
  while (n-- > 0) *to++ = *from++;
}
double L(const double *q)
{
  double x = q[0], y = 0.0;
  const signed char *bytes = (const signed char *)&x; /* expect: pointer-cast */
  copy((char *)&y, (const char *)q, 8); /* expect: pointer-cast */
  flip(&x); /* expect: pointer-cast */
  return x + y + bytes[0] + top_bit(q);
}
