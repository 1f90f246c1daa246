/**
 * @file    lennard_jones.c
 * @brief   Cluster of four atoms in a plane. Written to the MISRA C:2012 guidelines.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

typedef double float64_t;

#define LJ_ATOMS            (4U)
#define LJ_AXES             (2U)
#define LJ_HALF             (0.5)
#define LJ_CUTOFF_SQUARED   (16.0)

typedef struct
{
    float64_t mass;     /* [kg] */
    float64_t depth;    /* [J]  */
    float64_t sigma;    /* [m]  */
} lj_species_t;

static const lj_species_t lj_species[2] =
{
    { 1.0, 1.0, 1.00 },
    { 2.1, 0.7, 1.15 }
};

static const uint8_t lj_species_of_atom[LJ_ATOMS] = { 0U, 1U, 0U, 1U };

/** Position or velocity of an atom along an axis: index into q or qd. */
static uint32_t lj_index(uint32_t atom, uint32_t axis)
{
    return (atom * LJ_AXES) + axis;
}

static float64_t lj_distance_squared(const float64_t q[], uint32_t atom_a, uint32_t atom_b)
{
    float64_t result = 0.0;
    uint32_t axis;

    for (axis = 0U; axis < LJ_AXES; axis++)
    {
        const float64_t difference = q[lj_index(atom_a, axis)] - q[lj_index(atom_b, axis)];
        result += (difference * difference);
    }

    return result;
}

/** Lorentz and Berthelot's mixing rules. */
static float64_t lj_pair_energy(const lj_species_t * const a, const lj_species_t * const b, float64_t distance_squared)
{
    float64_t result;
    const bool is_within_reach = (distance_squared < LJ_CUTOFF_SQUARED);

    if (is_within_reach)
    {
        const float64_t depth = sqrt(a->depth * b->depth);
        const float64_t sigma = LJ_HALF * (a->sigma + b->sigma);
        const float64_t ratio_2 = (sigma * sigma) / distance_squared;
        const float64_t ratio_6 = ratio_2 * ratio_2 * ratio_2;
        result = 4.0 * depth * ((ratio_6 * ratio_6) - ratio_6);
    }
    else
    {
        result = 0.0;
    }

    return result;
}

float64_t lj_lagrangian(const float64_t q[8], const float64_t qd[8])
{
    float64_t kinetic = 0.0;
    float64_t potential = 0.0;
    uint32_t atom;
    uint32_t other;
    uint32_t axis;

    for (atom = 0U; atom < LJ_ATOMS; atom++)
    {
        const lj_species_t * const species = &lj_species[lj_species_of_atom[atom]];

        for (axis = 0U; axis < LJ_AXES; axis++)
        {
            const float64_t speed = qd[lj_index(atom, axis)];
            kinetic += (LJ_HALF * species->mass * speed * speed);
        }

        for (other = atom + 1U; other < LJ_ATOMS; other++)
        {
            potential += lj_pair_energy(species, &lj_species[lj_species_of_atom[other]], lj_distance_squared(q, atom, other));
        }
    }

    return kinetic - potential;
}
