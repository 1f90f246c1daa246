/* The model that check.c is linked with; subject.c.in is filled in for each. */
#ifndef TEST_ADJOINT_SUBJECT_H
#define TEST_ADJOINT_SUBJECT_H

#include "eom/model.h"

#include <stddef.h>

const eom_model *subject_model(void);
const void *subject_params(void);

/* Places in the parameter struct of the members that the parameters need is about, in its order. */
extern const size_t subject_offset[];
extern const int subject_noffset;

#endif
