// Rest and small motion: where the machine stands still under its loads, whether it returns when pushed, and how it
// vibrates there. Drives are held at their values at the start; stops and dry friction are not considered.
#ifndef YOKE_REST_H
#define YOKE_REST_H

#include <yoke/dynamics.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkRestOptions {
    const YkCompileOptions *compile; // NULL: defaults
    size_t starts;                   // poses from which the search begins besides `start:` (default 100; 0: only there)
    double time;                     // s, at which drives and loads are evaluated
    const YkState *pose; // where the search starts, of the same machine; must outlive the answer. NULL: assembled
                         // as `start:` says
    YkProgress progress; // watches yk_rest_find, and yk_rest_reach later on; {NULL}: not watched
} YkRestOptions;
YK_API YkRestOptions yk_default_rest_options(void);

typedef struct YkRest YkRest;
// Searches for equilibria: from `start:` by Newton's method; on all circuits of a machine with one freedom, where the
// effort of the loads changes sign; and from seeded random poses of all configurations. Returns all that it finds:
// first that of `start:`, if there is one, then the others by energy. None found is not an error. Where the machine
// rests everywhere along a line of its free inputs, one pose stands for all.
// The model must outlive the answer. Returns NULL with problems added: no assembly, a freedom without inertia, stopped.
// Cost: about starts * 20 * freedom^2 evaluations, and for one freedom the machine's map (yoke/map.h) of up to 8
// blocks.
YK_API YkRest *yk_rest_find(const YkModel *model, const YkRestOptions *options, YkProblems *problems);
YK_API void yk_rest_free(YkRest *rest);
YK_API size_t yk_rest_count(const YkRest *rest);
// Returns whether all circuits were searched: only two equilibria of one circuit, less than about 0.05 rad apart, can
// then have been missed. Otherwise there may be others.
YK_API bool yk_rest_is_complete(const YkRest *rest);
// Returns whether the loads of a machine with one freedom, which turns fully, differ a turn later, as those of
// torsional springs do: only one turn was searched.
YK_API bool yk_rest_is_wound(const YkRest *rest);
YK_API const YkMechanism *yk_rest_mechanism(const YkRest *rest);
YK_API size_t yk_rest_freedom(const YkRest *rest);         // f, the number of free inputs
YK_API size_t yk_rest_input(const YkRest *rest, size_t k); // the coordinate that is free input k

typedef enum YkStability {
    YK_STABILITY_STABLE,   // every small motion dies out or, without damping, stays small
    YK_STABILITY_UNSTABLE, // some small motion grows
    YK_STABILITY_NEUTRAL,  // some motion meets no force at all
    YK_STABILITY_NONE      // what an index past the last equilibrium gives
} YkStability;
typedef struct YkEquilibrium {
    YkStability stability;
    double potential;     // J
    double force;         // residual: largest effort that would be needed, over the largest load
    bool is_reachable;    // after yk_rest_reach: the machine can get there from its start in its own assembly
    bool is_higher_order; // K is 0: the force of a machine with one freedom grows with a higher power of the distance
} YkEquilibrium;
// Finds out which equilibria the machine can reach from its start without being taken apart, by moving it there, also
// through dead points, and in both directions. Returns YK_OK, YK_NO_MEMORY or YK_STOPPED. Equilibria that it could not
// reach are reported as not reachable.
YK_API YkStatus yk_rest_reach(YkRest *rest);
YK_API YkEquilibrium yk_rest_equilibrium(const YkRest *rest, size_t index);
// Returns the pose itself, valid until the next call. For its forces, make a dynamics of yk_rest_mechanism and call
// yk_dynamics_solve.
YK_API YkState *yk_rest_state(YkRest *rest, size_t index);
// M q'' + C q' + K q = 0 over the free inputs, linearised at the equilibrium: f x f, row-major, SI.
YK_API const double *yk_rest_mass(const YkRest *rest, size_t index);
YK_API const double *yk_rest_damping(const YkRest *rest, size_t index);
YK_API const double *yk_rest_stiffness(const YkRest *rest, size_t index);
// Mode k of f, by rising frequency, of the motion without damping and without loads that have no potential: the
// eigenvectors of the symmetric part of K. yk_rest_root has the motion with both.
typedef struct YkMode {
    double frequency;     // undamped, rad/s; negative: grows at that rate (K has a negative direction)
    double damping_ratio; // of the mode alone: shape' C shape / (2 omega)
    const double *shape;  // [f], largest entry 1
} YkMode;
YK_API YkMode yk_rest_mode(const YkRest *rest, size_t index, size_t k);
// Returns characteristic root k of the 2 f of the damped motion, 1/s: its real and imaginary part.
YK_API void yk_rest_root(const YkRest *rest, size_t index, size_t k, double *real, double *imaginary);

#ifdef __cplusplus
}
#endif

#endif
