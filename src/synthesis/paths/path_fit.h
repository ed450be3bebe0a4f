// Least squares for a path: a bar's dimensions and its input's angles, so that its coupler point passes the points.
#ifndef SYNTHESIS_PATH_FIT_H
#define SYNTHESIS_PATH_FIT_H
#include "base/memory.h"
#include "synthesis/paths/path_bar.h"

enum { YK_PATH_UNKNOWNS = YK_BAR_SIZE + 1, YK_PATH_LIMITS = 12 }; // one more shifts angles with a given step

// The problem: points, bounds of the dimensions, and how the angles follow.
typedef struct YkPathProblem {
    const YkTask *task;
    const YkVec *point;  // [count], m
    const double *angle; // [count] of the input where they are given, otherwise NULL, rad
    double step;         // between points where it is given, rad
    size_t count;
    YkDesignKind kind;
    size_t dimensions;                                   // their number; the unknown after them shifts the angles
    bool hangs_at_end, has_box, is_timed, shifts, turns; // box: for the pivot that is not a dimension
    bool follows;                                        // the angles are counted from the ground, and turn with it
    double low[YK_PATH_UNKNOWNS], high[YK_PATH_UNKNOWNS];
    double size; // of the points, m
    YkVec middle;
} YkPathProblem;

// A bar with the input's angle at each point.
typedef struct YkPathTry {
    YkBar bar;
    double *angle; // [count], rad
    double error;  // sum of squared distances, m^2
    double cost;   // with what limits add
} YkPathTry;

// Scratch space of fits for one problem.
typedef struct YkPathWork {
    YkBarPoint *now, *next; // [count]
    double *row, *miss;     // [rows][YK_PATH_UNKNOWNS], [rows]
    double *A, *b;          // with the damping
    double *angle;          // [count]
    size_t count;
    double weight; // of a limit's excess against a distance
} YkPathWork;

// Gives a try the angles that follow its ground, if the problem has such.
void yk_path_turn_angles(const YkPathProblem *problem, YkPathTry *try);
// Makes the scratch space in an arena. Returns false when out of memory.
bool yk_path_work(YkArena *arena, size_t count, YkPathWork *work);
// Finds error and cost. Returns false if the bar does not close at some point.
bool yk_path_measure(const YkPathProblem *problem, YkPathWork *work, YkPathTry *try);
// Improves a try by at most `steps` steps of Levenberg and Marquardt within the bounds. Angles that are free follow the
// dimensions: each is eliminated from its own point's two equations. Returns false if the try does not close.
// Cost of a step: O(count). Source: More 1978; variable projection: Golub & Pereyra 1973.
bool yk_path_improve(const YkPathProblem *problem, YkPathWork *work, YkPathTry *try, size_t steps);

// path_limits.c: what bounds of single dimensions cannot say, each as a length that must not be positive, m, with its
// derivatives by the dimensions. Returns their number.
size_t yk_path_limits(const YkPathProblem *problem, const YkBar *bar, double excess[YK_PATH_LIMITS],
                      double by[YK_PATH_LIMITS][YK_BAR_SIZE]);

#endif
