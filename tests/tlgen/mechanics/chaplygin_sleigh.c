/*
 * @file   chaplygin_sleigh.c
 * @brief  Chaplygin sleigh on a magnetised, slowly tilting table. Follows MISRA C:2012: fixed-width types, single exit, no side
 *         effects in expressions, explicit precedence.
 */
#include <math.h>
#include <stdint.h>

typedef double float64_t;

#define SLEIGH_IDX_X      (0U)
#define SLEIGH_IDX_Y      (1U)
#define SLEIGH_IDX_THETA  (2U)
#define SLEIGH_NUM_COORD  (3U)

typedef struct
{
    float64_t f64Mass_kg;
    float64_t f64Inertia_kgm2;
    float64_t f64Offset_m;
    float64_t f64Gravity_mps2;
    float64_t f64TiltRate_radps;
    float64_t af64Damping[SLEIGH_NUM_COORD];
} Sleigh_Config_t;

static const Sleigh_Config_t Sleigh_Config =
{
    2.0,
    0.15,
    0.25,
    9.81,
    0.02,
    { 0.3, 0.3, 0.05 }
};

/* LDRA: function has one point of exit */
static float64_t Sleigh_Square(const float64_t f64Value)
{
    const float64_t f64Result = (f64Value * f64Value);
    return f64Result;
}

float64_t Sleigh_Lagrangian(const float64_t *q, const float64_t *qd, float64_t t, const Sleigh_Config_t * const p)
{
    float64_t f64Kinetic;
    float64_t f64Potential;
    const float64_t f64Sin = sin(q[SLEIGH_IDX_THETA]);
    const float64_t f64Cos = cos(q[SLEIGH_IDX_THETA]);
    const float64_t f64VelX = qd[SLEIGH_IDX_X] - ((p->f64Offset_m * qd[SLEIGH_IDX_THETA]) * f64Sin);
    const float64_t f64VelY = qd[SLEIGH_IDX_Y] + ((p->f64Offset_m * qd[SLEIGH_IDX_THETA]) * f64Cos);

    f64Kinetic = (0.5 * p->f64Mass_kg) * (Sleigh_Square(f64VelX) + Sleigh_Square(f64VelY));
    f64Kinetic += (0.5 * p->f64Inertia_kgm2) * Sleigh_Square(qd[SLEIGH_IDX_THETA]);
    f64Potential = ((p->f64Mass_kg * p->f64Gravity_mps2) * sin(p->f64TiltRate_radps * t))
                   * (q[SLEIGH_IDX_X] + (p->f64Offset_m * f64Cos));

    return (f64Kinetic - f64Potential);
}

float64_t Sleigh_Slip(const float64_t *q, const float64_t *qd)
{
    const float64_t f64Slip = (qd[SLEIGH_IDX_Y] * cos(q[SLEIGH_IDX_THETA])) - (qd[SLEIGH_IDX_X] * sin(q[SLEIGH_IDX_THETA]));
    return f64Slip;
}

void Sleigh_Damping(const float64_t *qd, const Sleigh_Config_t * const p, float64_t *out)
{
    uint8_t u8Index;

    for (u8Index = 0U; u8Index < (uint8_t)SLEIGH_NUM_COORD; u8Index++)
    {
        out[u8Index] = -(p->af64Damping[u8Index] * qd[u8Index]);
    }
}
