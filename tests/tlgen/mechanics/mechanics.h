/* What check.c knows of the model that it is linked with; model.c.in is filled in for each. */
#ifndef TEST_MECHANICS_H
#define TEST_MECHANICS_H

#include "eom/model.h"

const eom_model *mechanics_model(void);
const void *mechanics_params(void);

/* The mechanism and how its C is written, and the file of reference.py. */
extern const char mechanics_about[], mechanics_reference[];

#endif
