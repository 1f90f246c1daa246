/* libtaylor: truncated Taylor algebra on flat arrays. This header includes all of it. */
#ifndef TAYLOR_TAYLOR_H
#define TAYLOR_TAYLOR_H

#include "taylor/elementary.h"
#include "taylor/rule.h"

#endif
