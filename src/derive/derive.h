// The machine in symbols. A derivation holds a ring with a symbol for everything in the model. From the topology alone
// - the spanning tree, its coordinates, the joints that close loops - it builds what an engineer would write by hand.
// It shares that topology with the numeric engine and nothing else, so that each can check the other.
//
// Vectors of the plane are complex elements: x is the real part, y the imaginary part.
// There are two forms. In *body form* every body that turns has one angle and one rate of its own; everything stays
// short there. In *joint form* only the file's coordinates appear, as in a textbook. yk_derive_in_joints leads from the
// first to the second by whole-number combinations. Derive in body form, show in joint form.
//
// Elements are constant and live as long as the derivation. A function that returns one returns NULL if the ring
// could not make it (yk_ring_status says why), and accepts NULL for any element, so that a derivation is checked only
// once, at its end.
#ifndef DERIVE_DERIVE_H
#define DERIVE_DERIVE_H
#include <yoke/derive.h>
#include "compile/mechanism.h"
#include "base/text.h"
#include "derive/page.h"
#include "model/model.h"
#include "num/whole.h"
#include "ring/ring.h"

// A coordinate of the machine and its derivatives: first those of the spanning tree in the mechanism's order (the
// file's), then the distances of slides and pin-slots that close a loop (JOINT.distance).
typedef struct YkDeriveCoordinate {
    const char *name; // as in the ring
    int32_t joint;
    bool is_distance;
    bool in_tree;
    bool is_input;                        // given: driven, or held by the analysis
    bool is_held;                         // by a lock: it stands still
    int32_t drive;                        // of the model, or YK_NONE
    int32_t position, rate, acceleration; // symbols
} YkDeriveCoordinate;

typedef struct YkDeriveBody {
    const char *name;      // as in the ring
    int32_t parent, joint; // in the tree; YK_NONE: the ground
    // Symbols of the angle of the body's orientation and its derivatives; YK_NONE if the body never turns. A body whose
    // angle is a coordinate of the file uses that coordinate, others have NAME.angle, NAME.angle', NAME.angle''. Bodies
    // that never turn against each other share their symbols.
    int32_t angle, rate, acceleration;
    int32_t joints_in_angle;           // number of joint angles in the body's angle
    const YkPoisson *unit;             // e^(i angle of the body's axes), body form
    const YkPoisson *turn;             // the same by the angle of its orientation: constant
    const YkPoisson *spin, *spin_rate; // angular velocity and acceleration, body form: a symbol, or 0
    const YkPoisson *mass, *inertia;   // memo: yk_derive_mass, yk_derive_inertia
} YkDeriveBody;

// A vector from one named point to another: p^{head/tail}, times -1 if it is followed backwards.
typedef struct YkDeriveVector {
    const char *head, *tail;
    int32_t body; // the body in whose axes it is fixed, or along whose line it grows
    bool is_negative;
    bool is_variable;       // contains a distance
    const YkPoisson *value; // without the sign, body form
} YkDeriveVector;

// A walk from point to point over joints.
typedef struct YkDerivePath {
    YkDeriveVector *vectors;
    size_t count;
    const YkPoisson *sum; // body form
} YkDerivePath;

// A joint that closes a loop: first body's point minus the second's = 0 (rows x and y) and, if it does not turn, the
// second body's angle minus the first's minus a constant = 0. Rows are in world axes, or in the axes of the body from
// which both branches of the loop start (`axes`).
typedef struct YkDeriveLoop {
    int32_t joint, axes;
    YkDerivePath path;      // its sum in world axes, body form
    const YkPoisson *sum;   // joint form, complex: 0 on the machine
    const YkPoisson *angle; // joint form; NULL if the joint turns, or if the tree already fixes the angle
} YkDeriveLoop;

// A constant that is not a polynomial of parameters (sqrt(l1^2 + 4 l2), atan(h/l)), or a number of many digits: a
// symbol of its own.
typedef struct YkDeriveConstant {
    int32_t symbol;
    const YkExpr *expr; // the expression it stands for (in SI; an angle in radians)
    double value;
    const YkPoisson *exact; // of a mass or an inertia: the number, or its symbol if the ring cannot hold it
} YkDeriveConstant;

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
    int32_t spring[2];   // symbols of the length and the rate of the spring whose force is being read
    YkDeriveCoordinate *coordinates;
    size_t coordinate_count, tree_count;   // all; those of the tree come first and agree with the mechanism's indices
    int32_t *joint_angle, *joint_distance; // per joint: its coordinate here, or YK_NONE
    YkDeriveBody *bodies;
    int32_t most_joints; // largest joints_in_angle
    int32_t most_depth;  // largest number of joints between a body and the ground
    // One for each angle, rate and acceleration of a body, made at first use; then one for each definition.
    YkRingChange *changes;
    size_t change_count, definition_count, change_capacity; // change_count: all
    YkRingChanges *to_joints;                               // the same, prepared
    const YkPoisson **body_angles;                          // made with them: angle of each body's axes, joint form
    YkDeriveLoop *loops; // in the file's order; yk_derive_loops makes them at first use
    size_t loop_count;
    struct YkDeriveNames *names; // of points; made at first use
    const char *pitch_stem;      // of pitch points; found at first use
    YkDeriveRelation *ties;      // gears, racks, belts, cams, laws (relations.h); made at first use
    size_t tie_count;
    YkDeriveConstant *constants;
    size_t constant_count, constant_capacity, opaque_count[2]; // all; those without exact values: k_1, alpha_1
    const YkPoisson **points;                                  // memo: of each model point in its body's axes
    struct YkDeriveSourceEntry {
        YkDeriveSource fill;
        void *context;
    } * sources;
    size_t source_count, source_capacity;
    YkDeriveBlocks *blocks;                 // made at first use
    struct YkCheckShared *checked;          // what checked equations share: prove/check_shared.c
    void (*forget_checks)(YkDerivation *d); // frees it; set with it
    struct YkLoopPlan *loop_plan;           // of random points, made at first use: prove/loop_plan.c
    struct YkDeriveTrain *train;            // gears, made at first use: derive/gears/gears.h
    int32_t *speeds;                        // per body: the symbol of its angular speed, omega1; made with the train
    struct YkDeriveOwn *own;                // symbols of the section of cams: derive/cams/cams.c
    const void *centers;                    // symbols of instant centres, made by their section: derive/centers.c
    int32_t *influence; // per coordinate: the symbol of its influence coefficient; made by the section of velocities
    // For proofs, added by sections: elements that are 0 on the machine, linear in accelerations and in these symbols.
    const YkPoisson **relations;
    size_t relation_count, relation_capacity;
    int32_t *unknowns;
    size_t unknown_count, unknown_capacity;
    struct YkDerivePages *pages;            // names that only sections have; made at first use: prove/equation_pages.c
    struct YkEquationOwn *own_of_equations; // angles, roots: prove/equation_angles.c
    YkProgress progress;                    // who watches
    YkPace pace;                            // of the long call that is running, or the last; the ring works for it
    YkText page;                            // the last page in print: page/derivation_page.c
    bool has_names;                         // JOINT.angle, BODY.rate, ... are entered as other names of symbols
    bool failed;                            // out of memory outside the ring
};

// Begins a long call: asks who watches. Returns false if it is to stop at once, or if another one was stopped.
bool yk_derivation_begin(YkDerivation *derivation);
void yk_derivation_end(YkDerivation *derivation);
// Returns whether everything derived so far exists: neither memory nor the ring has failed.
bool yk_derivation_is_well(const YkDerivation *derivation);
YkCode yk_derive_code(YkRingStatus status); // of the problem that reports it
// Returns zeroed memory for free(). Returns NULL when out of memory, which the derivation remembers.
void *yk_derive_scratch(YkDerivation *derivation, size_t count, size_t size);
// Returns whether it ran out of memory, in the ring or outside. It remains so, and its results must not be shown.
bool yk_derivation_ran_out(const YkDerivation *derivation);
// Returns why there is no result: memory if anything ran out of it, otherwise the status of the ring.
YkRingStatus yk_derivation_fault(const YkDerivation *derivation);

// --- From the file (expression.c, measures.c, constants.c, symbols.c)
// Returns an expression of the file in SI, exactly: parameters, coordinates, rates and t become symbols; decimals and
// units are exact (deg with the symbol pi). An expression that is not a polynomial becomes a symbol if it is constant;
// otherwise NULL with the status YK_RING_DIVISOR. NULL expression: 0.
const YkPoisson *yk_derive_expression(YkDerivation *d, const YkExpr *expr);
// Does the same, but returns NULL for NULL, and does not fail if the ring cannot hold it.
const YkPoisson *yk_derive_given(YkDerivation *d, const YkExpr *expr);
void yk_derive_forgive(YkDerivation *d); // forgets that the ring cannot hold a value
// Does the same for a mass or an inertia: a number of many digits becomes a constant symbol, letter_body (m_crank).
// Ask once for each: every call makes another.
const YkPoisson *yk_derive_measure(YkDerivation *d, const YkExpr *expr, YkRingClass kind, const char *letter,
                                   const char *body);
// Returns a stiffness or a damping in the same way; it keeps its number unless that has very many digits.
const YkPoisson *yk_derive_strength(YkDerivation *d, const YkExpr *expr, const char *letter, const char *spring);
// Returns the symbol of a constant that the ring cannot hold, k_1 or alpha_1: one for each expression. Returns NULL
// if it is not a constant.
const YkPoisson *yk_derive_constant(YkDerivation *d, const YkExpr *expr, bool is_angle, int32_t *symbol);
// Writes the meaning of masses and inertias, or of other constants: of those that the page has not explained yet.
void yk_derive_put_constants(YkDerivation *d, YkPage *page, bool of_masses);
// Returns e^(i expr) of an angle. NULL expression: 1.
const YkPoisson *yk_derive_turn(YkDerivation *d, const YkExpr *expr);
// Makes a new symbol: `name` adapted to the ring (other characters become _, a name in use gets one more _).
// Returns -1 on failure.
int32_t yk_derive_symbol(YkDerivation *d, const char *name, YkRingClass kind);
// Returns a fraction as an element; NULL if it does not fit the ring's numbers.
const YkPoisson *yk_derive_fraction(YkDerivation *d, const YkFraction *a);
// Lets the symbol stand for `meaning` from now on: joint form replaces it, and numbers follow it. `meaning` may
// contain symbols that were defined before, but no e^(i angle). Returns false on failure.
bool yk_derive_define(YkDerivation *d, int32_t symbol, const YkPoisson *meaning);
// Returns a parameter in terms of others; NULL if it is a number of its own (or not a polynomial).
const YkPoisson *yk_derive_definition(YkDerivation *d, size_t parameter);

// Join three texts, and a text with a number in decimals; "" with d->failed when out of memory (text.c).
const char *yk_derive_text(YkDerivation *d, const char *first, const char *second, const char *third);
const char *yk_derive_numbered(YkDerivation *d, const char *stem, size_t number);
char *yk_derive_digits(char *end, size_t number); // writes a number before `end`; returns its first digit

// --- The machine (geometry.c, path.c)
const YkPoisson *yk_derive_at(YkDerivation *d, int32_t point);       // in the body's axes; YK_NONE: the origin
const YkPoisson *yk_derive_along(YkDerivation *d, int32_t joint);    // a slide's direction in its first body's axes
const YkPoisson *yk_derive_distance(YkDerivation *d, int32_t joint); // the symbol; NULL if it does not slide
// Returns the vector from the first body's place to the second's along the line: distance * unit vector, body form.
const YkPoisson *yk_derive_slide(YkDerivation *d, int32_t joint);
// Return positions in the world, body form: of a body's origin, and of a place given in its axes.
// Cost: the body's depth in the tree.
const YkPoisson *yk_derive_origin(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_position(YkDerivation *d, int32_t body, const YkPoisson *at);
// For a body with mass: its centre of mass in its axes, mass, inertia about the centre (a rod's follow); 0 if not
// given.
const YkPoisson *yk_derive_center(YkDerivation *d, int32_t body);
bool yk_derive_is_rod(const YkBody *body);
const YkPoisson *yk_derive_mass(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_inertia(YkDerivation *d, int32_t body);
const YkPoisson *yk_derive_gravity(YkDerivation *d); // complex; 0 if there is none
// Returns the loops; NULL on failure (and if there are none: loop_count is 0). Cost: O(sum of the lengths of the
// loops).
const YkDeriveLoop *yk_derive_loops(YkDerivation *d);
// Takes an element from body form to joint form. In joint form the body's spin is the sum of B[k] * rate of
// coordinate k, B[k] in -1, 0, 1; yk_derive_combination writes B (tree_count entries).
const YkPoisson *yk_derive_in_joints(YkDerivation *d, const YkPoisson *a);
YkRingChanges *yk_derive_to_joints(YkDerivation *d); // what leads to joint form; NULL: nothing does, or on failure
void yk_derive_combination(const YkDerivation *d, int32_t body, int32_t *B);

// Returns the name of a point, as short as is clear: "A"; "crank.A" if points called A do not all coincide. The
// origin has the name of a point that the file puts there, or the body's name with 0.
const char *yk_derive_point_name(YkDerivation *d, int32_t body, int32_t point);
const char *yk_derive_center_name(YkDerivation *d, int32_t body); // C1, C2, ... unless taken
// Returns the name of the pitch point of the model's gear or, counted after the gears, rack: P1, P2, ...; Q1, T1,
// pitch1, ... if the file has points with such names. It is the same in every section and drawing.
const char *yk_derive_pitch_name(YkDerivation *d, size_t gear_or_rack);
// A walk from the place `from` (a point of a body, by its index or YK_NONE for the origin) to the place `to`.
typedef struct YkDerivePlace {
    int32_t body, point;
} YkDerivePlace;
bool yk_derive_path(YkDerivation *d, YkDerivePlace from, YkDerivePlace to, YkDerivePath *path);
// Returns the place where joint j holds body side 0 or 1: `from` or `at` on the first, `to` or `at` on the second.
YkDerivePlace yk_derive_place(const YkDerivation *d, int32_t joint, int side);

// --- Values (numeric_values.c)
// Fills values[yk_ring_symbol_count(d->ring)]: parameters and constants from the file, coordinates and bodies from
// the state, what sources know, 0 for the rest. dynamics may be NULL. The values are ready for yk_ring_value.
void yk_derive_values(YkDerivation *d, const YkState *state, YkDynamics *dynamics, double *values);
bool yk_derive_add_source(YkDerivation *d, YkDeriveSource fill, void *context);
// For --check: `zero` (an element, in any form) is 0 on the machine; `unknown` is a symbol that such elements
// determine (a force, a multiplier, an effort), together with the accelerations, in which they are linear. Solved at
// random points of the field.
bool yk_derive_add_relation(YkDerivation *d, const YkPoisson *zero);
bool yk_derive_add_unknown(YkDerivation *d, int32_t symbol);

// --- Sections (sections.c)
// A section adds its headings and formulas to a page. It returns false when something failed (see the ring's status).
typedef bool (*YkDeriveSection)(YkDerivation *d, YkPage *page);
typedef struct YkDeriveSectionEntry {
    const char *name;  // as --what takes it
    const char *title; // heading
    YkDeriveSection write;
    // Returns whether `all` has it: the model has such a part, and no other section has the same; NULL: always.
    bool (*is_of)(const YkModel *model);
    bool has_masses; // masses and inertias occur in it
} YkDeriveSectionEntry;
extern const YkDeriveSectionEntry yk_derive_sections[]; // in the order of `all`; ends at name NULL
// Writes a section by its index, heading included.
bool yk_derive_write(YkDerivation *d, size_t section, YkPage *page);

#endif
