// The names of statuses.
#include <yoke/status.h>

const char *yk_status_name(YkStatus status)
{
    switch (status) {
    case YK_OK:
        return "ok";
    case YK_REDUNDANT:
        return "redundant";
    case YK_CHANGE_POINT:
        return "change-point";
    case YK_SINGULAR:
        return "singular";
    case YK_LIMIT:
        return "limit";
    case YK_NO_ASSEMBLY:
        return "no-assembly";
    case YK_NOT_CONVERGED:
        return "not-converged";
    case YK_BAD_MODEL:
        return "bad-model";
    case YK_BAD_ARGUMENT:
        return "bad-argument";
    case YK_NO_MEMORY:
        return "no-memory";
    case YK_IO:
        return "io";
    case YK_STOPPED:
        return "stopped";
    }
    return "unknown";
}
