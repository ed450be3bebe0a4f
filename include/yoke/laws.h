// Laws whose range is left. A law of motion, a table or a formula without a period is given over a range of its
// argument and keeps the value of its nearest end outside, which is rarely what was meant. A watch looks at poses and
// remembers where that happens. Laws with a period are never left.
#ifndef YOKE_LAWS_H
#define YOKE_LAWS_H

#include <yoke/dynamics.h>
#include <yoke/problem.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum YkLawUser {
    YK_LAW_USER_DRIVE,  // moves a coordinate, in time or as it follows another coordinate
    YK_LAW_USER_EFFORT, // along a coordinate
    YK_LAW_USER_FORCE,
    YK_LAW_USER_SPRING
} YkLawUser;

// One use of a law, and where it was first found outside the law's range. Names live as long as the model.
typedef struct YkLawLeft {
    const char *law;
    YkLawUser user;
    const char *name; // of the coordinate, force or spring
    YkPlace place;    // of the use in the file
    double from, to;  // the law's range, SI
    double argument;  // at the first pose outside it, SI
    double value;     // that the law keeps there, SI
    double at;        // what the caller gave for that pose
    size_t poses;     // how many poses were outside
} YkLawLeft;

typedef struct YkLawWatch YkLawWatch;
// Makes a watch for a model, which must outlive it. Returns NULL when out of memory. Cost linear in the model.
YK_API YkLawWatch *yk_law_watch_new(const YkModel *model);
YK_API void yk_law_watch_free(YkLawWatch *watch);
// Looks at a state that is solved. The laws of loads are looked at only if `dynamics` is given (of the state's
// mechanism) and the state has rates; a drive that a host, `--at` or a sweep replaces is not in use. `at` identifies
// the pose later: a time, or the coordinate that is swept. An argument less than 1e-9 of the range beyond an end is
// rounding. Returns how many uses are outside the range of their law at this pose. Allocates nothing; returns at once
// if all laws have periods.
YK_API size_t yk_law_watch_look(YkLawWatch *watch, const YkState *state, YkDynamics *dynamics, double at);
// Remembers a use that was found outside in another way: by the name, argument and time of a simulation's event
// (YK_HAPPENING_LAW_LEFT).
YK_API void yk_law_watch_note(YkLawWatch *watch, const char *name, double argument, double at);
// The uses that were found outside at some pose, in the order of drives, efforts, forces, springs. Beyond the last, a
// YkLawLeft of NULLs and 0.
YK_API size_t yk_law_watch_count(const YkLawWatch *watch);
YK_API YkLawLeft yk_law_watch_get(const YkLawWatch *watch, size_t index);

#ifdef __cplusplus
}
#endif

#endif
