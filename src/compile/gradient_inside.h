// The inside of YkGradient.
#ifndef COMPILE_GRADIENT_INSIDE_H
#define COMPILE_GRADIENT_INSIDE_H
#include "compile/gradient.h"
#include "compile/variant.h"

enum { YK_JET = 3 };
typedef struct YkVecJet { // a vector and its derivatives by time, or the shares of an answer by them
    YkVec v[YK_JET];
} YkVecJet;

typedef struct YkSlotAngle { // the angle of a slot: that of one orientation, less that of another or 0
    int32_t of, from;
} YkSlotAngle;

typedef struct YkSlotTurn {
    YkVec unit;
    double rate, accel;
} YkSlotTurn;

struct YkGradient {
    YkArena *arena; // of all arrays
    const YkMechanism *mech;
    const YkModel *model;
    const YkRedesign *redesign;
    const YkRecipe *recipe;
    size_t parameters, variables, rows;
    YkSlotAngle *slot;
    // The design's:
    int32_t *point, *joint; // points that vary; joints whose direction does
    size_t point_count, joint_count;
    double *by_point, *by_joint; // [point][x, y][parameter]; [joint][parameter]
    double *by_parameter;        // [parameter of the model][parameter]
    double *direction;           // [parameter of the model]: a change of all of them
    // The pose's:
    double *x;        // [order][variable]
    YkSlotTurn *turn; // [slot]
    YkVecJet *node;   // [node]: where it is
    double *J, *tau;
    size_t *order;
    // An answer's, collected backwards:
    double *by_x, *lambda; // by_x[order][variable]
    YkVecJet *at_node;     // [node]
    YkVec *at_vector;      // [node of the recipe], in the axes of its slot
    YkVec *at_point;       // [point], in the axes of its body
    double *at_direction;  // [joint]: by its angle
    double *at_parameter;  // [parameter of the model]
};

static inline size_t yk_gradient_variable(const YkGradient *g, int32_t distance)
{
    return g->mech->orientation_count - 1 + (size_t)distance;
}
// gradient_shares.c: hand the shares of an answer by a sum and a relation's derivative on to what they are made of.
void yk_gradient_take_sum(YkGradient *gradient, const YkSum *sum, const YkVecJet *by);
void yk_gradient_take_relation(YkGradient *gradient, size_t relation, size_t order, double by);
// Finds where slots and nodes are at the present x.
void yk_gradient_place(YkGradient *gradient);
// Hand the shares of nodes on to their sums; those of vectors to points and directions.
void yk_gradient_settle_nodes(YkGradient *gradient);
void yk_gradient_settle_vectors(YkGradient *gradient);

#endif
