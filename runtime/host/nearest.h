/* Which of several names a mistyped one was meant to be. */
#ifndef HOST_NEAREST_H
#define HOST_NEAREST_H

/* Of two names the one that is more like a mistyped one; null for a name that is not like it at all. best may be null, and is kept
 * where both are as like. So a loop over all names, begun with null, finds the nearest. */
const char *nearer(const char *mistyped, const char *best, const char *name);

#endif
