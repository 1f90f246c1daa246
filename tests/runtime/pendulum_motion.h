/* The planar N-pendulum of pendulum_model.h with motion functions by hand, at two sizes. */
#ifndef TEST_PENDULUM_MOTION_H
#define TEST_PENDULUM_MOTION_H

#include "pendulum_model.h"

#include "eom/motion.h"

/* Every function at one link and at three; their one parameter is g. */
extern const eom_motion pendulum_motion_1, pendulum_motion_3;

/* pendulum_model with both. */
eom_model pendulum_with_motion(void);

#endif
