// What a call says of its outcome: 0 fine, above 0 fine but look, below 0 failed.
#ifndef YOKE_STATUS_H
#define YOKE_STATUS_H

#if defined(_WIN32)
#define YK_API __declspec(dllexport)
#else
#define YK_API __attribute__((visibility("default")))
#endif

typedef enum YkStatus {
    YK_OK = 0,             // the answer stands
    YK_REDUNDANT = 1,      // the answer stands; some constraints repeat others
    YK_CHANGE_POINT = 2,   // two branches meet here; the pose is the one the motion's direction leads to
    YK_SINGULAR = 3,       // dead point: the position stands, velocities and accelerations are undefined
    YK_LIMIT = -1,         // past a limit position: this configuration does not close here
    YK_NO_ASSEMBLY = -2,   // no configuration closes
    YK_NOT_CONVERGED = -3, // the iteration did not reach the tolerance
    YK_BAD_MODEL = -4,     // the file or model is wrong: see the problems
    YK_BAD_ARGUMENT = -5,  // the call is wrong
    YK_NO_MEMORY = -6,     // an allocation failed
    YK_IO = -7,            // a file could not be read or written
    YK_STOPPED = -8        // the caller stopped it, or it would take too many steps
} YkStatus;

// The word the command line prints for a status: "ok", "limit", "change-point", "singular", ...
YK_API const char *yk_status_name(YkStatus status);

#endif
