// The reduced equations of machines with few free inputs, by influence coefficients: how fast every unknown moves for
// a unit rate of each free input, carried outwards through the steps; then inertia and forces are summed over the
// bodies, M = sum of m J^T J + I R^T R. Cost linear in the machine, times the free inputs (squared for the sums):
// for one or two, much less than the elimination, which it has the order and the gradients from.
// Source: Eksergian, "Dynamical analysis of machines", J. Franklin Inst. 209-211 (1930-31); Paul, "Kinematics and
// Dynamics of Planar Machinery" (1979), ch. 9.
#ifndef DYNAMICS_INFLUENCE_H
#define DYNAMICS_INFLUENCE_H
#include "dynamics/coefficients.h"
#include "dynamics/loads.h"

enum { YK_INFLUENCE_MAX = 4 }; // free inputs

// u = e(turn) v, whose quarter turn is a column of a plain gradient, and the unknown that it belongs to.
typedef struct YkInfluenceTerm {
    int32_t turn, unknown; // places in the space's data and in R
    YkVec v;
    double inertia; // of a body about v's end: m v^2, and its own where this is what it turns with
} YkInfluenceTerm;

typedef enum YkInfluenceKind {
    YK_CARRY_PAIR,  // a dyad with a plain gradient
    YK_CARRY_OTHER, // any other operation
    YK_ADD_PIVOTED, // a body with a plain gradient of one term: it turns about a fixed point
    YK_ADD_CARRIED, // of two: it turns about a point that turns about a fixed one
    YK_ADD_OTHER    // any other body
} YkInfluenceKind;

// What is done, in order: one short row each, so that a machine streams through the cache.
typedef struct YkInfluenceMove {
    YkInfluenceKind kind;
    uint32_t index;      // of the operation or the element
    uint32_t first_term; // PAIR, PIVOTED, CARRIED
    uint32_t term_count;
} YkInfluenceMove;

typedef struct YkInfluenceBody { // of the elements, in the order of the moves
    double mass, inertia;
    int32_t body, turn, rotation; // of the model; of its own orientation and that unknown's place in R, or YK_NONE
} YkInfluenceBody;

typedef struct YkInfluence {
    const YkElimination *e;
    size_t free_count, width;          // columns of R: 1, 2 or 4, those beyond the free inputs 0
    int32_t input[YK_INFLUENCE_MAX];   // in the order in which they are freed
    int32_t unknown[YK_INFLUENCE_MAX]; // whose acceleration beyond its parent's is the input's
    YkVec gravity;
    bool has_gravity;
    YkInfluenceMove *moves;
    size_t move_count;
    YkInfluenceTerm *terms;
    size_t term_count;
    YkInfluenceBody *bodies;
    double *R; // [unknown][width]
    double *C; // coefficients of the operation in work
    YkCoefficients work;
} YkInfluence;

// NULL when out of memory. free_count: of the inputs that the elimination has as free, at most YK_INFLUENCE_MAX.
YkInfluence *yk_influence_new(const YkElimination *elimination, size_t free_count);
void yk_influence_free(YkInfluence *influence);
// Accelerations of the free inputs at the pose of the space (lane 0), whose accelerations are those of all free inputs
// at 0; others' entries stay. loads[body] without gravity, or NULL: none. Returns -1; otherwise the input of a freedom
// without inertia, or -2 at a singular group. Allocates nothing.
int yk_influence_accelerate(YkInfluence *influence, const YkSpace *space, const YkLoad *loads, double *acceleration);

#endif
