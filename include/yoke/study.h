// Studies: one machine in many designs - each with its own parameters - and many poses, on several threads.
//
// A design is a set of values of some parameters. All arrays are structures of arrays. Results are the same to the last
// bit for any number of threads.
#ifndef YOKE_STUDY_H
#define YOKE_STUDY_H

#include <yoke/batch.h>
#include <yoke/variant.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkStudyOptions {
    const char *const *parameters; // names of those that vary: any but those of drives and of the starts of inputs
    size_t parameter_count;
    const YkChannel *channels; // what is computed; forces as in batches
    size_t channel_count;
    size_t threads; // 0 means 1
    // The state in which the machine was assembled, if it was assembled with other inputs: a state of a mechanism
    // compiled with them, at whose inputs each design starts. NULL: the state itself. Its mechanism must outlive the
    // study.
    const YkState *start;
    // Watches yk_study_new and every later call on the study; {NULL}: not watched. It is called on the thread that
    // makes the call, whatever the number of threads, with the part of the designs (or parameters) that is done.
    YkProgress progress;
    // Moves every design along its drives in time, from t = 0, instead of straight from pose to pose: needed where a
    // drive turns back at a limit between two poses. The poses of a request are then those at its `times`, where the
    // drives have the values in `inputs`, and no input is held. Designs are solved pose by pose, with allocations.
    bool follows_time;
} YkStudyOptions;

typedef struct YkStudy YkStudy;
// Makes a study. The state is in the pose in which the machine was assembled: every design is assembled at its inputs,
// in its configuration. The state's model and mechanism must outlive the study. Returns NULL with problems added.
YK_API YkStudy *yk_study_new(const YkState *state, const YkStudyOptions *options, YkProblems *problems);
YK_API void yk_study_free(YkStudy *study);

// A request: designs times poses.
typedef struct YkStudyCase {
    const double *const *parameters; // [parameter][design], SI; a NULL array: the file's value
    size_t design_count;
    const double *const *inputs; // [3 * input + k][pose]: position, velocity, acceleration; a NULL array: the state's
    size_t pose_count;
    bool inputs_per_design; // inputs[...][design * pose_count + pose]: each design has inputs of its own
    const double *times;    // [pose], s: of loads and the time itself; NULL: the state's
} YkStudyCase;

// Computes every pose: outputs[channel][design * pose_count + pose] and status[...] (may be NULL). A design made of
// dyads is assembled at the inputs of the start, on the state's branches; one with larger groups is carried along from
// the file's values (yk_state_carry). From there it moves straight to its first pose (with a detour tried if there are
// several inputs), then straight from pose to pose: branch and circuit are kept, change points passed, turns counted.
// Status: YK_OK, YK_SINGULAR; YK_BAD_MODEL if the values make no valid machine, YK_NO_ASSEMBLY if it cannot be
// assembled (YK_NOT_CONVERGED if the search for that gave up), YK_LIMIT for a pose that it cannot reach (the next one
// is sought from the last one reached); outputs are then 0, never NaN. Returns the worst status; YK_STOPPED if it was
// stopped, and then outputs and status of some designs are missing. For dyads the results have the bits of
// yk_state_move_to.
// Cost per design: the expressions that vary, then that of yk_batch_run for every 2 degrees of the way or every pose,
// whichever are more; that of yk_state_move_to where branches may meet, with groups, gears, belts and cams. Only these
// allocate, and forces that a batch solves pose by pose. A parameter that enters teeth, belts, cams, laws, `turned` or
// the phase of a mesh makes every design a machine of its own, read and compiled anew; it is assembled by the labels of
// the file's machine or, with groups, nearest to it, within 0.5 rad and half its size.
YK_API YkStatus yk_study_run(YkStudy *study, const YkStudyCase *asked, double *const *outputs, signed char *status);

// The least, largest and mean value of a channel over the valid poses of one design.
typedef struct YkExtent {
    double least, largest, mean;
} YkExtent;
// Does the same without keeping the poses: extents[channel * design_count + design], the worst status of each
// design, and its number of valid poses (may be NULL). If it has none, the extent is 0 and the status says why.
YK_API YkStatus yk_study_reduce(YkStudy *study, const YkStudyCase *asked, YkExtent *extents, signed char *status,
                                size_t *standing);

// Finds derivatives at the file's values and one pose, inputs[3 * input + k] (a NULL array, or NULL: the state's), to
// which the machine moves as in yk_study_run. Both results are [channel * parameters + parameter].
// by_derivative: by the implicit function theorem on the loops of the tree (only positions, of machines with at most
// 300 unknowns and without gears, belts and cams; otherwise NaN). by_difference: from the solved pose, extrapolated
// from central differences (Richardson 1911). The two share only the pose. Designs that are machines of their own are
// only differenced. A rate or force that the pose leaves undefined is NaN. Returns YK_OK, or the status of a
// neighbouring pose that is not valid: half a tooth makes no machine.
YK_API YkStatus yk_study_sensitivities(YkStudy *study, const double *const *inputs, double *by_derivative,
                                       double *by_difference);

// Forward dynamics of many states, each with its own parameters: finds the accelerations of all inputs. Open trees
// of pins under gravity and efforts are solved in SIMD lanes. So are machines of closed forms with at most four free
// inputs and no dry friction, where no parameter varies; where some do, state by state. All others are solved state by
// state, with equations made anew for new parameters.
typedef struct YkMotionBatch YkMotionBatch;
// Makes a batch. Its free and driven inputs are those of yk_dynamics_new, its branches those of the state. Groups
// are carried along from the file's values, then tracked straight to the positions. Whether the machine could get to
// its positions is not checked: they are taken to be those of a motion. Returns NULL with problems added.
YK_API YkMotionBatch *yk_motion_batch_new(const YkState *state, const char *const *parameters, size_t parameter_count,
                                          size_t threads, YkProblems *problems);
YK_API void yk_motion_batch_free(YkMotionBatch *batch);
typedef struct YkMotionCase {
    const double *const *parameters; // [parameter][state], SI; a NULL array: the file's value
    const double *const *positions;  // [input][state], m or rad; a NULL array: the state's own
    const double *const *rates;      // [input][state]
    const double *const *efforts;    // [input][state]; NULL: the file's efforts. Only for open trees of pins
    size_t count;
} YkMotionCase;
// Solves accelerations[input][state]. status[state] (may be NULL): YK_OK; YK_BAD_MODEL if the values make no valid
// machine; YK_SINGULAR if a freedom has no inertia; or that of yk_dynamics_accelerate. Accelerations are 0 if the
// status is not YK_OK. Returns the worst status; YK_BAD_ARGUMENT for efforts where they cannot be given. The bits are
// the same for any number of threads and of states. It has no progress callback; the states may be split over several
// calls.
YK_API YkStatus yk_motion_batch_run(YkMotionBatch *batch, const YkMotionCase *asked, double *const *accelerations,
                                    signed char *status);

// A distribution of a parameter, SI.
typedef enum YkDistributionKind {
    YK_DISTRIBUTION_UNIFORM,
    YK_DISTRIBUTION_NORMAL,
    YK_DISTRIBUTION_TRIANGULAR
} YkDistributionKind;
typedef struct YkDistribution {
    YkDistributionKind kind;
    double low, high;      // ends; a normal distribution is cut off there: -INFINITY, INFINITY if it is not
    double center, spread; // normal: mean and standard deviation before it is cut off; triangular: center is the mode
} YkDistribution;
// Returns false for ends in the wrong order, a spread that is not positive, or no probability between the ends.
YK_API bool yk_distribution_is_valid(const YkDistribution *distribution);
// Returns the value of a design: the same for the same seed, design and parameter number, whatever else is drawn. It
// is the quantile of a uniform number from a counter-based generator, so that cutting off is exact.
YK_API double yk_distribution_draw(const YkDistribution *distribution, uint64_t seed, uint64_t design,
                                   uint64_t parameter);
// Returns the largest distance from the nominal value, for the worst case: that of an end; for a normal
// distribution that is not cut off, three standard deviations.
YK_API double yk_distribution_tolerance(const YkDistribution *distribution, double nominal);
YK_API double yk_distribution_deviation(const YkDistribution *distribution); // standard deviation
YK_API double yk_distribution_mean(const YkDistribution *distribution);

// Reads a file of distributions: `seed:`, `designs:` (both optional) and `parameters:` with one of
//   NAME: {uniform: [low, high]}       NAME: {normal: [mean, deviation], within: [low, high]}
//   NAME: {triangular: [low, mode, high]}    NAME: {tolerance: t}: uniform within t of the file's value
// Values take units and the model's parameters. Returns NULL with problems added.
typedef struct YkTolerances YkTolerances;
YK_API YkTolerances *yk_tolerances_load(const char *path, const YkModel *model, YkProblems *problems);
YK_API void yk_tolerances_free(YkTolerances *tolerances);
YK_API size_t yk_tolerances_count(const YkTolerances *tolerances);
YK_API const char *yk_tolerances_name(const YkTolerances *tolerances, size_t index);
YK_API YkDistribution yk_tolerances_at(const YkTolerances *tolerances, size_t index);
YK_API uint64_t yk_tolerances_seed(const YkTolerances *tolerances);    // 1 if the file gives none
YK_API uint64_t yk_tolerances_designs(const YkTolerances *tolerances); // 0 if the file gives none

#ifdef __cplusplus
}
#endif

#endif
