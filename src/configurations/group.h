// All solutions of one group at a pose, proved.
#ifndef CONFIGURATIONS_GROUP_H
#define CONFIGURATIONS_GROUP_H
#include <yoke/configurations.h>
#include "configurations/certify.h"
#include "configurations/matroid.h"
#include "configurations/generic.h"

// Kept for a group from pose to pose.
typedef struct YkGroupKept {
    YkOutside outside;
    YkGroupSolver solver;
    YkShape shape;
    YkMatroid matroid; // of the pose for which `expected` was counted
    bool is_counted;
    size_t expected;
    YkGeneric generic;
} YkGroupKept;

typedef struct YkProved { // a complex solution
    YkVec x[2 * YK_SYSTEM_LOOPS_MAX];
    YkCertificate certificate;
} YkProved;

// The solutions at a pose; the arrays are kept and reused.
typedef struct YkGroupSolutions {
    YkProved *proved;
    size_t proved_count, proved_capacity;
    double *real; // [real_count][columns of the group]: angles, rad; distances, m
    size_t real_count, real_capacity;
    bool is_counted; // whether `expected` is known
    size_t expected;
    bool is_complete; // all complex solutions are proved, and it is known of each whether it is real
    size_t unclear;   // number of proved ones of which that is not known
    YkVec *pose; // the coefficients of this pose, once it is solved; a pose that is solved again is not followed again
    bool has_pose;
} YkGroupSolutions;

typedef enum YkGroupStatus { YK_GROUP_SOLVED, YK_GROUP_OUTSIDE, YK_GROUP_STOPPED, YK_GROUP_NO_MEMORY } YkGroupStatus;

void yk_group_kept_end(YkGroupKept *kept);
void yk_group_solutions_end(YkGroupSolutions *solutions);
// Copies the solutions of a pose; the arrays of `to` are reused. Returns false when out of memory.
bool yk_group_solutions_copy(YkGroupSolutions *to, const YkGroupSolutions *from, const YkShape *shape);
// Solves the system with these coefficients; the second half must be the conjugates of the first. size: that of the
// machine, m.
YkGroupStatus yk_group_solve_at(YkGroupKept *kept, const YkVec *pose, double size, YkPace *pace, YkGroupSolutions *out);
// Does the same from the solutions that `out` has of another pose nearby, by Newton's method, where that finds and
// proves as many as the generic system has; follows the paths where it does not.
YkGroupStatus yk_group_solve_near(YkGroupKept *kept, const YkVec *pose, double size, YkPace *pace,
                                  YkGroupSolutions *out);
// Solves block `index` at the pose of `run`, in which earlier blocks are solved. kept->outside and kept->shape must
// have been read.
YkGroupStatus yk_group_solve_all(YkGroupKept *kept, const YkRun *run, size_t index, YkPace *pace,
                                 YkGroupSolutions *out);

#endif
