// Progress: how a caller watches a long call, and ends it.
//
// A long call calls its YkProgress to learn whether it may go on: at its beginning, and then after every slice of
// work. A slice takes some 10 ms, at most 50, on an ordinary machine. It is measured by counting operations, not by
// time, so the call asks at the same places in every run. Results do not depend on being watched: they have the same
// bits.
//
// The function is called only on the thread that made the long call, even if a study works on several threads, and
// only during that call. A long call that is told to stop ends soon, with YK_STOPPED, or with NULL and the problem
// E0690; everything that it has made is freed. The object on which it worked stays valid, unless its function says
// otherwise:
// - a state is where it was before the call (yk_state_set_progress);
// - a study, a model and a mechanism are as before;
// - a derivation cannot be used again: it returns YK_STOPPED from then on. Make another one, which costs little.
//
// A YkProgress is given in the options of functions that make something (YkLoadOptions, YkCompileOptions,
// YkStudyOptions, YkRestOptions, YkCSourceOptions). For all other long calls it is set once for the object on which
// they work (yk_state_set_progress, yk_derivation_set_progress). Simulations and moves also have a `goes_on` of their
// own, which is called at every step.
//
// All other calls are short. Their cost is linear in the machine, at most some microseconds for each body (states,
// dynamics, variants, new derivations, drawings of a pose, gear trains), or linear in what is requested at once
// (batches of poses and of states, rows of a cam; request fewer at a time). If one solution of a huge machine takes
// longer than a slice, or one group has more than 400 unknowns, that solution is the slice.
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
