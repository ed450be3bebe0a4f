// Judges at a closed pose which equations determine which unknowns: if equations repeat each other, counting is not
// enough.
#ifndef COMPILE_JUDGE_H
#define COMPILE_JUDGE_H
#include "compile/closure.h"
#include "compile/plan.h"

// Returns whether the loop of plan->list determines these one or two unknowns: their columns are independent there.
// True if there is no pose to judge by.
bool yk_judge_block(const YkPlan *plan, const YkColumn *columns, size_t count);

// Judges equations one after another: which of their rows say something new about the unknowns.
typedef struct YkJudge {
    const YkPlan *plan;
    int32_t *place; // per column id (orientations, then distances): its index among the unknowns, or YK_NONE
    size_t unknowns, taken;
    double *rows;     // [taken][unknowns], orthonormal
    double *next;     // [2][unknowns], of the present equation
    double *gradient; // [variables], of a relation
} YkJudge;

// Starts with the columns listed, by their ids, as unknowns. Returns false when out of memory.
bool yk_judge_start(YkJudge *judge, YkPlan *plan, const int32_t *ids, size_t count);
// Returns how many rows of a loop (0 to 2), or of a relation (0 or 1), are independent of all taken before; takes them.
size_t yk_judge_loop(YkJudge *judge, const YkSum *sum);
size_t yk_judge_relation(YkJudge *judge, size_t relation);

// Returns whether a column belongs to a part of the machine that is judged.
static inline bool yk_is_judged(const YkPlan *plan, YkColumn c)
{
    if (!plan->pose) return false;
    return plan->pose->is_repeated[c.is_distance ? (int32_t)plan->mech->orientation_count - 1 + c.index : c.index - 1];
}

#endif
