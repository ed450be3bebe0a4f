// Loads at a pose: what gravity, forces, springs, dampers, efforts and friction exert on every body, as one force and
// one moment for each; and the energy that they store and take.
#ifndef LOADS_LOADS_H
#define LOADS_LOADS_H
#include <yoke/dynamics.h>
#include "compile/mechanism.h"
#include "expr/formula.h"
#include "solve/space.h"
#include "solve/state.h"

// The load on a body: force, and moment about its reference point: the centre of mass, or the origin if it has no mass.
typedef struct YkLoad {
    YkVec force;
    double moment;
} YkLoad;

// The position and motion of a body's reference point, in lane 0 of a space.
typedef struct YkBodyMotion {
    YkVec at, velocity, acceleration; // of the reference point, world axes
    YkVec e;                          // the body's x axis as a unit vector
    double w, a;                      // angular velocity and acceleration
} YkBodyMotion;
YkVec yk_reference_point(const YkModel *model, size_t body); // in the body's axes
YkBodyMotion yk_body_motion(const YkMechanism *mech, const YkSpace *space, size_t body);

// A number in a load: constant, a formula, or a law of a formula.
typedef struct YkLoadValue {
    double constant;
    const YkFormula *formula; // NULL: constant
    const YkLaw *law;         // of the formula
} YkLoadValue;

// A point of a body on which a load pulls, prepared in the axes of the body's orientation.
typedef struct YkLoadEnd {
    int32_t body;
    YkVec from_origin, arm; // the point, relative to the body's origin and to its reference point
} YkLoadEnd;

typedef enum YkLoadKind {
    YK_LOAD_EFFORT,  // along a joint's angle or distance
    YK_LOAD_FORCE,   // at a point of a body
    YK_LOAD_SPRING,  // between two points, with a damper
    YK_LOAD_ALONG,   // spring and damper along a joint's angle or distance
    YK_LOAD_VISCOUS, // friction that grows with the rate
    YK_LOAD_COULOMB, // dry friction: its value is `dry`
    YK_LOAD_STOP     // the effort of a stop: likewise
} YkLoadKind;

typedef struct YkLoadItem {
    YkLoadKind kind;
    const char *name; // of the coordinate, force, spring or joint
    int32_t joint;    // EFFORT, ALONG, VISCOUS, COULOMB
    bool is_distance;
    int32_t coordinate; // in the tree, if the joint has one there; otherwise YK_NONE
    int32_t input;      // of the coordinate; YK_NONE if it is none
    int32_t body[2];    // FORCE: body[0]; SPRING; of a joint: the first body of its first half, the second of its last
    int32_t slot[2];    // of a joint: the orientations of its own two bodies
    YkLoadEnd end[2];   // FORCE, SPRING
    bool in_body_axes;
    YkLoadValue value[3]; // EFFORT: [0]; FORCE: x, y, moment; SPRING, ALONG: [0], the pull by a law of its own
    double stiffness, length, damping;
    double coulomb, radius; // COULOMB
    const YkStop *stop;     // STOP
    double direction;       // COULOMB: of the sliding, +1 or -1; 0: from the rate
    double last;            // EFFORT: its value when last added
    bool is_given;          // EFFORT: yk_loads_set_effort gave it
    double dry;             // COULOMB, STOP: the present moment or force
    bool is_held;           // COULOMB: the joint sticks; `dry` is given from outside
} YkLoadItem;

// A pull from outside on a point of a body: force + stiffness (target - point) - damping velocity, world axes.
typedef struct YkHandle {
    bool is_on;
    YkLoadEnd end;
    YkVec target, force;
    double stiffness, damping;
} YkHandle;

typedef struct YkVariable { // a variable of the formulas: [0] is the time
    int32_t coordinate;     // of the tree; YK_NONE: the length of the spring that is being added
    bool is_rate;
} YkVariable;

typedef struct YkLoads {
    const YkMechanism *mech;
    YkArena *arena;
    YkLoadItem *items;
    size_t item_count;
    YkVariable *variables;
    size_t variable_count, variable_capacity;
    double *value;   // values of the variables
    size_t own[2];   // variables that are the length and the rate of the spring at hand; 0: none
    bool *is_loaded; // per body: whether some item may act on it
    YkHandle *handles;
    size_t handle_count;
    double handle_power; // power that all handles delivered to the machine when last added, W
    bool has_dry;
    bool varies; // a number follows a formula or a law
    bool failed;
} YkLoads;

YkLoads *yk_loads_new(const YkMechanism *mech);
void yk_loads_free(YkLoads *loads);
// Replaces the effort along a tree coordinate.
bool yk_loads_set_effort(YkLoads *loads, size_t coordinate, double effort);
// Makes room for pulls from outside, none of them on; any body may then be pulled. Returns false when out of memory.
bool yk_loads_set_handles(YkLoads *loads, size_t count);
// Adds all items and handles to load[body], without gravity, at a pose of the space (positions and velocities; the
// inputs and references are the state's). power[item] (may be NULL): the power it delivers to the machine now, W.
// Returns false if a value is not finite: *culprit names the item.
bool yk_loads_add(YkLoads *loads, const YkState *state, const YkSpace *space, YkLoad *load, double *power,
                  size_t *culprit);
// Adds an effort along a joint's freedom to both bodies.
void yk_loads_add_effort(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance, double effort,
                         YkLoad *load);
// Finds, for open trees whose only items are one effort for each coordinate, effort[input], and their power at
// rate[input]. The state's inputs and time count only where `varies` is set.
bool yk_loads_efforts(YkLoads *loads, const YkState *state, const double *rate, double *effort, double *power,
                      size_t *culprit);
// Returns the argument of the law that a number of an item follows (value[part]) at a pose; NaN if it follows none.
double yk_loads_law_argument(YkLoads *loads, const YkState *state, const YkSpace *space, size_t item, size_t part);
// Returns what `efforts:` gave along a tree coordinate when the items were last added.
double yk_loads_effort(const YkLoads *loads, int32_t coordinate);
// Returns the energy stored in the springs, J.
double yk_loads_stored(const YkLoads *loads, const YkState *state, const YkSpace *space);
// Returns a tree coordinate at a pose of the space, whose inputs are the state's. Leaves out the acceleration of an
// input.
YkMotion yk_loads_coordinate(const YkState *state, const YkSpace *space, int32_t coordinate);
// Return the rate of a joint's freedom; with its acceleration.
YkMotion yk_joint_motion(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance); // no position
double yk_joint_rate(const YkMechanism *mech, const YkSpace *space, int32_t joint, bool is_distance);

#endif
