// The inside of YkMechanism: the machine as sums of turned vectors, and the steps that solve it.
//
// Bodies that never turn relative to each other (joined by slides and welds) share an *orientation* o with one unit
// vector e^(i Phi_o); a body keeps a constant angle `turn` to it. A joint that slides has a *distance* d. Every loop
// and every position is a sum of vectors v e^(i Phi_o) and d v e^(i Phi_o). Orientation 0 is the ground's. An angle
// that is an input ties two orientations together: they form a *group*, solved as one unknown.
#ifndef COMPILE_MECHANISM_H
#define COMPILE_MECHANISM_H
#include <stdbool.h>
#include <stdint.h>
#include <yoke/mechanism.h>
#include "compile/arms.h"
#include "model/model.h"

// v e^(i Phi_slot), times the distance if there is one. Slots: the orientations, then their relative orientations.
typedef struct YkTerm {
    int32_t slot;     // 0: the ground
    int32_t distance; // or YK_NONE
    YkVec v;
} YkTerm;

// constant + node[plus] - node[minus] + terms[first .. first + count)
typedef struct YkSum {
    YkVec constant;
    int32_t plus, minus; // nodes, or YK_NONE
    uint32_t first, count;
} YkSum;

// A spanning forest over the bodies: how to walk from body to body.
typedef struct YkTree {
    int32_t *parent, *joint; // YK_NONE at a root
    int32_t *depth;
} YkTree;

typedef struct YkPlacing { // where a body is
    int32_t orientation;
    double turn; // angle of the body to its orientation, rad
    YkVec turn_unit;
    YkSum origin; // of the body's origin in the world; valid for bodies placed
} YkPlacing;

// The angle of a joint: Phi_b - Phi_a + offset.
typedef struct YkJointAngle {
    int32_t a, b;
    double offset;
} YkJointAngle;

// A coordinate of the spanning tree.
typedef struct YkTreeCoordinate {
    const char *name;
    int32_t joint;
    bool is_distance, is_declared, has_start; // has_start: `start:` gives its value
    int32_t drive;                            // of the model, or YK_NONE
    int32_t input;                            // or YK_NONE
    int32_t distance;                         // its distance variable, or YK_NONE
    YkJointAngle angle;                       // of its joint
    // If gears and the like make the angle a sum of inputs: that sum, exact over any number of turns.
    bool is_sum;
    double sum_offset;
    uint32_t first_source, source_count; // in sources
} YkTreeCoordinate;

typedef struct YkLoop { // of the spanning tree: the first body's point minus the second's
    int32_t joint;
    YkSum sum; // slots are orientations; all distances included; no nodes
} YkLoop;

// A relation: a gear, rack, belt, cam or law ties angles of bodies and distances:
// sum of factor * x - law(sum of factor * argument) = constant. Angles are those of orientations (absolute).
typedef struct YkRelationTerm {
    bool is_distance;
    int32_t index; // orientation or distance
    double factor;
} YkRelationTerm;

typedef enum YkRelationKind {
    YK_RELATION_GEAR,
    YK_RELATION_RACK,
    YK_RELATION_BELT,
    YK_RELATION_CAM,
    YK_RELATION_LAW
} YkRelationKind;

// The source of a value in a relation: an input, an orientation that loops place (its angle nearest to a reference kept
// in the state), a distance, or an unknown of the group in which the relation is solved (its index there).
typedef enum YkSourceKind { YK_SOURCE_INPUT, YK_SOURCE_SLOT, YK_SOURCE_DISTANCE, YK_SOURCE_COLUMN } YkSourceKind;
typedef struct YkRelationSource {
    YkSourceKind kind;
    int32_t index, reference;
    double factor;
} YkRelationSource;

typedef struct YkRelation {
    YkRelationKind kind;
    int32_t index; // index of the model's gear, rack, belt, cam or drive
    const char *name;
    uint32_t first_term, term_count; // in relation_terms
    uint32_t first_argument, argument_count;
    const YkLaw *law; // NULL: none
    double constant, argument_constant;
    // Solved for a target: value = offset + sources + gain law(argument_offset + argument sources). In a group, or if
    // it only repeats others, that value is its residual, in metres.
    bool is_solved, is_redundant;
    YkRelationTerm target;
    uint32_t first_source, source_count, first_argument_source, argument_source_count; // in sources
    double offset, argument_offset, gain;                                              // gain of the law
    double weight; // the factor on all of them, except on those of the argument; 0: the target's own
} YkRelation;

typedef enum YkStepKind {
    YK_STEP_TURN,     // slot = parent slot turned by input
    YK_STEP_COMPOSE,  // slot = parent slot turned by slot `other`
    YK_STEP_DISTANCE, // distance = input
    YK_STEP_NODE,     // node = sum
    YK_STEP_BLOCK,    // solve a block
    YK_STEP_RELATION, // orientation or distance from a relation; target: the relation
    YK_STEP_CHECK     // measures a relation that repeats others; target: the relation
} YkStepKind;

typedef struct YkStep {
    YkStepKind kind;
    int32_t target; // slot, distance, node or block
    int32_t parent, other, input;
    double offset, sign;
} YkStep;

typedef struct YkColumn { // an unknown
    bool is_distance;
    int32_t index; // orientation (a group's root) or distance
} YkColumn;

// How to solve a block of one pose in the common cases: constant arms; the line of an RRP fixed to the ground or
// turning, that of an RPR fixed in the body that turns.
typedef enum YkBlockForm {
    YK_FORM_RARE,
    YK_FORM_RRR_SHORT, // an arm is short beside the machine's size
    YK_FORM_RRR,
    YK_FORM_RRR_AXIAL, // both arms point along x
    YK_FORM_RRP,
    YK_FORM_RRP_AXIAL, // line and arm point along x
    YK_FORM_RRP_TURNING,
    YK_FORM_RPR,
    YK_FORM_RPR_AXIAL // the line points along x and passes through the pin
} YkBlockForm;

// Data that most poses do not read, in memory of its own.
typedef struct YkBlockAside {
    YkSum arm[2]; // RRR: U, W; RRP: W; RPR: C; LINK: U
    int32_t assur_class;
    uint32_t first_joint, joint_count; // in block_members
    uint32_t first_body, body_count;   // in block_members
} YkBlockAside;

typedef struct YkBlock {
    YkBlockKind kind;
    YkBlockForm form;
    // Dyads: known part, arms (in relative slots, in the axes of the unknown), lines. Members that a pose needs come
    // first.
    bool arm_is_constant[2];
    int32_t line_slot[2]; // RRP: orientation of the line; RPR: relative slot; PP: both; GUIDE: the line
    YkColumn column[2];   // RRR: Phi1, Phi2; RRP, RPR: Phi, d; PP: d1, d2
    YkSum known;
    union {
        YkArmPair pair; // RRR with constant arms
        struct {
            YkArmCircle circle; // RRP with a constant arm
            YkVec line[2];      // all others: constant unit vectors
        };
    };
    double per_size2; // 1 / size^2, see yk_block_size: the scale for a base or an arm that vanishes
    YkBlockAside *aside;
    const char *label;
    // Groups:
    uint32_t first_column, column_count;     // in group_columns
    uint32_t first_loop, loop_count;         // in group_loops: all terms, known and unknown
    uint32_t first_relation, relation_count; // in group_relations: one equation each, after those of the loops
} YkBlock;

// Computes the block's form, `pair` or `circle`, and `per_size2`. Call it after every change of its vectors or size.
void yk_block_measure(YkBlock *block, double size);

// Returns the number of equations of a group.
static inline size_t yk_block_rows(const YkBlock *block)
{
    return 2 * (size_t)block->loop_count + block->relation_count;
}

struct YkMechanism {
    YkArena *arena;
    const YkModel *model;
    double size;          // of the model
    double distance_unit; // what a distance's way is measured by where it compares with turns; see yk_distance_unit
    // Topology:
    YkPlacing *bodies;
    size_t orientation_count, distance_count;
    int32_t *orientation_body; // a body of each orientation (the one with turn 0)
    int32_t *joint_distance;   // per joint: its distance variable, or YK_NONE
    YkTree tree;               // of the coordinates
    int32_t *tree_order;       // bodies, parents before children
    YkTreeCoordinate *coordinates;
    size_t coordinate_count;
    YkLoop *loops;
    size_t loop_count;
    int32_t *inputs;
    size_t input_count; // coordinates
    // Groups of orientations tied by inputs:
    int32_t *group_root;    // per orientation
    int32_t *relative_slot; // per orientation: slot of e^(i (Phi_o - Phi_root)); 0 at a root
    size_t slot_count;
    YkSum *node_sums; // [node]: its position
    size_t node_count, node_capacity;
    // Solution:
    YkStep *steps;
    size_t step_count, step_capacity;
    YkBlock *blocks;
    size_t block_count, block_capacity;
    int32_t *block_members;
    size_t member_count, member_capacity;
    YkColumn *group_columns;
    size_t column_count, column_capacity;
    YkSum *group_loops;
    size_t group_loop_count, group_loop_capacity;
    int32_t *group_relations;
    size_t group_relation_count, group_relation_capacity;
    YkTerm *terms;
    size_t term_count, term_capacity;
    int32_t *redundant;
    size_t redundant_count, redundant_capacity; // joints
    size_t redundant_relation_count;            // relations that are only checked
    size_t largest_group;                       // columns or equations
    bool has_groups;
    // Relations:
    YkRelation *relations; // those of the model, then sums of relations that solve several together
    size_t relation_count, derived_count;
    YkRelationTerm *relation_terms;
    size_t relation_term_count, relation_term_capacity, own_term_count; // own: those of the model
    YkRelationSource *sources;
    size_t source_count, source_capacity, reference_count;
    int gruebler;
    const bool *open_cams;           // per cam of the model; NULL: none is open
    struct YkRecipe *recipe;         // only while compiling for a variant; otherwise NULL
    const struct YkVariant *variant; // whose mechanism it is, or NULL
};

// Returns whether some step measures how far loops gape: where none does, all gaps stay 0.
static inline bool yk_measures_gaps(const YkMechanism *mech)
{
    return mech->has_groups || mech->redundant_count + mech->redundant_relation_count > 0;
}
// Returns the angle of any joint.
YkJointAngle yk_joint_angle(const YkMechanism *mech, int32_t joint);
// Contacts: gears, belts, racks and cams, which transmit forces, counted in this order over the whole model. Their
// relations come first, laws after them; an open cam has none.
size_t yk_contact_count(const YkMechanism *mech);
const char *yk_contact_name(const YkMechanism *mech, size_t contact);
int32_t yk_contact_relation(const YkMechanism *mech, size_t contact); // YK_NONE: an open cam
size_t yk_contact_of_cam(const YkMechanism *mech, size_t cam);
// Returns the machine's size, unless its links are much smaller than that: a linkage of centimetres turns far while a
// rack in a model of hundreds of metres moves by a small part of its size. Then a hundred times the shortest arm of a
// dyad or pinion.
double yk_distance_unit(const YkMechanism *mech);
// Returns the size by which a block judges what vanishes: the machine's, unless all vectors of the dyad's loop together
// are less than a thousandth of it. Then theirs.
double yk_block_size(const YkMechanism *mech, const YkBlock *block);
// Returns the unit in which an input's way compares with turns: 1 rad, or that length.
static inline double yk_input_unit(const YkMechanism *mech, size_t input)
{
    return mech->coordinates[mech->inputs[input]].is_distance ? mech->distance_unit : 1;
}
// Returns the tree's coordinate of a joint, or YK_NONE. O(log coordinates).
int32_t yk_tree_coordinate(const YkMechanism *mech, int32_t joint, bool is_distance);
// Returns the relation by whose law a coordinate of the tree follows another one, or YK_NONE. O(relations).
int32_t yk_law_relation(const YkMechanism *mech, size_t coordinate);
// Writes the way to a body in the tree, in pieces: path[] gets its bodies from depth `from` on (1: next to the root),
// the body itself last, YK_TREE_PATH at most. Returns how many; 0 if the way has ended.
enum { YK_TREE_PATH = 512 };
size_t yk_tree_path(const YkMechanism *mech, int32_t body, size_t from, int32_t *path);
// Returns the factor that makes a relation's value a length: gears and the like are equations of angles, times teeth.
// Divided by the machine's size, a relation then weighs about as much as a loop. The factor is a power of two, so that
// it adds no rounding.
double yk_relation_weight(const YkMechanism *mech, const YkRelation *relation);
// Writes a body's point as a sum: its origin plus one term, which is returned separately.
YkTerm yk_body_term(const YkMechanism *mech, int32_t body, YkVec at);

// Counts the work of compiling so many joints, or as much. Returns false once the caller has stopped it: what is made
// then is discarded, whatever it is.
static inline bool yk_compile_goes_on(const YkMechanism *mech, size_t joints)
{
    enum { JOINT = 1000 };
    return yk_pace_spend(mech->arena->pace, JOINT * joints);
}

#endif
