/* Types and constants of the generated snakeboard functions. */
#ifndef RTW_HEADER_snakeboard_h_
#define RTW_HEADER_snakeboard_h_

typedef double real_T;

#define SB_M     (6.0)
#define SB_J     (0.016)
#define SB_JR    (0.072)
#define SB_JW    (0.0013)
#define SB_LEN   (0.2)
#define SB_SLOPE (0.05)
#define SB_KP    (2.5)
#define SB_KD    (0.4)
#define SB_AMP   (0.7)
#define SB_FREQ  (3.0)

extern real_T snakeboard_L(const real_T q[6], const real_T qd[6]);
extern void snakeboard_psi(const real_T q[6], const real_T qd[6], real_T out[2]);
extern void snakeboard_tau(const real_T q[6], const real_T qd[6], real_T t, real_T out[6]);

#endif
