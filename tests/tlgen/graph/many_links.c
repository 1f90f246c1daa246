/* Chains long enough for loops to be kept. */
#include "pendulum.c"
#include "relative_chain.c"

const struct pendulum many_pendula = {.n = 9, .g = 9.81, .mass = {1, 2, 3, 1, 2, 3, 1, 2, 3}, .length = {1, .5, .25, 1, .5, .25, 1, .5, .25}};
const struct relative_chain many_links = {.n = 9, .gravity = 9.81};
