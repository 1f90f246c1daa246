/* A net of four free knots between pins, each thread with a law of its own: objects with numbers and flags, laws as callbacks. */
#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef double (*thread_law)(double stretch, double stiffness);

typedef struct {
    int   id;
    bool  pinned;
    float mass;
    double position[2], velocity[2];
} knot_t;

typedef struct {
    unsigned char from, to;
    double length, stiffness;
    thread_law energy;
} thread_t;

static double hooke(double s, double k) { return k * s * s / 2; }
static double slack(double s, double k) { return s > 0 ? hooke(s, k) : 0; }       /* a thread pulls only */
static double stiffening(double s, double k) { return k * (cosh(s) - 1); }

enum { KNOTS = 8, FREE = 4 };

static const knot_t rest[KNOTS] = {
    { .id = 0, .mass = 0.50f }, { .id = 1, .mass = 0.25f }, { .id = 2, .mass = 0.75f }, { .id = 3, .mass = 0.375f },
    { 4, true, 0, { -2, 2 } }, { 5, true, 0, { 2, 2 } }, { 6, true, 0, { 2, -2 } }, { 7, true, 0, { -2, -2 } },
};

static const thread_t threads[] = {
    { 0, 1, 1.0, 12.0, hooke }, { 1, 2, 1.1, 9.0, slack }, { 2, 3, 0.9, 15.0, stiffening }, { 3, 0, 1.0, 11.0, slack },
    { 0, 4, 1.2, 20.0, slack }, { 1, 5, 1.2, 20.0, slack }, { 2, 6, 1.2, 20.0, slack },     { 3, 7, 1.2, 20.0, hooke },
};

static void knots_load(knot_t *knots, const double *q, const double *qd)
{
    memcpy(knots, rest, sizeof rest);
    for (int i = 0; i < KNOTS; i++) {
        if (knots[i].pinned)
            continue;
        memcpy(knots[i].position, q + 2 * i, 2 * sizeof *q);
        memcpy(knots[i].velocity, qd + 2 * i, 2 * sizeof *qd);
    }
}

static double thread_energy(unsigned i, const knot_t *knots)
{
    const knot_t *a = &knots[threads[i].from], *b = &knots[threads[i].to];
    double length = hypot(b->position[0] - a->position[0], b->position[1] - a->position[1]);
    return threads[i].energy(length - threads[i].length, threads[i].stiffness);
}

double net_lagrangian(const double *q, const double *qd)
{
    knot_t knots[KNOTS];
    double sum = 0;

    knots_load(knots, q, qd);
    for (knot_t *k = knots; k < knots + KNOTS; k++)
        sum += k->mass * (k->velocity[0] * k->velocity[0] + k->velocity[1] * k->velocity[1]) / 2 - 9.81 * k->mass * k->position[1];
    for (unsigned i = 0; i < sizeof threads / sizeof threads[0]; i++)
        sum -= thread_energy(i, knots);
    return sum;
}
