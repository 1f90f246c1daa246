/* The tableau of the classical Runge-Kutta method: W. Kutta, Z. Math. Phys. 46 (1901).
 * The error weights are the only ones, up to a factor, whose estimate is of third order with the five slopes at hand. */
#include "eom/method.h"

// clang-format off
static const tl_real rk4_c[] = {
    TL_C(0.0), TL_C(0.5), TL_C(0.5), TL_C(1.0), TL_C(1.0)};
static const tl_real rk4_a[] = {
    /* 1 */ TL_C(0.5),
    /* 2 */ TL_C(0.0), TL_C(0.5),
    /* 3 */ TL_C(0.0), TL_C(0.0), TL_C(1.0),
    /* 4: b */ TL_C(1.0) / TL_C(6.0), TL_C(1.0) / TL_C(3.0), TL_C(1.0) / TL_C(3.0), TL_C(1.0) / TL_C(6.0)};
static const tl_real rk4_error[] = {
    TL_C(0.0), TL_C(0.0), TL_C(0.0), TL_C(0.1), TL_C(-0.1)};
// clang-format on

const eom_method eom_rk4 = {.name = "rk4",
                            .order = 4,
                            .stages = 4,
                            .error_rows = 1,
                            .error_power = 4,
                            .dense_order = 3,
                            .c = rk4_c,
                            .a = rk4_a,
                            .error = rk4_error};
