// Progress: how a caller watches a long call, and ends it.
//
// A call that can take long asks the YkProgress that was given to it whether it may go on: at its beginning, and from
// then on after every slice of work that takes some 10 ms, 50 at most, on an ordinary machine. It counts its
// own operations for that, not the time, so that a call asks at the same places in every run. Answers do not depend on
// being watched: they have the same bits.
//
// It is asked only on the thread that made the call, also where a study works on several, and only during the call. A
// call that is told to stop ends soon, with YK_STOPPED, or with NULL and the problem E0690; everything that it
// has made is freed. What it was asked of stays as valid as it was, unless its function says otherwise:
// - a state stands where it stood before the call (yk_state_set_progress);
// - a study, a model and a mechanism are as before;
// - a derivation is spent: it answers YK_STOPPED from then on. Make another one, which costs little.
//
// Where it is given: in the options of what makes something (YkLoadOptions, YkCompileOptions, YkStudyOptions,
// YkRestOptions, YkCSourceOptions); for all other long calls once for the object that they work on
// (yk_state_set_progress, yk_derivation_set_progress). Simulations and moves have a `goes_on` of their own besides,
// which is asked at every step.
//
// All other calls are short: of cost linear in the machine, at most some microseconds a body (states, dynamics,
// variants, new derivations, drawings of a pose, gear trains) or in what is asked for at once (batches of poses and of
// states, rows of a cam; ask for fewer at a time). Where one solution of a huge machine takes longer than a slice, or
// one group has more than 400 unknowns, that solution is the slice.
#ifndef YOKE_PROGRESS_H
#define YOKE_PROGRESS_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkProgress {
    // Takes the part of the call that is done, in [0, 1], which never decreases during a call and stays where it is
    // while the remaining work is unknown. Returns false to end the call. It must not use the objects that the call
    // works on. NULL: the call is not watched.
    bool (*goes_on)(void *context, double part);
    void *context;
} YkProgress;

#ifdef __cplusplus
}
#endif

#endif
