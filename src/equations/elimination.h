// The order of elimination: how the equations of motion of a whole machine are reduced to its free inputs.
//
// Accelerations are the unknowns: those of every orientation, distance and node (two components) in the steps of
// solution. Inertia and loads give a quadratic form over them (Gauss's principle of least constraint); each step
// defines its unknowns linearly by earlier ones. Going backwards through the steps substitutes what each step defines,
// and minimises over a free input as soon as no remaining unknown depends on it. For trees this is the articulated-body
// recursion; for chains of loops and ladders, too, the cost is linear in the number of bodies: the fill-in is found
// once, here.
#ifndef EQUATIONS_ELIMINATION_H
#define EQUATIONS_ELIMINATION_H
#include "compile/mechanism.h"

// One turned vector of a sum, and the columns of the sum's gradient to which it contributes. u = e(root) e(slot) v
// (times the distance): columns turn[0], turn[1] get i u; column `along` gets u without its distance.
typedef struct YkGradientPiece {
    int32_t root, slot, distance; // slots 0: none
    int32_t turn[2], along;       // columns, or YK_NONE
    int32_t row;                  // loop of a group; 0 otherwise
    int32_t unit;                 // in a plain gradient: root or slot, whichever is set
    YkVec v;
} YkGradientPiece;

// A vector (or, in a group, several) as a function of the unknowns.
typedef struct YkGradient {
    uint32_t first_piece, piece_count;
    uint32_t first_node, node_count; // in `nodes`
    uint32_t columns;                // how many; of an operation, its own unknowns come first
    bool is_plain;                   // one turned vector for each column, in order: no nodes, distances or inner turns
} YkGradient;

typedef struct YkNodePart { // +node or -node; columns `column`, `column` + 1
    int32_t node, column, row;
    double sign;
} YkNodePart;

typedef enum YkOperationKind {
    YK_OP_FREE,     // one unknown, free: minimised over
    YK_OP_KNOWN,    // one unknown, a prescribed input on the ground: nothing to solve
    YK_OP_COPY,     // one unknown, the sum of the others
    YK_OP_RELATION, // one unknown, by a gear, rack, belt or cam
    YK_OP_NODE,     // two unknowns: a sum
    YK_OP_PAIR,     // two unknowns of a dyad, from its loop
    YK_OP_SINGLE,   // one unknown of a loop that repeats constraints
    YK_OP_GROUP     // the unknowns of a group, from its loops and relations
} YkOperationKind;

// Unknowns U (own) are C W of others; Z are further neighbours. Entry: an address in the form's storage.
typedef struct YkOperation {
    YkOperationKind kind;
    int32_t input;                   // FREE, KNOWN and COPY by an input: its index; otherwise YK_NONE
    uint32_t own, given, neighbours; // |U|, |W|, |W| + |Z|
    YkGradient gradient;             // columns: U, then W
    uint32_t first_index;       // in `index`: U, then W, Z, then entries of U x U (upper), U x (W + Z), and of pairs
    uint32_t first_coefficient; // C[own][given]; FREE: none
    uint32_t first_element, element_count; // bodies whose latest unknown this operation defines
    uint32_t block;                        // or index of the relation
    uint32_t first_factor; // RELATION, GROUP: rows in `factors`, two for each column (U, then W): constant, and times
                           // the law's slope; one row for each relation of a group
} YkOperation;

typedef struct YkElement { // a body with mass or load
    int32_t body;
    double mass, inertia;
    YkVec constant;
    YkGradient gradient;
    int32_t rotation;     // column of its own orientation, or YK_NONE
    uint32_t first_index; // in `index`: unknowns, then entries of pairs (upper, with diagonal)
} YkElement;

typedef struct YkElimination {
    YkArena *arena; // of arrays by operation, element and input
    const YkMechanism *mech;
    YkOperation *operations; // in forward order; eliminated backwards
    size_t operation_count;
    YkElement *elements; // by operation
    size_t element_count;
    YkGradientPiece *pieces;
    size_t piece_count, piece_capacity;
    YkNodePart *nodes;
    size_t node_count, node_capacity;
    int32_t *index;
    size_t index_count, index_capacity;
    double *factors;
    size_t factor_count, factor_capacity;
    size_t unknown_count; // scalars
    size_t entry_count;   // of the form
    size_t coefficient_count;
    size_t widest;               // most columns or neighbours of any operation or element
    size_t largest_group;        // most unknowns or equations of a group
    int32_t *operation_of_input; // YK_NONE if it does not take part
    int32_t *parent_of_input;    // angle inputs: unknown of the orientation from which it turns, or 0
    double *sign_of_input;
    bool *is_back_needed; // per operation: whether a free input's acceleration depends on its unknowns
} YkElimination;

// is_free[input]; is_loaded[body]: loads may act on it. Returns NULL when out of memory.
YkElimination *yk_elimination_new(const YkMechanism *mech, const bool *is_free, const bool *is_loaded);
void yk_elimination_free(YkElimination *elimination);

// Return unknowns by number.
static inline int32_t yk_unknown_of_slot(int32_t slot)
{
    return slot;
} // 0: the ground, which is not an unknown
static inline int32_t yk_unknown_of_distance(const YkMechanism *mech, int32_t distance)
{
    return (int32_t)mech->slot_count + distance;
}
static inline int32_t yk_unknown_of_node(const YkMechanism *mech, int32_t node)
{
    return (int32_t)(mech->slot_count + mech->distance_count) + 2 * node;
}

#endif
