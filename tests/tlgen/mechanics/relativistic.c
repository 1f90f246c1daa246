//---------------------------------------------------------------------------
// Relativistic charge in a Coulomb field and a harmonic trap (plane motion)
//---------------------------------------------------------------------------
#include <math.h>

typedef double        DOUBLE;
typedef int           INT;
typedef const double* LPCDOUBLE;
typedef int           BOOL;

#define TRUE          1
#define FALSE         0
#define DIM_PLANE     2

typedef struct tagPARTICLE
{
    DOUBLE  dRestMass;
    DOUBLE  dSpeedOfLight;
    DOUBLE  dCoulomb;
    DOUBLE  adStiffness[DIM_PLANE];
    BOOL    bSubtractRestEnergy;
} PARTICLE, *LPPARTICLE;
typedef const PARTICLE* LPCPARTICLE;

const PARTICLE g_stElectron = { 0.8, 3.0, 1.7, { 0.4, 0.9 }, FALSE };

static DOUBLE SumOfSquares(LPCDOUBLE lpdVector, INT nCount)
{
    DOUBLE dSum = 0.0;
    INT    iIndex;

    for (iIndex = 0; iIndex < nCount; iIndex++)
    {
        dSum += lpdVector[iIndex] * lpdVector[iIndex];
    }
    return dSum;
}

DOUBLE RelativisticLagrangian(LPCDOUBLE lpdPos, LPCDOUBLE lpdVel, LPCPARTICLE lpstParticle)
{
    DOUBLE dLight2  = lpstParticle->dSpeedOfLight * lpstParticle->dSpeedOfLight;
    DOUBLE dRest    = lpstParticle->dRestMass * dLight2;
    DOUBLE dBeta2   = SumOfSquares(lpdVel, DIM_PLANE) / dLight2;
    DOUBLE dFree    = -dRest * sqrt(1.0 - dBeta2);
    DOUBLE dEnergy  = -lpstParticle->dCoulomb / sqrt(SumOfSquares(lpdPos, DIM_PLANE));
    INT    iAxis;

    for (iAxis = 0; iAxis < DIM_PLANE; ++iAxis)
    {
        dEnergy += 0.5 * lpstParticle->adStiffness[iAxis] * lpdPos[iAxis] * lpdPos[iAxis];
    }
    if (lpstParticle->bSubtractRestEnergy)
    {
        dFree += dRest;
    }
    return dFree - dEnergy;
}
