// The status of a call: 0 means success, a positive value success with a remark, a negative value failure.
#ifndef YOKE_STATUS_H
#define YOKE_STATUS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(_WIN32)
#define YK_API __declspec(dllexport)
#else
#define YK_API __attribute__((visibility("default")))
#endif

// The result of a search by name if the name is unknown.
#define YK_NOT_FOUND ((size_t)-1)

typedef enum YkStatus {
    YK_OK = 0,             // the answer is valid
    YK_REDUNDANT = 1,      // the answer is valid; some constraints repeat others
    YK_CHANGE_POINT = 2,   // two branches meet here; pose and rates follow the motion, forces are undefined
    YK_SINGULAR = 3,       // dead point: the position is valid, velocities and accelerations are undefined
    YK_LIMIT = -1,         // past a limit position: this configuration cannot be closed here
    YK_NO_ASSEMBLY = -2,   // no configuration can be closed
    YK_NOT_CONVERGED = -3, // the iteration did not reach its tolerance
    YK_BAD_MODEL = -4,     // the file or the model is wrong: see the problems
    YK_BAD_ARGUMENT = -5,  // the call itself is wrong
    YK_NO_MEMORY = -6,     // an allocation failed
    YK_IO = -7,            // a file could not be read or written
    YK_STOPPED = -8        // stopped by the caller, or at the limit on the number of steps
} YkStatus;

// Returns the word that the command line prints for a status: "ok", "limit", "change-point", "singular", ...
YK_API const char *yk_status_name(YkStatus status);

#ifdef __cplusplus
}
#endif

#endif
