// Larger Assur groups: Newton's method on all loops of the group, and on the gears and cams that need them, together;
// one pose at a time.
#ifndef SOLVE_GROUP_H
#define SOLVE_GROUP_H
#include "base/pace.h"
#include "solve/space.h"

enum { YK_GROUP_SOLUTIONS_MAX = 32 };

typedef struct YkGroupWork {
    double *x; // [group column]: guess in, solution out (angles rad, distances m)
    double *residual, *J, *A, *scale, *step, *trial, *tau;
    int *pivot;
    size_t *order;
    double *solutions; // [YK_GROUP_SOLUTIONS_MAX][largest group]
    bool at_guess;     // while searching: a solution at the guess itself is the nearest, so no other is sought
    bool global;  // damp the steps and start anywhere (assembling); otherwise accept only a nearby solution (tracking)
    double moved; // distance of the last solution from its guess: largest change, rad or lengths over the size
    YkPace *pace; // of the long call that is being worked for, or NULL
    void *memory;
} YkGroupWork;

bool yk_group_start(YkGroupWork *work, const YkMechanism *mech);
void yk_group_end(YkGroupWork *work);
// Solves block `index` in lane 0 from run->groups->x: positions, and rates from the same factors. Makes the margin
// negative when it fails or, with branch != 0, when the determinant has the other sign.
struct YkRun;
void yk_group_solve(const struct YkRun *run, size_t index, int branch);
// Returns the sign of the block's determinant at its present pose (+1, -1; 0 when singular).
int yk_group_sign(const struct YkRun *run, size_t index);
// Returns the residual of the block's loops and relations at run->groups->x, as a length, m.
double yk_group_miss(const struct YkRun *run, size_t index);
// Searches for solutions from many starts (seeded); writes them to groups->solutions in a fixed order, returns their
// number. Large groups get fewer starts, so that the search ends after some 1e9 multiplications.
size_t yk_group_search(const struct YkRun *run, size_t index);

#endif
