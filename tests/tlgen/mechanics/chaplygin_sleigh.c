/* Chaplygin sleigh on a slowly tilting table. Every quantity has its unit for a type, so that the compiler checks dimensions. */
#include <math.h>

typedef struct { double si; } metre, metre_per_second, radian, radian_per_second, second, kilogram, kilogram_metre2, joule, newton, newton_metre;
typedef struct { metre_per_second x, y; } velocity;

#define UNIT(type, value) ((type){ .si = (value) })

typedef struct {
    kilogram mass;
    kilogram_metre2 inertia;
    metre offset; /* of the centre of mass ahead of the blade */
    radian_per_second tilting;
    struct { double linear, angular; } damping;
} sleigh;

static const sleigh toy = {
    .mass = { 2.0 }, .inertia = { 0.15 }, .offset = { 0.25 }, .tilting = { 0.02 }, .damping = { .linear = 0.3, .angular = 0.05 }
};

static joule add(joule a, joule b) { return UNIT(joule, a.si + b.si); }
static metre_per_second rim_speed(metre r, radian_per_second w) { return UNIT(metre_per_second, r.si * w.si); }
static radian after(radian_per_second w, second t) { return UNIT(radian, w.si * t.si); }
static metre projected(metre r, radian a) { return UNIT(metre, r.si * cos(a.si)); }

static velocity centre_velocity(velocity blade, metre_per_second swing, radian heading)
{
    velocity v = blade;
    v.x.si -= swing.si * sin(heading.si);
    v.y.si += swing.si * cos(heading.si);
    return v;
}

static joule translation(kilogram m, velocity v) { return UNIT(joule, 0.5 * m.si * (v.x.si * v.x.si + v.y.si * v.y.si)); }
static joule rotation(kilogram_metre2 i, radian_per_second w) { return UNIT(joule, 0.5 * i.si * w.si * w.si); }
static joule lifted(kilogram m, metre uphill, radian slope) { return UNIT(joule, -m.si * 9.81 * sin(slope.si) * uphill.si); }

double sleigh_lagrangian(const double *q, const double *qd, double t, const sleigh *s)
{
    const radian heading = { q[2] };
    const radian_per_second turning = { qd[2] };
    const velocity blade = { { qd[0] }, { qd[1] } };
    const metre uphill = UNIT(metre, q[0] + projected(s->offset, heading).si);
    joule sum;

    sum = add(translation(s->mass, centre_velocity(blade, rim_speed(s->offset, turning), heading)), rotation(s->inertia, turning));
    return add(sum, lifted(s->mass, uphill, after(s->tilting, UNIT(second, t)))).si;
}

static metre_per_second across(velocity v, radian heading)
{
    return UNIT(metre_per_second, v.y.si * cos(heading.si) - v.x.si * sin(heading.si));
}

double sleigh_slip(const double *q, const double *qd)
{
    return across((velocity){ UNIT(metre_per_second, qd[0]), UNIT(metre_per_second, qd[1]) }, UNIT(radian, q[2])).si;
}

void sleigh_damping(const double *qd, const sleigh *s, double *out)
{
    const struct { newton x, y; newton_metre turn; } f = {
        { -s->damping.linear * qd[0] }, { -s->damping.linear * qd[1] }, { -s->damping.angular * qd[2] }
    };
    out[0] = f.x.si;
    out[1] = f.y.si;
    out[2] = f.turn.si;
}
