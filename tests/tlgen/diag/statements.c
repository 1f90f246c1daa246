/* What is refused where it stands, all of it in one run. */
double L(const double *q)
{
  double s = 0.0;
  int i = 0;
again:
  s += q[i];
  if (++i < 2) goto again;                 /* expect: goto */
  switch (i) {
  case 0: s += 1.0; break;
  default: if (s > 0) { case 1: s += 2.0; } /* expect: switch */
  }
  __asm__("nop");                          /* expect: asm */
  s += _Generic(s, double: 1.0, int: 2.0); /* expect: unsupported */
  s += "text"[0];                          /* expect: unsupported */
  return s;
}
