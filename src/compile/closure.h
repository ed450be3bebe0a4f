// The closure errors of the tree's loops and their Jacobian; and the freedom by its rank.
#ifndef COMPILE_CLOSURE_H
#define COMPILE_CLOSURE_H
#include "compile/mechanism.h"

// Variables x: angles of orientations 1.. then distances.
static inline size_t yk_variable_count(const YkMechanism *mech)
{
    return mech->orientation_count - 1 + mech->distance_count;
}
// Evaluates one loop: residual[2], and its two rows of J[2][n] row-major, or NULL; the caller has zeroed them. Variable
// v belongs in column[v] (column NULL: in column v).
void yk_closure_loop(const YkMechanism *mech, size_t loop, const double *x, double *residual, double *J, size_t n,
                     const int32_t *column);
// Evaluates one relation, divided by its weight to give a length. Its row of J[n] likewise.
void yk_closure_relation(const YkMechanism *mech, size_t relation, const double *x, double *residual, double *J,
                         const int32_t *column);
// Evaluates all loops: residual[2 loops]; jacobian[2 loops][variables] row-major, or NULL.
void yk_closure(const YkMechanism *mech, const double *x, double *residual, double *jacobian);
// Maps the guesses from `start:` (0 if unknown) to variables along the tree; distances that are not coordinates take
// the values at which their loops come nearest to closing. Cost O(bodies log coordinates + terms of all loops).
void yk_closure_guess(const YkMechanism *mech, const double *coordinates, double *x);

// Finds the freedom by rank, and which candidates are independent inputs: closes the loops, with their relations, from
// the guesses and takes the rank of their Jacobian there. Measures parts of the machine that share only the ground one
// by one. accepted[] keeps what the caller put there in a part that does not close, or has more than YK_CLOSURE_MAX
// variables (the work is dense), and also where equations do not repeat each other and it determines the motion.
// freedom: of the whole machine, or -1 if a part could not be measured. Returns false when out of memory.
enum { YK_CLOSURE_MAX = 300 };
#define YK_CLOSURE_ROUNDING 1e-13 // over the size: a shorter arm is what rounding leaves of points that coincide
typedef struct YkCandidates {
    const int32_t *items; // coordinates in order of preference
    size_t count, firm;   // the first `firm` were requested, or are driven
    bool *accepted;       // [count]
    bool is_peeled;       // all are dyads: the count stands unless the guesses close as they are
} YkCandidates;
// A closed pose by which an order of solution is judged: that of the guesses, or one close by if the accepted inputs do
// not determine the motion at the guesses.
typedef struct YkClosedPose {
    double *x;         // [variables]
    bool *is_repeated; // [variables]: it belongs to a part that closes there and whose equations repeat each other
} YkClosedPose;
// pose: filled unless NULL; the caller has cleared is_repeated.
bool yk_closure_freedom(const YkMechanism *mech, const double *guess, const YkCandidates *wish, int *freedom,
                        const YkClosedPose *pose);

#endif
