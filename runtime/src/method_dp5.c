/* The tableau of J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980).
 * The row for dense output is L. F. Shampine's, Math. Comp. 46 (1986), in the form of E. Hairer's program DOPRI5. */
#include "eom/method.h"

// clang-format off
static const tl_real dp5_c[] = {
    TL_C(0.0), TL_C(0.2), TL_C(0.3), TL_C(0.8), TL_C(8.0) / TL_C(9.0), TL_C(1.0), TL_C(1.0)};
static const tl_real dp5_a[] = {
    /* 1 */ TL_C(1.0) / TL_C(5.0),
    /* 2 */ TL_C(3.0) / TL_C(40.0), TL_C(9.0) / TL_C(40.0),
    /* 3 */ TL_C(44.0) / TL_C(45.0), TL_C(-56.0) / TL_C(15.0), TL_C(32.0) / TL_C(9.0),
    /* 4 */ TL_C(19372.0) / TL_C(6561.0), TL_C(-25360.0) / TL_C(2187.0), TL_C(64448.0) / TL_C(6561.0), TL_C(-212.0) / TL_C(729.0),
    /* 5 */ TL_C(9017.0) / TL_C(3168.0), TL_C(-355.0) / TL_C(33.0), TL_C(46732.0) / TL_C(5247.0), TL_C(49.0) / TL_C(176.0),
    TL_C(-5103.0) / TL_C(18656.0),
    /* 6: b */ TL_C(35.0) / TL_C(384.0), TL_C(0.0), TL_C(500.0) / TL_C(1113.0), TL_C(125.0) / TL_C(192.0),
    TL_C(-2187.0) / TL_C(6784.0), TL_C(11.0) / TL_C(84.0)};
static const tl_real dp5_error[] = {
    TL_C(71.0) / TL_C(57600.0), TL_C(0.0), TL_C(-71.0) / TL_C(16695.0), TL_C(71.0) / TL_C(1920.0), TL_C(-17253.0) / TL_C(339200.0),
    TL_C(22.0) / TL_C(525.0), TL_C(-1.0) / TL_C(40.0)};
static const tl_real dp5_dense[] = {
    TL_C(-12715105075.0) / TL_C(11282082432.0), TL_C(0.0), TL_C(87487479700.0) / TL_C(32700410799.0),
    TL_C(-10690763975.0) / TL_C(1880347072.0), TL_C(701980252875.0) / TL_C(199316789632.0), TL_C(-1453857185.0) / TL_C(822651844.0),
    TL_C(69997945.0) / TL_C(29380423.0)};
// clang-format on

const eom_method eom_dp5 = {.name = "dp5",
                            .order = 5,
                            .stages = 6,
                            .error_rows = 1,
                            .error_power = 5,
                            .dense_order = 4,
                            .dense_rows = 1,
                            .c = dp5_c,
                            .a = dp5_a,
                            .error = dp5_error,
                            .dense = dp5_dense};
