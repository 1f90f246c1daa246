/* Reads the C that follows in quad precision: every double is a __float128, every function of math.h its quad counterpart. */
#ifndef TLGEN_QUAD_H
#define TLGEN_QUAD_H

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
extern __float128 floorq(__float128);
extern __float128 ceilq(__float128);
extern __float128 truncq(__float128);
extern __float128 roundq(__float128);
extern __float128 rintq(__float128);
extern __float128 nearbyintq(__float128);
extern __float128 erfcq(__float128);
extern __float128 tgammaq(__float128);
extern __float128 lgammaq(__float128);
extern __float128 fmodq(__float128, __float128);
extern __float128 remainderq(__float128, __float128);
extern __float128 fdimq(__float128, __float128);
extern __float128 ldexpq(__float128, int);
extern __float128 scalbnq(__float128, int);
extern long lroundq(__float128);
extern int isnanq(__float128);
extern int finiteq(__float128);
extern int signbitq(__float128);

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
#define floor floorq
#define ceil ceilq
#define trunc truncq
#define round roundq
#define rint rintq
#define nearbyint nearbyintq
#define erfc erfcq
#define tgamma tgammaq
#define lgamma lgammaq
#define fmod fmodq
#define remainder remainderq
#define fdim fdimq
#define ldexp ldexpq
#define scalbn scalbnq
#define lround lroundq
#undef isnan
#define isnan isnanq
#undef isfinite
#define isfinite finiteq
#undef signbit
#define signbit signbitq

/* Single precision that depends on the coordinates: the exact derivatives are those without its rounding. */
#ifdef TLGEN_QUAD_SINGLE
#define float __float128
#define sqrtf sqrtq
#define cbrtf cbrtq
#define expf expq
#define expm1f expm1q
#define exp2f exp2q
#define logf logq
#define log1pf log1pq
#define log2f log2q
#define log10f log10q
#define sinf sinq
#define cosf cosq
#define tanf tanq
#define asinf asinq
#define acosf acosq
#define atanf atanq
#define sinhf sinhq
#define coshf coshq
#define tanhf tanhq
#define asinhf asinhq
#define acoshf acoshq
#define atanhf atanhq
#define erff erfq
#define fabsf fabsq
#define atan2f atan2q
#define powf powq
#define hypotf hypotq
#define fminf fminq
#define fmaxf fmaxq
#define copysignf copysignq
#define fmaf fmaq
#define floorf floorq
#define ceilf ceilq
#define truncf truncq
#define roundf roundq
#define rintf rintq
#define nearbyintf nearbyintq
#define erfcf erfcq
#define tgammaf tgammaq
#define lgammaf lgammaq
#define fmodf fmodq
#define remainderf remainderq
#define fdimf fdimq
#define ldexpf ldexpq
#define scalbnf scalbnq
#endif

#endif
