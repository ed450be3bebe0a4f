// The machine in symbols. A derivation holds a ring with a symbol for everything the model speaks of, and builds from
// the topology alone - the spanning tree, its coordinates, the joints that close loops - what an engineer would write
// by hand. It shares that topology with the numeric engine and nothing else, so each can check the other.
//
// Vectors of the plane are complex elements: x is the real part, y the imaginary part.
// Two forms: in *body form* every body that turns has one angle, its own, and one rate; everything stays short there.
// In *joint form* only the coordinates of the file appear, as in a textbook. yk_derive_in_joints takes the first into
// the second by whole-number combinations. Derive in body form, show in joint form.
//
// Elements are constant and live as long as the derivation. A function that returns one returns NULL when the ring
// could not make it (yk_ring_status tells why) and takes NULL for any element, so that a derivation is checked once, at
// its end.
#ifndef DERIVE_DERIVE_H
#define DERIVE_DERIVE_H
#include <yoke/dynamics.h>
#include "compile/mechanism.h"
#include "derive/page.h"
#include "model/model.h"
#include "num/whole.h"
#include "ring/ring.h"

// A coordinate of the machine and its derivatives. First those of the spanning tree in the mechanism's order (the
// file's), then the distances of slides and pin-slots that close a loop (JOINT.distance).
typedef struct YkDeriveCoordinate {
    const char *name; // as the ring knows it
    int32_t joint;
    bool is_distance;
    bool in_tree;
    bool is_input;                        // given: driven, or held by the analysis
    bool is_held;                         // by a lock: it stands, whatever moves
    int32_t drive;                        // of the model, or YK_NONE
    int32_t position, rate, acceleration; // symbols
} YkDeriveCoordinate;

typedef struct YkDeriveBody {
    const char *name;      // as the ring knows it
    int32_t parent, joint; // in the tree; YK_NONE: the ground
    // Symbols of the angle of the body's orientation, and its derivatives; YK_NONE if the body never turns. A body
    // whose angle is a coordinate of the file uses that coordinate, others have NAME.angle, NAME.angle', NAME.angle''.
    // Bodies that never turn against each other share their symbols.
    int32_t angle, rate, acceleration;
    int32_t joints_in_angle;           // how many joint angles add up to the body's
    const YkPoisson *unit;             // e^(i angle of the body's axes), body form
    const YkPoisson *turn;             // the same by the angle of its orientation: constant
    const YkPoisson *spin, *spin_rate; // angular velocity and acceleration, body form: a symbol, or 0
    const YkPoisson *mass, *inertia;   // memo: yk_derive_mass, yk_derive_inertia
} YkDeriveBody;

// A vector from one named point to another: p^{head/tail}, times -1 if it is walked backwards.
typedef struct YkDeriveVector {
    const char *head, *tail;
    int32_t body; // in whose axes it is fixed, or along whose line it grows
    bool is_negative;
    bool is_variable;       // a distance is in it
    const YkPoisson *value; // without the sign, body form
} YkDeriveVector;

// Walking from point to point over joints.
typedef struct YkDerivePath {
    YkDeriveVector *vectors;
    size_t count;
    const YkPoisson *sum; // body form
} YkDerivePath;

// A joint that closes a loop: first body's point minus the second's = 0 (rows x and y), and where it does not turn, the
// second body's angle minus the first's minus a constant = 0. Rows are in world axes, or in those of the body from
// which both branches of the loop start (`axes`).
typedef struct YkDeriveLoop {
    int32_t joint, axes;
    YkDerivePath path;      // its sum in world axes, body form
    const YkPoisson *sum;   // joint form, complex: 0 on the machine
    const YkPoisson *angle; // joint form; NULL if the joint turns, or where the angle holds by itself
} YkDeriveLoop;

// A constant that is no polynomial of parameters (sqrt(l1^2 + 4 l2), atan(h/l)), or a number of many digits: a symbol
// of its own.
typedef struct YkDeriveConstant {
    int32_t symbol;
    const YkExpr *expr; // what it stands for (in SI; an angle in radians)
    double value;
    const YkPoisson *exact; // of a mass or an inertia: the number, or the symbol where the ring cannot hold it
} YkDeriveConstant;

typedef struct YkDerivation YkDerivation;
// Gives values to symbols that a section has added (forces, multipliers): values[symbol] = ...; dynamics may be NULL.
typedef void (*YkDeriveSource)(void *context, const YkState *state, YkDynamics *dynamics, double *values);
typedef struct YkDeriveBlocks YkDeriveBlocks;     // blocks.h
typedef struct YkDeriveRelation YkDeriveRelation; // relations.h

struct YkDerivation {
    YkArena *arena;
    const YkModel *model;
    const YkMechanism *mech;
    YkRing *ring;
    int32_t time;        // symbol t, with rate 1
    int32_t *parameters; // symbols, by the model's index
    YkDeriveCoordinate *coordinates;
    size_t coordinate_count, tree_count;   // all; those of the tree come first and agree with the mechanism's indices
    int32_t *joint_angle, *joint_distance; // per joint: its coordinate here, or YK_NONE
    YkDeriveBody *bodies;
    int32_t most_joints; // most joints_in_angle
    int32_t most_depth;  // of a body: joints between it and the ground
    // One for each angle, rate and acceleration that is a body's own, made at first use; then one for each definition.
    YkRingChange *changes;
    size_t change_count, definition_count, change_capacity; // change_count: all
    YkRingChanges *to_joints;                               // the same, prepared
    const YkPoisson **body_angles;                          // made with them: of each body's axes, joint form
    YkDeriveLoop *loops; // in the file's order; yk_derive_loops makes them at first use
    size_t loop_count;
    struct YkDeriveNames *names; // of points; made at first use
    const char *pitch_stem;      // of pitch points; found at first use
    YkDeriveRelation *ties;      // gears, racks, belts, cams, laws (relations.h); made at first use
    size_t tie_count;
    YkDeriveConstant *constants;
    size_t constant_count, constant_capacity, opaque_count[2]; // of all; of those without an exact value: k_1, alpha_1
    const YkPoisson **points;                                  // memo: of each model point in its body's axes
    struct YkDeriveSourceEntry {
        YkDeriveSource fill;
        void *context;
    } * sources;
    size_t source_count, source_capacity;
    YkDeriveBlocks *blocks;                 // made at first use
    struct YkCheckShared *checked;          // what equations share that are checked: prove/check_shared.c
    void (*forget_checks)(YkDerivation *d); // frees it; set with it
    struct YkLoopPlan *loop_plan;           // of random points, made at first use: prove/loop_plan.c
    struct YkDeriveTrain *train;            // gears, made at first use: derive/gears/gears.h
    int32_t *speeds;                        // per body: the symbol of its angular speed, omega1; made with the train
    struct YkDeriveOwn *own;                // symbols of the section of cams: derive/cams/cams.c
    int32_t *influence; // per coordinate: the symbol of its influence coefficient; made by the section of velocities
    // What sections add for proofs: elements that are 0 on the machine, linear in accelerations and in these symbols.
    const YkPoisson **relations;
    size_t relation_count, relation_capacity;
    int32_t *unknowns;
    size_t unknown_count, unknown_capacity;
    struct YkDerivePages *pages;            // names that sections alone have; made at first use: prove/equation_pages.c
    struct YkEquationOwn *own_of_equations; // angles, roots: prove/equation_angles.c
    bool has_names;                         // JOINT.angle, BODY.rate, ... are entered as other names of symbols
    bool failed;                            // out of memory outside of the ring
};

// Builds the frame: symbols and angles. The model and the mechanism must outlive it. Returns NULL with a problem added
// when out of memory or where the file's numbers are too large to be exact. Cost O(bodies).
YkDerivation *yk_derivation_new(const YkModel *model, const YkMechanism *mech, YkProblems *problems);
void yk_derivation_free(YkDerivation *derivation);
// Everything derived so far exists: memory, the ring's status.
bool yk_derivation_is_well(const YkDerivation *derivation);
YkCode yk_derive_code(YkRingStatus status); // of a problem that tells it
// Zeroed memory for a while, for free(). Returns NULL when out of memory, which the derivation keeps in mind.
void *yk_derive_scratch(YkDerivation *derivation, size_t count, size_t size);
// Did it run out of memory, in the ring or outside? It then remains so, and nothing that came of it is to be shown.
bool yk_derivation_ran_out(const YkDerivation *derivation);

// --- From the file (expression.c, symbols.c)
// ------------------------------------------------------------------------------- An expression of the file in SI,
// exactly: parameters, coordinates, rates and t become symbols; decimals and units exact (deg with the symbol pi). What
// is no polynomial becomes a constant symbol where it is constant; otherwise NULL with the status YK_RING_DIVISOR. NULL
// expression: 0.
const YkPoisson *yk_derive_expression(YkDerivation *d, const YkExpr *expr);
// The same, but NULL of NULL, and where the ring cannot hold it there is no failure.
const YkPoisson *yk_derive_given(YkDerivation *d, const YkExpr *expr);
void yk_derive_forgive(YkDerivation *d); // that the ring cannot hold a value
// The same of a mass or an inertia: a number of many digits becomes a constant symbol, letter_body (m_crank). To be
// asked for once: each call makes another.
const YkPoisson *yk_derive_measure(YkDerivation *d, const YkExpr *expr, YkRingClass kind, const char *letter,
                                   const char *body);
// The symbol of a constant that the ring cannot hold, k_1 or alpha_1: one for each expression. Returns NULL if it is no
// constant.
const YkPoisson *yk_derive_constant(YkDerivation *d, const YkExpr *expr, bool is_angle, int32_t *symbol);
// All of those in the file's order: then they have the same names whatever is derived. Cost O(file).
void yk_derive_enter_constants(YkDerivation *d);
// What masses and inertias, or other constants, stand for: those that the page has not told yet.
void yk_derive_put_constants(YkDerivation *d, YkPage *page, bool of_masses);
// e^(i expr) of an angle. NULL expression: 1.
const YkPoisson *yk_derive_turn(YkDerivation *d, const YkExpr *expr);
// A new symbol: `name` made fit for the ring (other characters become _, a name that is taken gets one more _). -1 on
// failure.
int32_t yk_derive_symbol(YkDerivation *d, const char *name, YkRingClass kind);
// A fraction as an element; NULL if it does not fit the ring's numbers.
const YkPoisson *yk_derive_fraction(YkDerivation *d, const YkFraction *a);
// From now on the symbol stands for `meaning`: in joint form it is replaced by it, and numbers follow it. `meaning` may
// mention symbols that were defined before, no e^(i angle). false on failure.
bool yk_derive_define(YkDerivation *d, int32_t symbol, const YkPoisson *meaning);
// What a parameter stands for in terms of others: NULL if it is a number of its own (or no polynomial).
const YkPoisson *yk_derive_definition(YkDerivation *d, size_t parameter);

// --- The machine (geometry.c, path.c)
const YkPoisson *yk_derive_at(YkDerivation *d, int32_t body, int32_t point); // in the body's axes; YK_NONE: the origin
const YkPoisson *yk_derive_along(YkDerivation *d, int32_t joint);    // a slide's direction in its first body's axes
const YkPoisson *yk_derive_distance(YkDerivation *d, int32_t joint); // the symbol; NULL if it does not slide
// From the first body's place to the second's along the line: distance * unit vector, in the world, body form.
const YkPoisson *yk_derive_slide(YkDerivation *d, int32_t joint);
// Positions in the world, body form: a body's origin, and a place given in its axes. Cost: the body's depth in the
// tree.
const YkPoisson *yk_derive_origin(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_position(YkDerivation *d, int32_t body, const YkPoisson *at);
// Of a body with mass: centre of mass in its axes, mass, inertia about the centre (a rod's follow); 0 where not given.
const YkPoisson *yk_derive_center(YkDerivation *d, int32_t body);
bool yk_derive_is_rod(const YkBody *body);
const YkPoisson *yk_derive_mass(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_inertia(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_gravity(YkDerivation *d); // complex; 0 if there is none
// The loops; NULL on failure (and if there are none: loop_count is 0). Cost O(sum of the lengths of the loops).
const YkDeriveLoop *yk_derive_loops(YkDerivation *d);
// From body form to joint form. In joint form: the body's spin is sum of B[k] * rate of coordinate k, B[k] in -1, 0, 1;
// yk_derive_combination writes B (tree_count entries).
const YkPoisson *yk_derive_in_joints(YkDerivation *d, const YkPoisson *a);
void yk_derive_combination(const YkDerivation *d, int32_t body, int32_t *B);

// The names of points, as short as they are clear: "A"; "crank.A" where several points that do not coincide are called
// A. The origin has the name of a point that the file puts there, or the body's name with 0.
const char *yk_derive_point_name(YkDerivation *d, int32_t body, int32_t point);
const char *yk_derive_center_name(YkDerivation *d, int32_t body); // C1, C2, ... unless taken
// The pitch point of the model's gear or, behind the gears, rack: P1, P2, ...; Q1, T1, pitch1, ... where the file has
// points of such names. In every section and drawing the same.
const char *yk_derive_pitch_name(YkDerivation *d, size_t gear_or_rack);
// From the place `from` (a point of a body, by its index or YK_NONE for the origin) to the place `to`.
typedef struct YkDerivePlace {
    int32_t body, point;
} YkDerivePlace;
bool yk_derive_path(YkDerivation *d, YkDerivePlace from, YkDerivePlace to, YkDerivePath *path);
// The place at which joint j holds body side 0 or 1: `from` or `at` on the first, `to` or `at` on the second.
YkDerivePlace yk_derive_place(const YkDerivation *d, int32_t joint, int side);

// --- Values (numeric_values.c)
// values[yk_ring_symbol_count(d->ring)]: parameters and constants from the file, coordinates and bodies from the state,
// what sources know; 0 for the rest. dynamics may be NULL. Completed: ready for yk_ring_value.
void yk_derive_values(YkDerivation *d, const YkState *state, YkDynamics *dynamics, double *values);
bool yk_derive_add_source(YkDerivation *d, YkDeriveSource fill, void *context);
// For --check: `zero` (an element, in any form) is 0 on the machine; `unknown` is a symbol that such elements determine
// (a force, a multiplier, an effort), together with the accelerations, in which they are linear. Solved at random
// points of the field.
bool yk_derive_add_relation(YkDerivation *d, const YkPoisson *zero);
bool yk_derive_add_unknown(YkDerivation *d, int32_t symbol);

// --- Sections (sections.c)
// ----------------------------------------------------------------------------------------------- A section adds its
// headings and formulas to a page. false when something failed (the ring's status tells).
typedef bool (*YkDeriveSection)(YkDerivation *d, YkPage *page);
typedef struct YkDeriveSectionEntry {
    const char *name;  // as --what takes it
    const char *title; // heading
    YkDeriveSection write;
    bool (*is_of)(const YkModel *model); // has the model what it is about? NULL: always; `all` leaves out the others
    bool has_masses;                     // masses and inertias stand in it
} YkDeriveSectionEntry;
extern const YkDeriveSectionEntry yk_derive_sections[]; // in the order of `all`; ends at name NULL
// Writes a section by its index, heading included.
bool yk_derive_write(YkDerivation *d, size_t section, YkPage *page);

#endif
