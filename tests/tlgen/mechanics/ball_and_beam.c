/* BALLBEAM.C - ball on a motor-driven beam with offset groove. Hungarian notation, as the control lab's Windows program has it. */
#include <math.h>

typedef double DOUBLE;
typedef int INT;
#define CONST const
#define VOID void
#define IN
#define OUT

enum { IDX_POSITION, IDX_ANGLE, CCOORD };

typedef struct _BALLBEAM {
    INT    cCoord;
    DOUBLE dMassBall;
    DOUBLE dInertiaBall;
    DOUBLE dInertiaBeam;
    DOUBLE dRollRadius;
    DOUBLE dGrooveHeight;
    DOUBLE dGravity;
    DOUBLE rgdGain[4];
} BALLBEAM, *PBALLBEAM;
typedef CONST BALLBEAM *PCBALLBEAM;

static CONST BALLBEAM g_BallBeam = { CCOORD, 0.11, 1.76e-5, 0.03, 0.013, 0.02, 9.81, { 8.0, 5.0, 25.0, 4.0 } };

static VOID GetBallVelocity(IN CONST DOUBLE *lpdQ, IN CONST DOUBLE *lpdQd, IN PCBALLBEAM pBeam, OUT DOUBLE *pdVx, OUT DOUBLE *pdVy)
{
    DOUBLE dSin = sin(lpdQ[IDX_ANGLE]), dCos = cos(lpdQ[IDX_ANGLE]);
    DOUBLE dAlong = lpdQd[IDX_POSITION] - pBeam->dGrooveHeight * lpdQd[IDX_ANGLE];
    DOUBLE dAcross = lpdQ[IDX_POSITION] * lpdQd[IDX_ANGLE];

    *pdVx = dAlong * dCos - dAcross * dSin;
    *pdVy = dAlong * dSin + dAcross * dCos;
}

DOUBLE BallBeamLagrangian(IN CONST DOUBLE *lpdQ, IN CONST DOUBLE *lpdQd, IN PCBALLBEAM pBeam)
{
    DOUBLE dVx, dVy, dSpin, dKinetic, dHeight;

    GetBallVelocity(lpdQ, lpdQd, pBeam, &dVx, &dVy);
    dSpin = lpdQd[IDX_ANGLE] - lpdQd[IDX_POSITION] / pBeam->dRollRadius;
    dKinetic = 0.5 * pBeam->dMassBall * (dVx * dVx + dVy * dVy);
    dKinetic += 0.5 * pBeam->dInertiaBall * dSpin * dSpin;
    dKinetic += 0.5 * pBeam->dInertiaBeam * lpdQd[IDX_ANGLE] * lpdQd[IDX_ANGLE];
    dHeight = lpdQ[IDX_POSITION] * sin(lpdQ[IDX_ANGLE]) + pBeam->dGrooveHeight * cos(lpdQ[IDX_ANGLE]);
    return dKinetic - pBeam->dMassBall * pBeam->dGravity * dHeight;
}

VOID BallBeamTorque(IN CONST DOUBLE *lpdQ, IN CONST DOUBLE *lpdQd, IN DOUBLE dTime, IN PCBALLBEAM pBeam, OUT DOUBLE *lpdForce)
{
    DOUBLE rgdError[4], dCommand = 0.0;
    INT iTerm;

    rgdError[0] = lpdQ[IDX_POSITION] - 0.1 * cos(dTime);
    rgdError[1] = lpdQd[IDX_POSITION];
    rgdError[2] = lpdQ[IDX_ANGLE];
    rgdError[3] = lpdQd[IDX_ANGLE];
    for (iTerm = 0; iTerm < (INT)(sizeof(rgdError) / sizeof(rgdError[0])); iTerm++)
        dCommand -= pBeam->rgdGain[iTerm] * rgdError[iTerm];
    lpdForce[IDX_POSITION] = 0.0;
    lpdForce[IDX_ANGLE] = 2.0 * tanh(dCommand / 2.0);
}
