/* Lengths of the four-bar linkage, m. */
#ifndef TEST_LINKAGE_H
#define TEST_LINKAGE_H

#define LINKAGE_GROUND 5.0
#define LINKAGE_CRANK 2.0
#define LINKAGE_COUPLER 3.0
#define LINKAGE_ROCKER 4.0

#endif
