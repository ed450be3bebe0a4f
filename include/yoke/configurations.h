// Every configuration of a machine at its inputs, with a proof that the list is complete.
//
// Dyads have two, in closed form. A larger group is a system of polynomials in e^(i angle) and distances; all its
// complex solutions are found by elimination, or followed from those of a generic system of the same structure. Each is
// proved by interval arithmetic (it exists, is alone in its neighbourhood, is real or is not), and their number is
// compared with the count that no such group exceeds. docs/configurations.md has the mathematics and its sources.
#ifndef YOKE_CONFIGURATIONS_H
#define YOKE_CONFIGURATIONS_H

#include <yoke/state.h>

#ifdef __cplusplus
extern "C" {
#endif

// Keeps what enumerating has found out about a mechanism: the generic systems of its groups. Keep it from pose to pose,
// since the first pose costs most. Use one per thread; the mechanism must outlive it. yk_configurations_new returns
// NULL when out of memory.
typedef struct YkConfigurations YkConfigurations;
YK_API YkConfigurations *yk_configurations_new(const YkMechanism *mech);
YK_API void yk_configurations_free(YkConfigurations *configurations);

// Why there are no others.
typedef enum YkCompleteReason {
    YK_INCOMPLETE,              // there may be others
    YK_COMPLETE_BY_CLOSED_FORM, // dyads only
    YK_COMPLETE_BY_COUNT,       // and groups with as many distinct proved complex solutions as their count
    YK_COMPLETE_BY_EXCLUSION    // and groups with gears: the rest of the space of their angles is proved to be empty
} YkCompleteReason;
YK_API const char *yk_complete_reason_name(YkCompleteReason reason); // "none", "closed form", "counted", "excluded"

// A continuum of poses with the same inputs: a parallelogram with a bar too many, a dyad whose base has no length.
typedef struct YkContinuum {
    // The dimension of the largest part at the pose, or 0 if the pose is isolated. It is measured, not proved: the
    // Jacobian of all loops, gears and inputs lacks this much rank at the pose, and also at the poses reached by steps
    // in both directions along each vector of its kernel.
    size_t dimension;
    // Proved. The rank bounds the dimension from above. From below it is bounded where loops repeat each other because
    // bodies keep their angle to each other (as long as dimensions are exact: to 1e-11 of the size); otherwise this is
    // 0.
    size_t at_least, at_most;
    size_t poses; // found along it
    double miss;  // by which their loops miss at most, over the machine's size
} YkContinuum;

enum { YK_CONFIGURATIONS_SHOWN = 10000 };

typedef struct YkConfigurationsReport {
    bool complete; // there are no configurations but those visited
    YkCompleteReason reason;
    size_t count; // configurations found; those beyond the first YK_CONFIGURATIONS_SHOWN are not visited
    // The group with the most solutions still missing, or the largest group if none lacks any: its block, or -1 if
    // there is no group; how many distinct complex solutions were proved, and how many the group has. expected is 0 if
    // they were not counted.
    int block;
    size_t proved, expected;
    char message[240];     // one sentence: why it is complete, or what is missing
    size_t continua;       // how many of the configurations visited stand for a continuum
    YkContinuum continuum; // the one of largest dimension
} YkConfigurationsReport;

// How the complex solutions of a group are found. They are proved and counted in the same way however they are found.
typedef enum YkGroupSolver {
    YK_SOLVER_BOTH,       // elimination; and paths where that cannot be or does not find all
    YK_SOLVER_PATHS,      // from the solutions of a generic system, found by monodromy
    YK_SOLVER_ELIMINATION // one eigenvalue problem, for groups of up to four loops; larger ones are searched
} YkGroupSolver;

typedef struct YkConfigurationsOptions {
    // Visits what yk_state_each visits first, in its order, and then the others. It costs that search, at every pose.
    // Otherwise the solutions of a group are sorted by its unknowns.
    bool in_search_order;
    // Asked as <yoke/progress.h> says while groups are solved. Once it returns false no more paths are followed; what
    // is proved by then is visited, and the report is not complete. (What watches the state ends the whole call.)
    YkProgress enough;
    // Names (yk_configurations_name) are asked for while it visits: what they need is enumerated before, once for the
    // same inputs.
    bool with_names;
    YkGroupSolver solver;
} YkConfigurationsOptions;
YK_API YkConfigurationsOptions yk_default_configurations_options(void);

// Visits every configuration at the state's inputs, the first YK_CONFIGURATIONS_SHOWN of them, each as its pose. visit
// (may be NULL) returns false to stop; the state returns to the configuration it had. options may be NULL. For groups
// with up to three gears, belts, racks, cams or laws and six unknowns, the space of all angles and distances is divided
// until each box is proved to hold one pose or none.
// Other groups (with more of these, with laws that are not smooth, with constraints that repeat others,
// or of more than 7 loops) are searched as yk_state_each does, and the report is not complete. Returns YK_OK,
// YK_NO_ASSEMBLY (with report->complete: proved), YK_STOPPED, or YK_NO_MEMORY.
// Cost: an eigenvalue problem of size 6, 20, 70 for groups of 2, 3, 4 loops, beyond that the paths of all complex
// solutions, of each group at each combination of earlier blocks.
YK_API YkStatus yk_configurations_each(YkConfigurations *configurations, YkState *state,
                                       const YkConfigurationsOptions *options,
                                       bool (*visit)(void *context, YkState *state), void *context,
                                       YkConfigurationsReport *report);

// Returns the continuum that the configuration being visited stands for, one pose of it for all; or NULL. It is looked
// for where a dyad is singular, or a group is not proved to be complete.
YK_API const YkContinuum *yk_configurations_continuum(const YkConfigurations *configurations);

// Names the configuration that a state with a pose stands in, among those at its inputs: its label and, if several have
// the same label, a number, as in `J+.2`. They are counted in the order of the search at the start, where the machine
// was assembled, so that the name stays while the machine moves; `J+.x2` counts them at these inputs, if this one
// cannot move back. *name belongs to `configurations` until the next call. Options as above, or NULL. Returns YK_OK,
// YK_STOPPED or YK_NO_MEMORY (*name is then ""), or YK_BAD_ARGUMENT: another machine's state, or asked for during a
// visit without `with_names`. Cost: the configurations at these inputs, and at the start if labels repeat, once for the
// same inputs; a move to the start for each name with a number.
YK_API YkStatus yk_configurations_name(YkConfigurations *configurations, const YkState *state,
                                       const YkConfigurationsOptions *options, const char **name);

#ifdef __cplusplus
}
#endif

#endif
