// The worse of two statuses.
#ifndef BASE_WORSE_H
#define BASE_WORSE_H
#include <yoke/status.h>

// Returns the failure that weighs more or, if there is none, the status that is more worth attention.
static inline YkStatus yk_worse(YkStatus a, YkStatus b)
{
    return a < 0 || b < 0 ? (a < b ? a : b) : (a > b ? a : b);
}

#endif
