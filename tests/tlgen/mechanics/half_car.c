/**
 * @brief Half-car ride model: heave, pitch, front and rear axle hop. Force elements are table driven; each has a kind.
 *
 * Coordinates: z [m], pitch [rad, nose up], z_front, z_rear [m], from the height without load.
 */
#include <math.h>

typedef enum { SPRING_LINEAR, SPRING_PROGRESSIVE, BUMP_STOP, DAMPER_CUBIC, DAMPER_BLOWOFF } element_kind_t;
typedef enum { BODY_FRONT, BODY_REAR, AXLE_FRONT, AXLE_REAR, ROAD_FRONT, ROAD_REAR, MARKERS } marker_t;

typedef struct {
    element_kind_t kind;
    marker_t upper, lower;
    double c[3];
} element_t;

typedef struct {
    double m_body, j_body, m_axle[2];
    double arm[2]; /* ahead of the centre of mass, behind it */
    double speed, wheel_base;
    int n_elements;
    const element_t *element;
} half_car_t;

static const element_t elements[] = {
    { SPRING_PROGRESSIVE, BODY_FRONT, AXLE_FRONT, { 18000.0, 2.0e5, 0.0 } },
    { SPRING_LINEAR,      BODY_REAR,  AXLE_REAR,  { 22000.0, 0.0, 0.0 } },
    { BUMP_STOP,          BODY_FRONT, AXLE_FRONT, { 4.0e6, 0.05, 0.0 } },
    { BUMP_STOP,          BODY_REAR,  AXLE_REAR,  { 4.0e6, 0.06, 0.0 } },
    { DAMPER_CUBIC,       BODY_FRONT, AXLE_FRONT, { 900.0, 350.0, 0.0 } },
    { DAMPER_BLOWOFF,     BODY_REAR,  AXLE_REAR,  { 1400.0, 0.4, 0.3 } },
    { SPRING_LINEAR,      AXLE_FRONT, ROAD_FRONT, { 1.9e5, 0.0, 0.0 } },
    { SPRING_LINEAR,      AXLE_REAR,  ROAD_REAR,  { 1.9e5, 0.0, 0.0 } },
};

static const half_car_t car = {
    730.0, 1230.0, { 40.0, 35.5 }, { 1.011, 1.803 }, 12.0, 2.814, sizeof elements / sizeof *elements, elements
};

static double road(double s)
{
    return 0.03 * sin(0.9 * s) + 0.01 * cos(2.3 * s);
}

static void markers_position(const half_car_t *p, const double *q, double t, double x[MARKERS])
{
    int i;

    for (i = 0; i < 2; i++) {
        x[BODY_FRONT + i] = q[0] + (i == 0 ? p->arm[0] : -p->arm[1]) * sin(q[1]);
        x[AXLE_FRONT + i] = q[2 + i];
        x[ROAD_FRONT + i] = road(p->speed * t - i * p->wheel_base);
    }
}

static double stored_energy(const element_t *e, double stretch)
{
    double energy = 0.0;

    switch (e->kind) {
    case SPRING_PROGRESSIVE:
        energy = e->c[1] * stretch * stretch * stretch * stretch / 4.0;
        /* fall through */
    case SPRING_LINEAR:
        energy += e->c[0] * stretch * stretch / 2.0;
        break;
    case BUMP_STOP: {
        double depth = -stretch - e->c[1];
        if (depth > 0.0)
            energy = e->c[0] * depth * depth * depth / 3.0;
        break;
    }
    case DAMPER_CUBIC:
    case DAMPER_BLOWOFF:
    default:
        break;
    }
    return energy;
}

static double damping_force(const element_t *e, double rate)
{
    switch (e->kind) {
    case DAMPER_CUBIC:
        return e->c[0] * rate + e->c[1] * rate * rate * rate;
    case DAMPER_BLOWOFF: /* softer beyond a rate; rebound is harder than bump */
        return rate > e->c[1] ? e->c[0] * (e->c[1] + e->c[2] * (rate - e->c[1]))
             : rate < -e->c[1] ? 0.6 * e->c[0] * (-e->c[1] + e->c[2] * (rate + e->c[1]))
             : rate < 0.0 ? 0.6 * e->c[0] * rate : e->c[0] * rate;
    default:
        return 0.0;
    }
}

double half_car_lagrangian(const half_car_t *p, const double *q, const double *qd, double t)
{
    double x[MARKERS], energy;
    const element_t *e;

    energy = 0.5 * p->m_body * qd[0] * qd[0] + 0.5 * p->j_body * qd[1] * qd[1];
    energy += 0.5 * p->m_axle[0] * qd[2] * qd[2] + 0.5 * p->m_axle[1] * qd[3] * qd[3];
    energy -= 9.81 * (p->m_body * q[0] + p->m_axle[0] * q[2] + p->m_axle[1] * q[3]);
    markers_position(p, q, t, x);
    for (e = p->element; e != p->element + p->n_elements; ++e)
        energy -= stored_energy(e, x[e->upper] - x[e->lower]);
    return energy;
}

void half_car_dampers(const half_car_t *p, const double *q, const double *qd, double *out)
{
    int k;

    out[0] = out[1] = out[2] = out[3] = 0.0;
    for (k = 0; k < p->n_elements; k++) {
        const element_t *e = &p->element[k];
        double lever, rate, f;

        if (e->kind != DAMPER_CUBIC && e->kind != DAMPER_BLOWOFF)
            continue;
        lever = (e->upper == BODY_FRONT ? p->arm[0] : -p->arm[1]) * cos(q[1]);
        rate = qd[0] + lever * qd[1] - qd[e->lower - AXLE_FRONT + 2];
        f = damping_force(e, rate);
        out[0] -= f;
        out[1] -= f * lever;
        out[e->lower - AXLE_FRONT + 2] += f;
    }
}
