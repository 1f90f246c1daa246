/* A shared object that says it is a model of another version of the library, by OTHER: its number, or the size of what it is made of.
 */
#include "eom/description.h"

#if OTHER == 1
static const eom_description description = {.version = EOM_DESCRIPTION_VERSION & 255u};
#else
static const eom_description description = {.version = EOM_DESCRIPTION_VERSION, .model_size = sizeof(eom_model), .motion_size = 8};
#endif

const eom_description *eom_shared_model(void) { return &description; }
