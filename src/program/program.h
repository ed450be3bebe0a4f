// The program: the compiled steps of a mechanism, run with values of a graph instead of numbers.
//
// Does once, in symbols, what the engine does lane by lane (solve/run, solve/kernels*): the same steps in the
// same order, the same closed forms. Rates come in sets: those of the motion, or those for rate 1 of one input and 0 of
// all others, which give the columns of the Jacobian.
#ifndef PROGRAM_PROGRAM_H
#define PROGRAM_PROGRAM_H
#include <yoke/problem.h>
#include "compile/mechanism.h"
#include "compile/recipe.h"
#include "graph/graph.h"

// First or second derivatives of all orientations (by slot), distances and nodes.
typedef struct YkRates {
    YkRef *turn, *slide;
    YkRefVec *node;
} YkRates;

typedef struct YkMotionRef { // of a scalar
    YkRef position, velocity, acceleration;
} YkMotionRef;

// Kept from a block's position for its rates.
typedef struct YkPlaced {
    YkRefVec known;  // K
    YkRefVec p, q;   // RRR: the present arms; RRP: q; LINK: p
    YkRefVec e[2];   // RRR: unit vectors of both; RRP, RPR: of the line, of the orientation; PP: of both lines
    YkRef inverse;   // of the determinant, as the rates need it
    YkRef *unknown;  // GROUP: the leaves of Newton's method,
    YkRef *residual; // [2 loops] in terms of them
    YkRef *jacobian; // [2 loops][columns]
    YkRef *solution; // the same leaves' values, from the call,
    YkRef *at;       // and the Jacobian there
    int32_t call;
    bool passes_pin; // RPR: the line passes the pin
    const char *name;
} YkPlaced;

// The names of members and functions in the printed file, with the indices of the model or the mechanism.
typedef struct YkCNames {
    const char **parameter;
    const char **coordinate;                   // of inputs and results; also with _rate, _accel, _effort
    const char **near_coordinate, **near_slot; // of the configuration: reference angles; or NULL
    const char **block;                        // of the configuration: the branch; also with _guess
    const char **point;                        // also with _x, _y, _x_rate, ...; NULL on the ground
    const char **joint;                        // also with _force_x, _force_y, _moment
    const char **contact;                      // likewise, of relations
    const char **law;
} YkCNames;

typedef struct YkProgram {
    YkGraph graph;
    const char *prefix; // of all names of the file at its outermost level
    YkCNames names;
    YkArena *arena;
    const YkModel *model;
    const YkMechanism *mech;
    const YkRecipe *recipe; // how its vectors follow from points and lines of the model; NULL: they keep their values
    YkProblems *problems;
    bool is_single; // numbers are floats
    bool takes_all; // parameters that depend on others are given as well
    // constants
    YkRef *parameter; // per parameter
    bool *is_fixed;   // per parameter: it keeps the file's value
    YkRef *turn;      // per body: angle to its orientation
    YkRefVec *turn_unit;
    YkRef time;
    // the pose
    YkRefVec *unit; // per slot
    YkRef *distance;
    YkRefVec *node;
    YkPlaced *placed; // per block
    YkMotionRef *input;
    YkRef *argument, *argument_rate; // per relation with a law
    const YkRef *input_rates;        // in use: first or second derivatives of the inputs
    YkRef *slope;                    // per relation with a law: first and second derivative, two each
    YkRef margin;                    // least sin^2 over the blocks; NaN if one is not finite
    YkRef gap;                       // largest error of loops that repeat others, m; also NaN
    YkRef witness;                   // 0 if the inputs are finite, and no angle from them is too large to have a sine
    YkRef angles;                    // 0 if no other angle, of gears and the like, is too large
    YkRef missed;                    // largest error of a group, over the tolerance
    bool failed;                     // something cannot be printed: reported
} YkProgram;

bool yk_program_start(YkProgram *program, const YkMechanism *mech, const YkRecipe *recipe, YkArena *arena,
                      YkProblems *problems);
void yk_program_end(YkProgram *program);
// Returns the machine's size to the nearest power of two, for tolerances: the text then depends on no value.
double yk_program_size(const YkProgram *program);
double yk_program_block_size(const YkProgram *program, const YkBlock *block); // the same of yk_block_size

// constants.c: numbers of the model as values.
// Fixes the parameters on which numbers depend that the program cannot compute anew.
void yk_program_fix(YkProgram *program);
// Makes parameters and the bodies' turns.
void yk_program_constants(YkProgram *program);
YkRef yk_program_expr(YkProgram *program, const YkExpr *expr); // of parameters and t; NULL: 0
// Does the same with names of coordinates, `motion[coordinate]` of the tree, and in a spring's force with its own[2],
// the length and the rate, or NULL.
YkRef yk_program_expr_of(YkProgram *program, const YkExpr *expr, const YkMotionRef *motion, const YkRef *own);
YkRefVec yk_program_point(YkProgram *program, int32_t point); // in the body's axes; YK_NONE: the origin
YkRefVec yk_program_along(YkProgram *program,
                          const YkJoint *joint);           // the direction of its line, in its first body's axes
YkRefVec yk_program_term(YkProgram *program, size_t term); // of the mechanism's terms
YkRefVec yk_program_constant(YkProgram *program, const YkSum *sum);
YkRefVec yk_program_line(YkProgram *program, int32_t distance, YkVec value); // of a block: a unit vector
YkRef yk_program_joint_offset(YkProgram *program, int32_t joint); // angle of the joint = Phi_b - Phi_a + this

// names.c: return names for variables, not yet unique.
const char *yk_program_slot_name(YkProgram *program, int32_t slot);
const char *yk_program_distance_name(YkProgram *program, int32_t distance);
// Set an orientation or a distance, and name the value.
void yk_program_set_unit(YkProgram *program, int32_t slot, YkRefVec unit);
void yk_program_set_distance(YkProgram *program, int32_t distance, YkRef value);

// sums.c
YkRefVec yk_program_sum(YkProgram *program, const YkSum *sum);
YkRefVec yk_program_sum_rate(YkProgram *program, const YkSum *sum, const YkRates *velocities);
YkRefVec yk_program_sum_accel(YkProgram *program, const YkSum *sum, const YkRates *velocities,
                              const YkRates *accelerations);

// relations.c: returns a relation's value for its target or, in a group or if it repeats others, its error, m.
// unknown: the group's columns, or NULL.
YkRef yk_program_relation(YkProgram *program, size_t relation, const YkRef *unknown);
// Returns the rate of a relation's value, without a group's own columns; accelerations NULL: the first derivative.
YkRef yk_program_relation_rate(YkProgram *program, size_t relation, const YkRates *velocities,
                               const YkRates *accelerations);
// Returns the rate of the argument of a relation's law, from all that turns and slides.
YkRef yk_program_argument_rate(YkProgram *program, size_t relation, const YkRates *velocities);
// Adds to the arguments of a group's laws the part of its unknowns, whose velocities are known.
void yk_program_group_arguments(YkProgram *program, const YkBlock *block, const YkRates *velocities);
int32_t yk_program_law(const YkProgram *program, const YkLaw *law); // its place in the model
// Returns the value of a law and its two derivatives, as a call.
int32_t yk_program_call_law(YkProgram *program, int32_t law, YkRef argument);

// pose.c: positions, by all steps.
void yk_program_pose(YkProgram *program);
YkRefVec yk_program_turn(YkProgram *program, const YkStep *step); // of an input's turn, from its parent
// Records the error of a loop or relation that repeats others (blocks.c).
void yk_program_keep_gap(YkProgram *program, YkRef gap);
// place.c: one block, of any kind.
void yk_program_place(YkProgram *program, size_t block);

// rates.c
YkRates yk_program_new_rates(YkProgram *program);
// Return first derivatives from those of the inputs; second ones from those and the first.
YkRates yk_program_velocities(YkProgram *program, const YkRef *input_rates);
YkRates yk_program_accelerations(YkProgram *program, const YkRates *velocities, const YkRef *input_accelerations);
// Replaces those rates that are sums of the inputs' own: of what drives, gears, racks and belts alone move.
void yk_program_linear_rates(YkProgram *program, const YkRef *input_rates, YkRates *rates);
// block_rates.c: one block; accelerations NULL: its velocities.
void yk_program_block_rates(YkProgram *program, size_t block, YkRates *velocities, YkRates *accelerations);

// asked_values.c
YkRef yk_program_coordinate(YkProgram *program, size_t coordinate); // its position
// Returns its rate from first derivatives, or its acceleration from second ones: the same sum.
YkRef yk_program_coordinate_rate(YkProgram *program, size_t coordinate, const YkRates *rates);
YkRef yk_program_joint_rate(YkProgram *program, int32_t joint, bool is_distance, const YkRates *rates);
// Returns a point given in a body's axes.
YkRefVec yk_program_at(YkProgram *program, int32_t body, YkRefVec at);
YkRefVec yk_program_at_rate(YkProgram *program, int32_t body, YkRefVec at, const YkRates *velocities);
YkRefVec yk_program_at_accel(YkProgram *program, int32_t body, YkRefVec at, const YkRates *velocities,
                             const YkRates *accelerations);
// body_accel.c: returns a body point's acceleration in fewer operations, for poses that need no rates of the point.
YkRefVec yk_program_body_accel(YkProgram *program, int32_t body, YkRefVec at, const YkRates *velocities,
                               const YkRates *accelerations);

#endif
