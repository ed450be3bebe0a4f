// The reduced equations of machines with few free inputs, by influence coefficients: how fast every unknown moves for a
// unit rate of each free input. They are carried outwards through the steps; then inertia and forces are summed over
// the bodies, M = sum of m J^T J + I R^T R. If a machine has one input and it moves, the rates in its pose already are
// the coefficients times the input's rate: the sums are then twice the kinetic energy, and the power.
//
// The cost is linear in the machine, times the free inputs (squared for the sums): for few of them much less than the
// elimination, from which it takes the order and the gradients.
// Source: Eksergian, "Dynamical analysis of machines", J. Franklin Inst. 209-211 (1930-31); Paul, "Kinematics and
// Dynamics of Planar Machinery" (1979), ch. 9.
#ifndef EQUATIONS_INFLUENCE_H
#define EQUATIONS_INFLUENCE_H
#include "equations/coefficients.h"
#include "loads/loads.h"

enum { YK_INFLUENCE_MAX = 4 }; // free inputs

// u = e(turn) v, whose quarter turn is a column of a plain gradient, and the unknown of that column.
typedef struct YkInfluenceTerm {
    int32_t turn, unknown; // indices in the space's data and in R
    YkVec v;
} YkInfluenceTerm;

// Terms: c0 R0 + c1 R1 + the others' share = 0. None if the operation is not a dyad with a plain gradient.
typedef struct YkInfluenceCarry {
    uint32_t operation, first_term, term_count;
} YkInfluenceCarry;

// Bodies, by the motion of their reference points: short rows, so that a machine streams through the cache.
typedef struct YkPivotedBody { // a plain gradient of one term: it turns about a fixed point
    YkInfluenceTerm term;
    double about, mass; // inertia about that point: m v^2, plus its own if it turns itself
    int32_t body;       // of the model
    bool turns;
} YkPivotedBody;

typedef struct YkCarriedBody { // of two terms: it turns about a point that turns about a fixed one
    YkInfluenceTerm term[2];
    double about[2], mass; // inertias about the terms' ends, its own with the term with which it turns
    int32_t body, own;     // of the model; that term, or YK_NONE
} YkCarriedBody;

typedef struct YkOtherBody {
    uint32_t element;             // of the elimination
    int32_t body, turn, rotation; // of the model; its orientation's index in the space's data and in R, or YK_NONE
    double mass, inertia;         // about its reference point
} YkOtherBody;

typedef struct YkInfluence {
    YkArena *arena; // of all arrays
    const YkElimination *e;
    size_t free_count, width;          // columns of R: 1, 2 or 4, those beyond the free inputs 0
    int32_t input[YK_INFLUENCE_MAX];   // in the order in which they are freed
    int32_t unknown[YK_INFLUENCE_MAX]; // whose acceleration beyond its parent's is the input's
    YkInfluenceCarry *carries;
    size_t carry_count;
    YkInfluenceTerm *terms; // of the carries
    size_t term_count;
    YkPivotedBody *pivoted;
    YkCarriedBody *carried;
    YkOtherBody *others;
    size_t pivoted_count, carried_count, other_count;
    double *R; // [unknown][width]
    double *C; // coefficients of the present operation
    YkCoefficients work;
} YkInfluence;

// Returns NULL when out of memory. free_count: number of inputs that are free in the elimination, at most
// YK_INFLUENCE_MAX.
YkInfluence *yk_influence_new(const YkElimination *elimination, size_t free_count);
void yk_influence_free(YkInfluence *influence);
// Finds the accelerations of the free inputs at the pose of the state, in which they are 0; the entries of other inputs
// stay. loads[body] without gravity, or NULL: none; is_loaded[body]: whether it may have one. Returns -1; otherwise the
// input of a freedom without inertia, or -2 at a singular group. Allocates nothing.
int yk_influence_accelerate(YkInfluence *influence, const YkState *state, const YkLoad *loads, const bool *is_loaded,
                            double *acceleration);

#endif
