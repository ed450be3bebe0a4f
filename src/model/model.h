// The inside of YkModel, which later rooms read. SI and radians; filled by the loader, then constant.
#ifndef MODEL_MODEL_H
#define MODEL_MODEL_H
#include <stdbool.h>
#include <stdint.h>
#include <yoke/cam.h>
#include <yoke/model.h>
#include "base/memory.h"
#include "base/names.h"
#include "base/problems.h"
#include "base/units/units.h"
#include "base/vec.h"
#include "expr/expr.h"
#include "law/law.h"
#include "part/part.h"

typedef struct YkParameter {
    const char *name;
    YkPlace place;
    YkExpr *expr; // after overrides
    YkDimension dimension;
    double value; // SI
} YkParameter;

typedef struct YkPoint {
    const char *name;
    YkPlace place;
    int32_t body;
    YkVec at; // in the body's axes, m
    YkExpr *x, *y;
} YkPoint;

typedef struct YkBody {
    const char *name;
    YkPlace place;
    int32_t first_point, point_count; // its points are contiguous in model->points
    bool has_mass;
    double mass, inertia;                                   // kg; kg m^2 about the centre of mass
    YkVec center;                                           // of mass, in the body's axes, m
    YkExpr *mass_expr, *inertia_expr, *center_x, *center_y; // NULL if not given
    int32_t rod[2];                                         // points of `rod`, or YK_NONE
    int32_t copies;    // a planet that shares its load: how many there are; its inertia is that of all. 0: none
    int32_t copies_of; // the planet of which this body has the other copies' masses (transmissions/planets.c); 0: none
    bool is_carriage;  // massless, within a free joint; behind all others, and never shown
} YkBody;

// Friction of a joint. In a pin: a moment coulomb * radius * |reaction| against the rotation, and viscous * rate; in a
// slide or pin-slot: a force coulomb * |normal force| against the sliding, and viscous * speed.
typedef struct YkFriction {
    double coulomb; // >= 0, a number
    double radius;  // of a pin, m
    double viscous; // N m s (pin) or N s/m (slide, pin-slot), >= 0
    YkPlace place;
    YkExpr *coulomb_expr, *radius_expr, *viscous_expr; // NULL if not given (0)
} YkFriction;

typedef struct YkJoint {
    const char *name;
    YkPlace place;
    YkPartKind kind;
    int32_t body[2];  // a, b
    int32_t point[2]; // pin: the point on a and on b; slide, pin-slot, weld: `from` on a, `to` (or `at`) on b; YK_NONE
                      // = origin
    YkVec at[2];      // the same in each body's axes, m
    YkVec along;      // unit direction of the line in a's axes (slide, pin-slot): exact for x and y
    double along_angle;               // rad
    double turned;                    // b's constant angle to a (slide, weld), rad
    YkExpr *along_expr, *turned_expr; // NULL for the default or for x / y
    int32_t angle, distance;          // declared coordinates, or YK_NONE
    bool has_friction;
    YkFriction friction;
    // One half of a free joint, which is a slide of its first body and a carriage, behind all joints of the file, and a
    // pin-slot of the carriage and its second body in its own place. A free joint transmits nothing.
    bool is_free;
    int32_t partner; // the other half
    // The pin of a planet that shares its load with equal ones: their number, otherwise 0; which body is the planet.
    int32_t copies, copied_side;
} YkJoint;

// A coordinate that the file declares: by `angle:` or `distance:` at its joint, or by mentioning `JOINT.angle` or
// `JOINT.distance` in drives, start or efforts. It is always the second body's relative to the first.
typedef struct YkCoordinate {
    const char *name;
    YkPlace place;
    int32_t joint;
    bool is_distance;
    int32_t drive; // index into drives, or YK_NONE
} YkCoordinate;

typedef struct YkDrive {
    int32_t coordinate;
    YkPlace place;
    YkExpr *expr; // in t and parameters; with a law: the law's argument
    int32_t law;  // index into model->laws, or YK_NONE
    bool is_hold; // held still by a lock
} YkDrive;

// `drives: {d: {law: lift, of: theta}}`: a coordinate that follows another by a law, as by a cam.
typedef struct YkFollow {
    int32_t coordinate, of;
    YkPlace place;
    int32_t law;
} YkFollow;

// `start:` in file order: a coordinate's position or rate (`theta1.rate`).
typedef struct YkStart {
    int32_t coordinate;
    bool is_rate;
    YkPlace place;
    YkExpr *expr;
    double value;
} YkStart;

// A value that follows the time and the pose: an expression, or a law of it.
typedef struct YkStrength {
    YkExpr *expr; // in t, parameters, coordinates, rates; with a law: its argument. NULL: 0
    int32_t law;  // index into model->laws, or YK_NONE
} YkStrength;

typedef struct YkEffort {
    int32_t coordinate;
    YkPlace place;
    YkStrength strength;
} YkEffort;

typedef struct YkForce { // at a point of a body
    const char *name;
    YkPlace place;
    int32_t body;
    int32_t point; // YK_NONE: the body's origin
    YkVec at;      // the same in the body's axes, m
    bool in_body_axes;
    YkStrength x, y, moment; // N, N m
} YkForce;

// A spring and a damper in parallel: between two points, or along a coordinate (a torsion spring on an angle).
typedef struct YkSpring {
    const char *name;
    YkPlace place;
    int32_t coordinate;                                  // along it; or YK_NONE: between points
    int32_t body[2], point[2];                           // of the points
    YkVec at[2];                                         // in each body's axes, m
    double stiffness, length, damping;                   // length: free length, m, or free angle, rad
    YkExpr *stiffness_expr, *length_expr, *damping_expr; // NULL if not given (0)
    YkStrength force; // pulls besides, N or N m; between points it may mention YK_OWN_LENGTH and YK_OWN_RATE
} YkSpring;

// The names of a spring's own length and rate in its `force`, as the loader writes them: no file can.
#define YK_OWN_LENGTH "length of the spring"
#define YK_OWN_RATE "rate of the spring"
int yk_model_own_name(const char *name); // 0: its length, 1: its rate, YK_NONE: another name
// The argument `x` of a task's function, as the loader writes it: a plain number.
#define YK_OWN_ARGUMENT "argument of the function"

// A stop: a coordinate cannot leave [low, high]. Where it hits an end its rate reverses, times `restitution`.
typedef struct YkStop {
    int32_t coordinate;
    YkPlace place;
    double low, high, restitution;                   // restitution: 0 to 1, 0 if not given
    YkExpr *low_expr, *high_expr, *restitution_expr; // NULL if not given
} YkStop;

// `laws:` motion programs and tables by name.
typedef struct YkModelLaw {
    const char *name;
    YkPlace place;
    YkLaw *law;                 // argument and value in SI
    YkDimension of, value;      // their dimensions
    struct YkLawSource *source; // as the file gives it: model/laws/laws.h
} YkModelLaw;

// A number kept exactly if the file writes it so: numerator / denominator * pi^pi.
typedef struct YkExact {
    bool is_exact;
    int64_t numerator, denominator; // in lowest terms, denominator > 0
    int32_t pi;
} YkExact;

// Two gears in mesh. A gear's centre is its body's origin; both centres lie on axes that the carrier holds.
typedef struct YkGear {
    const char *name;
    YkPlace place;
    int32_t body[2]; // internal: the second is the ring
    int32_t carrier; // given, or the one body that holds both centres; YK_NONE only while loading
    bool is_internal;
    int64_t teeth[2];       // > 0
    double teeth_value[2];  // the same, as first read
    double module;          // m; 0: not given
    double pressure_angle;  // rad; 20 deg if not given
    double planets;         // number of identical, equally spaced planets here; 0: not given
    double center_distance; // between the two centres on the carrier, m
    YkVec center[2];        // the two centres, in the carrier's axes, m
    int32_t copies; // number of equal planets that share the load of this pair (transmissions/planets.c); 0: one
    int32_t planet; // which of the two wheels is the planet; 2: both
    YkExpr *teeth_expr[2], *module_expr, *pressure_angle_expr, *planets_expr;
} YkGear;

// Returns whether one of the wheels is a planet that shares its load with equal ones, and the other turns about the
// carrier's axis.
static inline bool yk_gear_is_about_axis(const YkGear *gear)
{
    return gear->copies > 1 && gear->planet < 2;
}

// A pinion that rolls on a rack, which slides along a line of the carrier. Looking along that line, a pinion on its
// left that turns counter-clockwise (relative to the carrier) moves the rack forwards; a pinion on its right,
// backwards.
typedef struct YkRack {
    const char *name;
    YkPlace place;
    int32_t pinion, rack, carrier;
    int32_t slide; // the joint between carrier and rack
    int32_t sense; // +1 or -1: rate of the slide divided by radius times the pinion's rate
    double radius; // m
    YkExact exact_radius;
    YkExpr *radius_expr;
} YkRack;

// A belt or chain between two pulleys whose centres the carrier holds.
typedef struct YkBelt {
    const char *name;
    YkPlace place;
    int32_t body[2], carrier;
    double radius[2]; // m
    YkExact exact_radius[2];
    bool is_crossed;
    bool is_lock; // not a belt: bodies that a lock makes turn as one
    YkExpr *radius_expr[2];
} YkBelt;

// `locks:` a set of bodies and coordinates that are held, and of bodies that are joined, chosen by name.
typedef struct YkHold {
    int32_t body;       // held to the ground; or YK_NONE:
    int32_t coordinate; // whose rate is zero
} YkHold;
typedef struct YkLock {
    const char *name;
    YkPlace place;
    YkHold *holds;
    size_t hold_count;
    int32_t (*joins)[2]; // pairs of bodies
    size_t join_count;
} YkLock;

// `cams:` a cam pinned to a carrier, and the follower that the carrier guides.
typedef struct YkCam {
    const char *name;
    YkPlace place;
    int32_t cam, follower, carrier; // bodies
    int32_t cam_joint;              // pin of cam and carrier
    int32_t follower_joint;         // pin (oscillating) or slide (translating) of follower and carrier
    // index into model->laws: over the cam's angle; gives a length, or an angle for an oscillating follower
    int32_t law;
    int32_t point; // `at`: the follower's point with the roller or edge; or YK_NONE
    bool oscillates, is_groove, is_conjugate;
    YkCamFace face;
    double base, roller, offset;   // m; offset towards -i along
    double arm, centers;           // m, oscillating
    double other_roller;           // of a conjugate pair's second roller, m
    double other_span;             // its distance behind the first along the line of motion, m
    double other_arm, other_angle; // oscillating: its arm, m, and the angle from the first arm to it, rad
    YkExpr *base_expr, *roller_expr, *offset_expr, *arm_expr, *centers_expr; // NULL if not given
    YkExpr *other_roller_expr, *other_span_expr, *other_arm_expr, *other_angle_expr;
    struct YkCamArcs
        *arcs; // transmissions/cam_arcs.h: the surface from which the law is made; NULL if the file gives a law
    // Results of the joints' places, in the carrier's axes:
    double turn;   // +1: the cam turns counterclockwise as its coordinate grows; -1: clockwise
    double swing;  // the same for an oscillating follower
    double away;   // and where it leaves the cam: that sense, or the other one if the lift falls there
    YkVec along;   // unit direction of a translating follower's lift
    YkVec pivot;   // of an oscillating follower, from the cam's centre, m
    bool is_apart; // its pin does not lie on the cam's
} YkCam;

enum { YK_QUANTITY_COUNT = YK_QUANTITY_INERTIA + 1 };

// An expression of the file, and the model's value that it sets.
typedef struct YkModelUse {
    const YkExpr *expr;
    double *target;
} YkModelUse;

struct YkModel {
    YkArena *arena;
    const char *name;        // `name:`, or the file's name without folder and ending
    const char *source_name; // as given to the loader, for messages
    const char *source;      // the file's text, with the values that overrides replaced (builder.h: yk_model_text)
    size_t source_length;
    size_t carriage_count; // number of bodies, and of joints, at the end that are parts of free joints
    size_t shown_joints;   // joints before them
    size_t
        held_joints; // of a sketch: number of joints at the end that hold what nothing connects to the ground (sketch.h)
    YkUnits units;
    const char *unit_names[YK_QUANTITY_COUNT]; // the file's unit of each quantity: "mm/s"
    YkParameter *parameters;
    size_t parameter_count;
    YkBody *bodies;
    size_t body_count; // [0] is ground
    YkPoint *points;
    size_t point_count;
    YkJoint *joints;
    size_t joint_count;
    YkCoordinate *coordinates;
    size_t coordinate_count; // in file order
    YkDrive *drives;
    size_t drive_count;
    YkFollow *follows;
    size_t follow_count;
    YkStart *starts;
    size_t start_count;
    YkEffort *efforts;
    size_t effort_count;
    YkForce *forces;
    size_t force_count;
    YkSpring *springs;
    size_t spring_count;
    YkStop *stops;
    size_t stop_count;
    YkModelLaw *laws;
    size_t law_count;
    YkCam *cams;
    size_t cam_count;
    YkGear *gears;
    size_t gear_count;
    YkRack *racks;
    size_t rack_count;
    YkBelt *belts;
    size_t belt_count;
    YkLock *locks;
    size_t lock_count;
    const char *engaged; // the name of the engaged lock, or NULL
    YkModelUse *uses;    // expressions, not plain numbers, that give values: model/redesign.h evaluates them again
    size_t use_count;
    bool has_gravity;
    YkVec gravity; // m/s^2
    YkExpr *gravity_x, *gravity_y;
    double size; // m: largest distance between two points of one body (including its origin if a joint uses it), or the
                 // largest start distance if that is more; 1 if all are zero. The scale for lengths.
    YkNames body_names, joint_names, parameter_names, coordinate_names, point_names; // points by "body.point"
};

// Returns the value that `start:` gives a coordinate, or NULL.
static inline const YkStart *yk_start_of(const YkModel *model, int32_t coordinate)
{
    for (size_t k = 0; k < model->start_count; k++)
        if (model->starts[k].coordinate == coordinate && !model->starts[k].is_rate) return &model->starts[k];
    return NULL;
}

// Returns the body to which a joint attaches the given one, or YK_NONE.
static inline int32_t yk_joint_other_body(const YkJoint *joint, int32_t body)
{
    return joint->body[0] == body ? joint->body[1] : joint->body[1] == body ? joint->body[0] : YK_NONE;
}
// Returns the joint that holds one side of a joint: the joint itself; of a free joint the half that has that body.
static inline const YkJoint *yk_joint_end(const YkModel *model, size_t joint, int side)
{
    const YkJoint *j = &model->joints[joint];
    return !j->is_free || (side == 1) == (j->kind == YK_PIN_SLOT) ? j : &model->joints[j->partner];
}
// Returns the dimension of a quantity.
YkDimension yk_quantity_dimension(YkQuantity quantity);

// How a text is read, besides as yk_model_parse reads it.
typedef struct YkReading {
    const YkLoadOptions *options; // NULL: defaults
    YkNamePlace name_place;       // what problems are about, in place of lines of a file; NULL: lines
    const struct YkSheet *sheet;  // the document where it is not a machine (model/load.h); NULL: a machine
    bool is_sketch;               // parts may be missing: groups of bodies that float are welded to the ground
} YkReading;
YkModel *yk_model_read(const char *text, size_t length, const char *name, const YkReading *how, YkProblems *problems);

// Finds a lock by its name; returns false (reported, with the existing names) if there is none.
bool yk_model_find_lock(const YkModel *model, const char *name, const YkLock **lock, YkProblems *problems);

// Evaluates an expression of parameters and t (coordinates have no value here), with its derivatives in time.
// Returns YK_OK; YK_BAD_MODEL with a problem added (code 3xx) for a division by zero and the like.
YkStatus yk_model_drive(const YkModel *model, size_t drive, double t, YkJet *jet, YkProblems *problems); // of a drive
// Returns how much rounding may have changed the value of yk_model_drive, rad or m; INFINITY if it has none.
double yk_model_drive_rounding(const YkModel *model, size_t drive, double t);
// Finds the angle of a drive that is a + b t with exact a and b, less whole turns, in [-pi, pi]: exact to rounding for
// any number of turns. Returns false for other drives, and beyond 1e15 turns if the rate is not a fraction of a turn.
bool yk_model_drive_phase(const YkModel *model, size_t drive, double t, double *phase);
// Returns whether a drive is linear in time, judged by the form of its expression.
bool yk_model_drive_is_steady(const YkModel *model, size_t drive);
YkStatus yk_model_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems);

// Reads a value as yk_model_value does, of any dimension; problems get this place.
YkStatus yk_model_value_of(const YkModel *model, const char *text, YkDimension dimension, YkPlace place, double *value,
                           YkProblems *problems);

// Returns the exact SI value of an expression of numbers, pi and parameters if + - * / and whole powers lead to one;
// otherwise is_exact is false. The second also gives the rate, for an expression that is linear in t.
YkExact yk_model_exact(const YkModel *model, const YkExpr *expr);
YkExact yk_model_exact_rate(const YkModel *model, const YkExpr *expr);
typedef struct YkExactLine { // constant + rate t
    YkExact constant, rate;
} YkExactLine;
YkExactLine yk_model_exact_line(const YkModel *model, const YkExpr *expr); // both inexact if it is not linear

#endif
