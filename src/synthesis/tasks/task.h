// The inside of a task: what its file says, in SI.
#ifndef SYNTHESIS_TASK_H
#define SYNTHESIS_TASK_H
#include "model/load.h"
#include "synthesis/motions/poses.h"
#include <yoke/mechanism.h>

typedef enum YkTaskKind {
    YK_TASK_MOTION,
    YK_TASK_FUNCTION,
    YK_TASK_STROKE,
    YK_TASK_PATH,
    YK_TASK_MACHINE,
    YK_TASK_KINDS
} YkTaskKind;

// A range; is_given false: unbounded.
typedef struct YkBound {
    double low, high;
    bool is_given;
} YkBound;

typedef struct YkGiven { // a value that may be left out
    double value;
    bool is_given;
} YkGiven;

typedef struct YkGivenPoint {
    YkVec at;
    bool is_given;
} YkGivenPoint;

enum { YK_SIDES = 2, YK_PAIRS_MAX = 5 }; // input and output

// `synthesis: motion`
typedef struct YkMotionTask {
    YkPose *pose; // [conditions]: positions, and then rates
    YkPlace *place;
    size_t count, conditions;     // of positions; with rates
    size_t rate_of[YK_POSES_MAX]; // the position of rate k
    YkGivenPoint pivot[YK_SIDES];
} YkMotionTask;

// `synthesis: function`
typedef struct YkFunctionTask {
    const YkExpr *of;             // in YK_OWN_ARGUMENT; NULL: pairs
    YkBound range;                // of x
    double input, output;         // the ranges of the angles, rad
    double pair[YK_PAIRS_MAX][2]; // input and output angle from the start, rad, ascending inputs
    size_t count;
    bool is_slider;                          // the output is a slider's: its range and pairs are lengths, m
    YkGiven phase[YK_SIDES], ground, travel; // rad (of a slider m), m
    bool evened;                             // the largest errors are made alike
    YkPlace place;
} YkFunctionTask;

// `synthesis: stroke`
typedef struct YkStrokeTask {
    bool is_slider;
    double stroke, ratio;                   // rad or m; time ratio >= 1
    YkGiven ground, input, coupler, output; // lengths, at most one of them, m
    YkPlace place;
} YkStrokeTask;

// How the input's angles at the points of a path are given.
typedef enum YkPathTiming { YK_TIMING_ANY, YK_TIMING_STEP, YK_TIMING_ANGLES } YkPathTiming;

enum { YK_PATH_POINTS_MAX = 1000 };

// `synthesis: path`
typedef struct YkPathTask {
    YkVec *point; // [count], m
    size_t count;
    bool is_closed;
    YkPathTiming timing;
    double *angle;    // [count], rad; NULL unless they are given
    bool from_ground; // they are counted from the line from input to output pivot; otherwise absolute
    double step;      // between successive points, rad
    YkGivenPoint pivot[YK_SIDES];
    YkGiven ground_angle;
    YkPlace place;
} YkPathTask;

// A goal of `synthesis: machine`: points that a point passes, a value that a channel keeps, or one that is to be small.
typedef enum YkGoalKind { YK_GOAL_THROUGH, YK_GOAL_EQUALS, YK_GOAL_LEAST } YkGoalKind;
typedef struct YkGoal {
    YkGoalKind kind;
    size_t channel[2]; // of the task; a point's x and y
    YkVec *point;      // [count], m
    size_t count;
    double equals, weight;
    YkBound where; // of the input
} YkGoal;

// A claim such as min(B.transmission) > 35 deg.
typedef enum YkMeasure { YK_MEASURE_MIN, YK_MEASURE_MAX, YK_MEASURE_MAX_ABS } YkMeasure;
typedef struct YkClaim {
    size_t channel;
    YkMeasure measure;
    bool is_below; // the measure is to be less than the limit; otherwise greater
    double limit;
} YkClaim;

enum { YK_FREE_MAX = 32, YK_TASK_CHANNELS = 64 };

// `synthesis: machine`
typedef struct YkMachineTask {
    YkModel *model;
    YkMechanism *mech; // the swept coordinate is its first input
    const char **name; // [free_count]
    YkBound *range;    // [free_count], SI
    size_t free_count, coordinate, steps;
    double steps_read;
    YkBound over; // of the coordinate
    YkGoal *goal; // [goal_count]
    YkClaim *claim;
    size_t goal_count, claim_count;
    YkChannel channel[YK_TASK_CHANNELS];
    size_t channel_count;
    YkPlace place;
} YkMachineTask;

struct YkTask {
    YkModel *sheet; // units, parameters, name, memory
    YkTaskKind kind;
    YkBound lengths, coupler_point, pivots[2]; // of x and y
    YkGiven transmission, size_ratio;
    bool turns, moves, any_order;
    bool has_four_bar, has_slider; // the mechanisms that are sought
    unsigned kinds;                // of a path: bit k is set if machines of the YkDesignKind k are sought
    size_t best;
    YkMotionTask motion;
    YkFunctionTask function;
    YkStrokeTask stroke;
    YkPathTask path;
    YkMachineTask machine;
    YkPlace kind_place;
};

// A task while its file is read.
typedef struct YkTaskReader {
    YkTask *task;
    YkLoader *loader;
    double best, samples; // as read
} YkTaskReader;

// task_read.c: values, each reported with its place if it is wrong.
void yk_task_value(YkTaskReader *reader, const YkNode *map, const char *key, YkDimension dimension, YkGiven *given);
void yk_task_need(YkTaskReader *reader, const YkNode *map, const char *key, YkDimension dimension, double *value);
void yk_task_bound(YkTaskReader *reader, const YkNode *node, const char *key, YkDimension dimension, YkBound *bound);
void yk_task_point(YkTaskReader *reader, const YkNode *map, const char *key, YkGivenPoint *point);
bool yk_task_word(YkTaskReader *reader, const YkNode *map, const char *key, const char *const *words, size_t *found);
bool yk_task_yes(YkTaskReader *reader, const YkNode *map, const char *key, bool otherwise);

// The kinds, one file each: the first pass, and the checks of values.
void yk_task_read_motion(YkTaskReader *reader);
void yk_task_check_motion(YkTaskReader *reader);
void yk_task_read_function(YkTaskReader *reader);
void yk_task_check_function(YkTaskReader *reader);
void yk_task_read_stroke(YkTaskReader *reader);
void yk_task_check_stroke(YkTaskReader *reader);
void yk_task_read_machine(YkTaskReader *reader);
void yk_task_check_machine(YkTaskReader *reader);
void yk_task_read_path(YkTaskReader *reader);
void yk_task_check_path(YkTaskReader *reader);

// task_claims.c: passes on that memory ran out while something else was read. Returns whether it did.
bool yk_task_out_of_memory(YkTaskReader *reader, const YkProblems *own);
// The channel of a machine task by its name, reported if there is none. Returns YK_NOT_FOUND then.
size_t yk_task_channel(YkTaskReader *reader, const YkNode *node, const char *name);
// Reads max(abs(CHANNEL)), max(CHANNEL) or min(CHANNEL). Returns where it ends, or NULL after a mistake.
const char *yk_task_measure(YkTaskReader *reader, const YkNode *node, YkMeasure *measure, size_t *channel);
// Reads a claim such as `min(B.transmission) > 35 deg`.
bool yk_task_claim(YkTaskReader *reader, const YkNode *node, YkClaim *claim);

// Evaluates the function of the task at x. Returns false if it has no value there.
bool yk_task_function(const YkTask *task, double x, double *value);

#endif
