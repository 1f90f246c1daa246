/* Planar arm with three revolute joints and a payload.
 * Every link frame is a homogeneous 4x4 matrix, stored row by row in double[16]. */
#include <math.h>
#include <string.h>

#define JOINTS 3

typedef struct {
    double length;   /* m */
    double com;      /* distance of the centre of mass from the joint, m */
    double mass;     /* kg */
    double inertia;  /* about the centre of mass, kg m^2 */
} Link;

typedef struct {
    Link link[JOINTS];
    double payload;  /* kg, at the tip */
    double gravity[3];
} Arm;

const Arm bench_arm = {
    { { 0.50, 0.21, 3.2, 0.081 }, { 0.40, 0.18, 2.1, 0.034 }, { 0.25, 0.11, 0.9, 0.006 } },
    0.35,
    { 0.0, -9.81, 0.0 }
};

static void mat4_identity(double m[16])
{
    int i;
    memset(m, 0, 16 * sizeof(double));
    for (i = 0; i < 4; i++)
        m[5 * i] = 1.0;
}

/* c = a b; c may be a or b */
static void mat4_multiply(const double *a, const double *b, double *c)
{
    double r[16];
    int i, j, k;
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            double s = 0.0;
            for (k = 0; k < 4; k++)
                s += a[4 * i + k] * b[4 * k + j];
            r[4 * i + j] = s;
        }
    }
    memcpy(c, r, sizeof r);
}

static void mat4_rot_z(double angle, double m[16])
{
    mat4_identity(m);
    m[0] = cos(angle);
    m[1] = -sin(angle);
    m[4] = sin(angle);
    m[5] = cos(angle);
}

static void mat4_translate(double x, double y, double z, double m[16])
{
    mat4_identity(m);
    m[3] = x;
    m[7] = y;
    m[11] = z;
}

static void mat4_point(const double m[16], double x, double y, double z, double out[3])
{
    int i;
    for (i = 0; i < 3; i++)
        out[i] = m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3];
}

static double dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross3(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* velocity of point p that rides on link `last`, from the geometric Jacobian; frame[j] is the frame of joint j */
static void point_velocity(double frame[][16], int last, const double p[3], const double *qd, double v[3])
{
    int j, k;
    v[0] = v[1] = v[2] = 0.0;
    for (j = 0; j <= last; j++) {
        double axis[3], arm[3], column[3];
        for (k = 0; k < 3; k++) {
            axis[k] = frame[j][4 * k + 2];
            arm[k] = p[k] - frame[j][4 * k + 3];
        }
        cross3(axis, arm, column);
        for (k = 0; k < 3; k++)
            v[k] += column[k] * qd[j];
    }
}

double arm_lagrangian(const double *q, const double *qd, const Arm *arm)
{
    double frame[JOINTS][16], base[16], step[16];
    double p[3], v[3], rate = 0.0, T = 0.0, V = 0.0;
    int i;

    mat4_identity(base);
    for (i = 0; i < JOINTS; i++) {
        mat4_rot_z(q[i], step);
        mat4_multiply(base, step, frame[i]);
        mat4_translate(arm->link[i].length, 0.0, 0.0, step);
        mat4_multiply(frame[i], step, base);
    }
    for (i = 0; i < JOINTS; i++) {
        const Link *link = &arm->link[i];
        rate += qd[i];
        mat4_point(frame[i], link->com, 0.0, 0.0, p);
        point_velocity(frame, i, p, qd, v);
        T += 0.5 * link->mass * dot3(v, v) + 0.5 * link->inertia * rate * rate;
        V -= link->mass * dot3(arm->gravity, p);
    }
    mat4_point(base, 0.0, 0.0, 0.0, p);
    point_velocity(frame, JOINTS - 1, p, qd, v);
    T += 0.5 * arm->payload * dot3(v, v);
    V -= arm->payload * dot3(arm->gravity, p);
    return T - V;
}
