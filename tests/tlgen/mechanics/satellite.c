/* Satellite on a circular orbit with four reaction wheels in a pyramid. q = (roll, pitch, yaw; four wheel angles) of the 3-2-1 sequence
 * from the orbital frame (x ahead, y across, z down). Flight software style. */
#include "satellite.h"

#define N_WHEELS  4
#define N_COORD   (3 + N_WHEELS)

#define S3 0.57735026918962576451

static const double ORBIT_RATE = 1.08e-1; /* rad/s, a hundred times that of a low orbit */
static const double WHEEL_INERTIA = 0.04;
static const mat3_t J_BODY = {
    { 9.2, -0.3, 0.2 },
    { -0.3, 11.5, 0.4 },
    { 0.2, 0.4, 7.1 },
};
static const vec3_t WHEEL_AXIS[N_WHEELS] = { { S3, S3, S3 }, { -S3, S3, S3 }, { -S3, -S3, S3 }, { S3, -S3, S3 } };

static double quad_form(const vec3_t a)
{
    double sum = 0.0;
    int i;
    for (i = 0; i < 3; ++i)
        sum += a[i] * v3_dot(J_BODY[i], a);
    return sum;
}

static void attitude_matrix(mat3_t c, const double *euler)
{
    mat3_t factor;
    int axis;

    m3_axis(c, 2, euler[2]);
    for (axis = 1; axis >= 0; --axis) {
        m3_axis(factor, axis, euler[axis]);
        m3_mul(c, factor, c);
    }
}

/* Body rate to inertial space, on body axes. */
static void body_rate(vec3_t w, mat3_t c, const double *euler, const double *rates)
{
    const vec3_t orbit = { 0.0, -ORBIT_RATE, 0.0 };
    vec3_t carried;

    m3_vec(carried, c, orbit);
    w[0] = rates[0] - sin(euler[1]) * rates[2] + carried[0];
    w[1] = cos(euler[0]) * rates[1] + sin(euler[0]) * cos(euler[1]) * rates[2] + carried[1];
    w[2] = -sin(euler[0]) * rates[1] + cos(euler[0]) * cos(euler[1]) * rates[2] + carried[2];
}

double sat_lagrangian(const double q[N_COORD], const double qd[N_COORD])
{
    static const vec3_t down = { 0.0, 0.0, 1.0 };
    vec3_t w, nadir;
    mat3_t c;
    double kinetic, potential;
    int i;

    attitude_matrix(c, q);
    body_rate(w, c, q, qd);
    kinetic = 0.5 * quad_form(w);
    for (i = 0; i < N_WHEELS; ++i) {
        /* the wheels' inertia across their axes is part of J_BODY */
        double spin = qd[3 + i] + v3_dot(WHEEL_AXIS[i], w);
        kinetic += 0.5 * WHEEL_INERTIA * spin * spin;
    }
    m3_vec(nadir, c, down);
    potential = 1.5 * ORBIT_RATE * ORBIT_RATE * quad_form(nadir);
    return kinetic - potential;
}

void sat_motor_torque(const double *q, const double *qd, double *out)
{
    int i;
    for (i = 0; i < 3; ++i)
        out[i] = 0.0;
    for (i = 0; i < N_WHEELS; ++i) {
        double command = 0.2 * v3_dot(WHEEL_AXIS[i], q) + 0.5 * v3_dot(WHEEL_AXIS[i], qd);
        out[3 + i] = command / sqrt(1.0 + command * command) - 1.0e-3 * qd[3 + i];
    }
}
