/* runtime: constrained motion, linearisation and Lyapunov exponents from jet functions. This header includes all of it. */
#ifndef EOM_EOM_H
#define EOM_EOM_H

#include "eom/assemble.h"
#include "eom/equilibrium.h"
#include "eom/events.h"
#include "eom/integrate.h"
#include "eom/linearise.h"
#include "eom/lyapunov.h"
#include "eom/method.h"
#include "eom/minimal.h"
#include "eom/modes.h"
#include "eom/project.h"
#include "eom/sensitivity.h"
#include "eom/solve.h"
#include "eom/system.h"
#include "eom/tangent.h"
#include "eom/taylor.h"
#include "eom/variational.h"

#endif
