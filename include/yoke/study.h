// Studies: one machine over many designs - each with parameters of its own - and many poses, on several threads.
//
// A design is a set of values of some parameters. All arrays are structures of arrays; results do not depend on the
// number of threads, to the last bit.
#ifndef YOKE_STUDY_H
#define YOKE_STUDY_H

#include <yoke/batch.h>
#include <yoke/variant.h>

typedef struct YkStudyOptions {
    const char *const *parameters; // names of those that vary; see yk_variant_new for what can
    size_t parameter_count;
    const YkChannel *channels; // what is computed; forces too (slower: the equations of motion are made anew a design)
    size_t channel_count;
    size_t threads; // 0: one
    // Where other inputs than the state's say where the machine was put together: that state, of a mechanism compiled
    // with them; each design starts at its inputs. NULL: the state itself. Its mechanism must outlive the study.
    const YkState *start;
} YkStudyOptions;

typedef struct YkStudy YkStudy;
// The pose of the state is where the machine was put together: it tells the inputs at which every design is put
// together, and in which configuration. Its model and mechanism must outlive the study. NULL with problems added.
YK_API YkStudy *yk_study_new(const YkState *state, const YkStudyOptions *options, YkProblems *problems);
YK_API void yk_study_free(YkStudy *study);

// What is asked: designs times poses.
typedef struct YkStudyCase {
    const double *const *parameters; // [parameter][design], SI; a NULL array: the file's value
    size_t design_count;
    const double *const *inputs; // [3 * input + k][pose]: position, velocity, acceleration; a NULL array: the state's
    size_t pose_count;
    bool inputs_per_design; // inputs[...][design * pose_count + pose]: every design at inputs of its own
} YkStudyCase;

// Every pose: outputs[channel][design * pose_count + pose], and status[...] (may be NULL). A design is put together at
// the inputs of the start, by the state's branches, where it consists of dyads; larger groups are carried along from
// the file's values (yk_state_carry). From there it moves straight to its first pose (a way round is tried where there
// are several inputs), then from pose to pose, straight: branch and circuit are kept, change points passed, turns
// counted. Status: YK_OK, YK_SINGULAR; YK_BAD_MODEL where the values make no machine, YK_NO_ASSEMBLY where it cannot be
// put together, YK_LIMIT for a pose to which it does not come (the next one is sought from the last to which it came);
// outputs are 0 there, never NaN. Returns the worst status. The bits are those of yk_state_move_to for dyads. Cost a
// design: the expressions that vary, then as yk_batch_run for every 2 degrees of the way or every pose, whichever are
// more; as yk_state_move_to where branches may meet, with groups, gears, belts, cams, and forces. That allocates.
YK_API YkStatus yk_study_run(YkStudy *study, const YkStudyCase *asked, double *const *outputs, signed char *status);

// Over the poses of one design that stand: least, largest and mean value of a channel.
typedef struct YkExtent {
    double least, largest, mean;
} YkExtent;
// The same without keeping the poses: extents[channel * design_count + design], the worst status of each design, and
// how many of its poses stand (may be NULL). Where none stands the extent is 0 and the status tells why.
YK_API YkStatus yk_study_reduce(YkStudy *study, const YkStudyCase *asked, YkExtent *extents, signed char *status,
                                size_t *standing);

// Derivatives at the file's values and one pose, inputs[3 * input + k] (a NULL array, or NULL: the state's), to which the
// machine moves as in yk_study_run. by_derivative[channel * parameters + parameter]: by the
// implicit function theorem on the loops of the tree (positions only, machines of at most 300 unknowns without gears,
// belts and cams; otherwise as by_difference); by_difference: of the solved pose, extrapolated from central differences
// (Richardson 1911). The two share only the pose. YK_OK, or the status of a neighbouring pose that does not stand.
YK_API YkStatus yk_study_sensitivities(YkStudy *study, const double *const *inputs, double *by_derivative,
                                       double *by_difference);

// Forward dynamics of many states, each with parameters of its own: the accelerations of all inputs. Open trees of pins
// under gravity and efforts run over lanes; other machines state by state, their equations made anew for each.
typedef struct YkMotionBatch YkMotionBatch;
// Free and driven inputs are those of yk_dynamics_new. Branches are those of the state; the assembly of groups is
// carried along from the file's values, then tracked straight to the positions. Whether a machine could come to its
// positions is not asked: they are those of a motion. NULL with problems added.
YK_API YkMotionBatch *yk_motion_batch_new(const YkState *state, const char *const *parameters, size_t parameter_count,
                                          size_t threads, YkProblems *problems);
YK_API void yk_motion_batch_free(YkMotionBatch *batch);
typedef struct YkMotionCase {
    const double *const *parameters; // [parameter][state], SI; a NULL array: the file's value
    const double *const *positions;  // [input][state], m or rad; a NULL array: the state's own
    const double *const *rates;      // [input][state]
    const double *const *efforts;    // [input][state]; NULL: what the file says. Only for open trees of pins
    size_t count;
} YkMotionCase;
// accelerations[input][state]; status[state] (may be NULL): YK_OK; YK_BAD_MODEL where the values make no machine;
// YK_SINGULAR where a freedom has no inertia; what yk_dynamics_accelerate says. Accelerations are 0 where the status is
// not YK_OK. Returns the worst; YK_BAD_ARGUMENT for efforts where they cannot be given. The same bits for any number of
// threads.
YK_API YkStatus yk_motion_batch_run(YkMotionBatch *batch, const YkMotionCase *asked, double *const *accelerations,
                                    signed char *status);

// A distribution of a parameter, SI.
typedef enum YkDistributionKind { YK_UNIFORM, YK_NORMAL, YK_TRIANGULAR } YkDistributionKind;
typedef struct YkDistribution {
    YkDistributionKind kind;
    double low, high;      // ends; of a normal one where it is cut off: -INFINITY, INFINITY where it is not
    double center, spread; // normal: mean and standard deviation before it is cut; triangular: center is the mode
} YkDistribution;
// False where it is none: ends in the wrong order, a spread that is not positive, no part of it between the ends.
YK_API bool yk_distribution_is_valid(const YkDistribution *distribution);
// The value of a design: the same for the same seed, design and parameter number, whatever else is drawn. The quantile
// of a uniform number from a counter-based generator, so that cutting off is exact.
YK_API double yk_distribution_draw(const YkDistribution *distribution, uint64_t seed, uint64_t design,
                                   uint64_t parameter);
// How far from the nominal value it may lie, for the worst case: its ends; of a normal one that is not cut off, three
// standard deviations.
YK_API double yk_distribution_tolerance(const YkDistribution *distribution, double nominal);
YK_API double yk_distribution_deviation(const YkDistribution *distribution); // standard deviation
YK_API double yk_distribution_mean(const YkDistribution *distribution);

// A file of distributions: `seed:`, `designs:` (both optional) and `parameters:` with one of
//   NAME: {uniform: [low, high]}       NAME: {normal: [mean, deviation], within: [low, high]}
//   NAME: {triangular: [low, mode, high]}    NAME: {tolerance: t}: uniform within t of the file's value
// Values take units and the model's parameters. NULL with problems added.
typedef struct YkTolerances YkTolerances;
YK_API YkTolerances *yk_tolerances_load(const char *path, const YkModel *model, YkProblems *problems);
YK_API void yk_tolerances_free(YkTolerances *tolerances);
YK_API size_t yk_tolerances_count(const YkTolerances *tolerances);
YK_API const char *yk_tolerances_name(const YkTolerances *tolerances, size_t index);
YK_API YkDistribution yk_tolerances_at(const YkTolerances *tolerances, size_t index);
YK_API uint64_t yk_tolerances_seed(const YkTolerances *tolerances);    // 1 where the file gives none
YK_API uint64_t yk_tolerances_designs(const YkTolerances *tolerances); // 0 where the file gives none

#endif
