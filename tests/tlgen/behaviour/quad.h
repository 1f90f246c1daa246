/* Reads the C that follows in quad precision: every double is a __float128, every function of math.h its quad counterpart. */
#ifndef TEST_QUAD_H
#define TEST_QUAD_H

extern __float128 sqrtq(__float128);
extern __float128 cbrtq(__float128);
extern __float128 expq(__float128);
extern __float128 expm1q(__float128);
extern __float128 exp2q(__float128);
extern __float128 logq(__float128);
extern __float128 log1pq(__float128);
extern __float128 log2q(__float128);
extern __float128 log10q(__float128);
extern __float128 sinq(__float128);
extern __float128 cosq(__float128);
extern __float128 tanq(__float128);
extern __float128 asinq(__float128);
extern __float128 acosq(__float128);
extern __float128 atanq(__float128);
extern __float128 sinhq(__float128);
extern __float128 coshq(__float128);
extern __float128 tanhq(__float128);
extern __float128 asinhq(__float128);
extern __float128 acoshq(__float128);
extern __float128 atanhq(__float128);
extern __float128 erfq(__float128);
extern __float128 fabsq(__float128);
extern __float128 atan2q(__float128, __float128);
extern __float128 powq(__float128, __float128);
extern __float128 hypotq(__float128, __float128);
extern __float128 fminq(__float128, __float128);
extern __float128 fmaxq(__float128, __float128);
extern __float128 copysignq(__float128, __float128);
extern __float128 fmaq(__float128, __float128, __float128);

#define double __float128
#define sqrt sqrtq
#define cbrt cbrtq
#define exp expq
#define expm1 expm1q
#define exp2 exp2q
#define log logq
#define log1p log1pq
#define log2 log2q
#define log10 log10q
#define sin sinq
#define cos cosq
#define tan tanq
#define asin asinq
#define acos acosq
#define atan atanq
#define sinh sinhq
#define cosh coshq
#define tanh tanhq
#define asinh asinhq
#define acosh acoshq
#define atanh atanhq
#define erf erfq
#define fabs fabsq
#define atan2 atan2q
#define pow powq
#define hypot hypotq
#define fmin fminq
#define fmax fmaxq
#define copysign copysignq
#define fma fmaq

#endif
