// Forces in symbols: what acts on every body, named as on an engineer's free-body diagram: F_ij is exerted by body i on
// body j. Shared by the sections of free bodies, Newton-Euler, energies and Lagrange. Everything is in body form.
//
// Every force is a *push* on a body: a force at an arm from the body's reference - its centre of mass, or its origin if
// it has no mass - and a couple. Loads are known pushes; contacts are those of joints, whose sizes are unknowns.
#ifndef DERIVE_FORCES_FREE_BODIES_H
#define DERIVE_FORCES_FREE_BODIES_H
#include "derive/derive.h"

typedef struct YkDerivePush {
    int32_t body;
    const YkPoisson *arm;    // from the reference to where the force acts, world axes
    const YkPoisson *force;  // world axes, complex
    const YkPoisson *moment; // of a couple, besides arm x force
} YkDerivePush;

typedef enum YkDeriveLoadKind {
    YK_DERIVE_GRAVITY,
    YK_DERIVE_SPRING,
    YK_DERIVE_DAMPER, // also viscous friction
    YK_DERIVE_PULL,   // of a spring, by a law of its own
    YK_DERIVE_DRY,    // dry friction and stops: a symbol, whose size depends on the pose
    YK_DERIVE_FORCE,
    YK_DERIVE_EFFORT, // from `efforts:`
    YK_DERIVE_DRIVE   // that a drive must exert: unknown
} YkDeriveLoadKind;

typedef struct YkDeriveLoad {
    YkDeriveLoadKind kind;
    const char *name;      // the word for it
    int32_t joint, symbol; // along this joint, or YK_NONE; DRIVE and DRY: its symbol
    YkDerivePush push[2];
    size_t push_count;
    const YkPoisson *energy; // potential, of gravity and springs; otherwise NULL
} YkDeriveLoad;

// A joint, and the side of it on which the body is that it holds.
typedef struct YkDeriveHolder {
    int32_t joint, side;
} YkDeriveHolder;

// The action of a joint, a junction or a relation - gears, a rack, a belt, a cam, a law - on one body.
typedef struct YkDeriveContact {
    int32_t joint, junction;       // junction: YK_NONE if there is none; joint: YK_NONE for a relation
    const char *by, *point;        // of a relation: what exerts it, and the name of the point where it acts
    const YkDeriveHolder *holders; // of a relation: the joints that keep the body in its assumed place
    size_t holder_count;
    const char *letter, *between; // "F", "01"; NULL if it exerts no force
    const char *moment;           // "M"; NULL if it exerts none
    bool is_negative;             // this body is the first: its names are those of the second's
    YkDerivePush push;            // with the sign
    int32_t next;                 // the next contact at the same junction, or YK_NONE
} YkDeriveContact;

// A pin that joins several bodies: a massless junction, in equilibrium under the forces of all of them.
typedef struct YkDeriveJunction {
    const char *name;
    YkDerivePlace place;    // the point of a body with which it moves
    const YkPoisson *force; // sum of all contacts on it: 0
    int32_t first_joint, first_contact, last_contact;
} YkDeriveJunction;

// Lists of what acts on every body.
typedef struct YkDeriveActing {
    int32_t *first, *entry; // body b's entries are those from first[b] to first[b + 1]
} YkDeriveActing;

typedef struct YkDeriveMass {
    const YkPoisson *mass, *inertia, *center; // center: in the body's axes
    const YkPoisson *position, *velocity,
        *acceleration;     // of the reference; without position and velocity: NULL
    int32_t symbols[2];    // then: the acceleration's x and y
    const YkPoisson *step; // and its difference from that of the parent's reference
    bool is_trivial;       // its moment balance says only that its guide exerts no moment
} YkDeriveMass;

// A symbol for a load's value that is not a polynomial.
typedef struct YkDeriveOpaque {
    int32_t symbol;
    const YkExpr *expr;
    const struct YkFormula *formula;
    const YkLaw *law;   // of the formula, or NULL
    int32_t *variables; // [variable_count] symbols; [0] is the time
    size_t variable_count;
} YkDeriveOpaque;

// The unknown that a relation transmits; all its contacts are multiples of it.
typedef struct YkDeriveMesh {
    int32_t symbol;
    const char *word;        // what it is
    YkDerivePush push;       // on its second body: gives the unknown its value
    const YkPoisson *effort; // minus its multiplier
    // The angle of the line of action: for gears the pressure angle with the sign of the unknown, for cams that of
    // `direction`, whose length is `length`. YK_NONE: none.
    int32_t lean;
    double lean_value;
    const YkPoisson *direction, *length;
    // Cams with two rollers: symbols that say which one bears, with their values for the first and the second. YK_NONE:
    // none.
    int32_t bearing[2];
    double bearing_value[2][2];
} YkDeriveMesh;

// A symbol for a quotient of constants that is not a polynomial.
typedef struct YkDeriveRatio {
    int32_t symbol;
    const YkPoisson *over, *under;
    const char *word;
} YkDeriveRatio;

// The length of a spring between points, and its rate if a damper needs it: symbols. Also other roots.
typedef struct YkDeriveLength {
    const char *word;               // what it is; NULL: a spring's length; "": not shown
    int32_t symbol, rate_symbol;    // rate: YK_NONE
    const YkPoisson *square, *rate; // L^2; dL/dt, with L in the denominator
} YkDeriveLength;

// A polynomial in constants under a name of its own.
typedef struct YkDeriveLump {
    int32_t symbol;
    const YkPoisson *value;
    struct YkDeriveLump *next;
} YkDeriveLump;

// Lagrange: a row for each scalar equation of the loops, then for each relation; its multiplier, and what that is as a
// joint force or as what the relation transmits.
typedef struct YkDeriveMultipliers {
    bool is_made;
    size_t count;
    const YkPoisson **rows, **identities; // row: NULL of a relation
    int32_t *symbols, *joint;             // joint: YK_NONE of a relation
} YkDeriveMultipliers;

struct YkDeriveLagrange;
typedef struct YkDeriveForces {
    YkDerivation *d;
    bool is_related; // relations are entered
    YkDeriveMass *bodies;
    YkDeriveLoad *loads;
    size_t load_count;
    YkDeriveContact *contacts;                 // joint by joint
    size_t contact_count, joint_contact_count; // those of relations come last
    YkDeriveActing contacts_on, pushes_on;
    YkDeriveJunction *junctions;
    size_t junction_count;
    int32_t *junction_of, *next_at_junction; // per joint, or YK_NONE
    bool *is_double;                         // per joint, then relation: another one is between the same two bodies
    const YkPoisson **joint_force, **joint_moment; // per joint: on the second body by the first
    int32_t *reactions;                            // symbols, joint by joint
    size_t reaction_count;
    int32_t *reaction_joint, *reaction_body; // per reaction: joint, and of a junction's the body; otherwise YK_NONE
    char *reaction_part;                     // 'x' 'y' 'n' (normal) 'm' (moment) 'r' (of a relation)
    YkDeriveMesh *meshes;                    // per relation
    int32_t *efforts;                        // symbols of unknown efforts
    int32_t *effort_coordinate;
    size_t effort_count;
    YkDeriveOpaque *opaques;
    size_t opaque_count;
    YkDeriveLength *lengths; // of springs; other roots
    size_t length_count;
    YkDeriveRatio *ratios;
    size_t ratio_count;
    YkDeriveMultipliers *multipliers;                          // memo: yk_derive_multipliers
    const YkPoisson **kinetic, **newton, **euler, **potential; // memo: per body, [0]
                                                               // of kinetic: in total; [1]
    const YkPoisson **closing; // memo: second derivatives of what closes loops, as shown
    const char **closing_name;
    int *closing_count;                // [1]; -1: not made yet
    struct YkDeriveLagrange *lagrange; // memo: per coordinate of the body form; the same, in joint form
    struct YkDeriveLagrange *lagrange_in_joints;
    YkDeriveLump **lumps; // [1]: the first
} YkDeriveForces;

// The forces, made at first use; NULL on failure. Cost: O(bodies * depth).
const YkDeriveForces *yk_derive_forces(YkDerivation *d);
// Does the same for proofs (--check), with the relations between the symbols, in joint form. Returns false on failure.
bool yk_derive_enter_forces(YkDerivation *d);

// --- Coordinates of the body form: one for each coordinate of the machine, in order: the angle of the body that
// its joint carries, or the distance.
typedef struct YkDeriveFreedom {
    int32_t position, rate, acceleration, body; // symbols; body: YK_NONE for a distance
} YkDeriveFreedom;
YkDeriveFreedom yk_derive_freedom(const YkDerivation *d, size_t coordinate);
// Returns the angle of a body's axes outside cos and sin, body form.
const YkPoisson *yk_derive_axes_angle(YkDerivation *d, int32_t body);

// --- Equations, as elements that are 0
// Newton: sum of the forces on a body minus mass times acceleration, complex. Euler: moments about its reference.
const YkPoisson *yk_derive_newton(const YkDeriveForces *f, int32_t body);
const YkPoisson *yk_derive_euler(const YkDeriveForces *f, int32_t body);
// Returns arm x force + couple of a push.
const YkPoisson *yk_derive_moment_of(const YkDeriveForces *f, const YkDerivePush *push);
// Projects all of them, and those of the junctions, on the partial velocities of a coordinate of the body form.
const YkPoisson *yk_derive_projected(const YkDeriveForces *f, size_t coordinate);
// Returns a load's generalised force along a coordinate of the body form.
const YkPoisson *yk_derive_generalised(const YkDeriveForces *f, const YkDeriveLoad *load, size_t coordinate);
// Finds the second derivatives of the conditions of closing joints and relations, without closing joints'
// distances, as shown: f->closing, f->closing_name. Returns their count, or -1 on failure.
int yk_derive_closing_rows(const YkDeriveForces *f);

// --- Energies, body form
const YkPoisson *yk_derive_kinetic(const YkDeriveForces *f, int32_t body);
const YkPoisson *yk_derive_kinetic_total(const YkDeriveForces *f);
const YkPoisson *yk_derive_potential(const YkDeriveForces *f);
const char *yk_derive_energy_name(const YkDeriveForces *f, size_t load); // of a load's, behind V_

// Returns the multipliers, made at first use.
const YkDeriveMultipliers *yk_derive_multipliers(const YkDeriveForces *f);

// --- Lagrange: equation of a coordinate of the body form, left = right: inertia, potential, dampers and multipliers on
// the left; efforts and forces on the right.
typedef struct YkDeriveLagrange {
    const YkPoisson *left, *right;
} YkDeriveLagrange;
YkDeriveLagrange yk_derive_lagrange(const YkDeriveForces *f, size_t coordinate);
// Does the same for the machine's own coordinate: a sum over the bodies that it turns; joint form with `in_joints`.
YkDeriveLagrange yk_derive_lagrange_of(const YkDeriveForces *f, size_t coordinate);

// --- The count of equations and unknowns: inverse (all inputs given) or as in the file.
YkEquationCount yk_derive_count(const YkDeriveForces *f, bool all_given);

// --- Returns whether to show joint angles. Beyond a few links their sums are not readable, and body form is shown.
bool yk_derive_shows_joints(const YkDerivation *d);
const YkPoisson *yk_derive_shown(YkDerivation *d, const YkPoisson *a);
YkRingChanges *yk_derive_shown_by(YkDerivation *d); // the changes that do this; NULL if there are none
// Returns the acceleration of a coordinate as it is shown: its own, or in body form that of its body.
int32_t yk_derive_shown_acceleration(const YkDerivation *d, size_t coordinate);
// Says which angles are used, if they are the bodies' own.
void yk_derive_put_angles(YkDerivation *d, YkPage *page);
// Writes the meaning of the symbols of springs' lengths and rates.
void yk_derive_put_lengths(const YkDeriveForces *f, YkPage *page);
// Writes what relations transmit, and the meaning of the symbols of other roots and of quotients.
void yk_derive_put_meshes(const YkDeriveForces *f, YkPage *page);
void yk_derive_put_loads(const YkDeriveForces *f, YkPage *page); // the same for loads that are not polynomials
// Returns the name of the joint or relation to which a row of Lagrange's multipliers belongs.
const char *yk_derive_row_name(const YkDeriveForces *f, size_t row);
// Positions of bodies with more joints than this between them and the ground are not written out: in a chain of n
// links they would fill n^2 terms. Their accelerations are symbols, each from that of the body before
// (yk_derive_put_step).
enum { YK_DERIVE_DEPTH_MAX = 100 };
// Says so in sections that need positions. Returns true if the section ends with that.
bool yk_derive_put_depth(const YkDerivation *d, YkPage *page);
// The largest number of bodies in formulas of all bodies together.
enum { YK_DERIVE_TOGETHER_MAX = 1000 };
// Writes the meaning of the acceleration symbols of such a body; nothing for others.
void yk_derive_put_step(const YkDeriveForces *f, YkPage *page, int32_t body);

// --- acting.c: what acts on a body, in order. Contacts have their index; pushes are 2 * load + push.
const int32_t *yk_derive_contacts_on(const YkDeriveForces *f, int32_t body, size_t *count);
const int32_t *yk_derive_pushes_on(const YkDeriveForces *f, int32_t body, size_t *count);

// --- free_bodies.c: pieces of vector equations
// All contact forces on a body. Returns whether the line is still empty.
bool yk_derive_put_contacts(const YkDeriveForces *f, YkPage *page, YkLine *line, int32_t body, bool first);
void yk_derive_put_load(YkPage *page, YkLine *line, const YkDeriveLoad *load, size_t push, bool first);
// All forces and couples on a body, a line each with its value: contacts, loads, inertia.
void yk_derive_put_acting(const YkDeriveForces *f, YkPage *page, int32_t body);
const char *yk_derive_load_letter(YkDeriveLoadKind kind);
const char *yk_derive_couple_name(const YkDeriveForces *f, const YkDeriveLoad *load);
const char *yk_derive_load_word(YkDeriveLoadKind kind);                               // "weight", "spring", ...
const char *yk_derive_giver(const YkDeriveForces *f, const YkDeriveContact *contact); // the other body, or "the pin A"
// Returns the point at which a contact acts.
const char *yk_derive_contact_point(YkDerivation *d, const YkDeriveContact *contact);
const char *yk_derive_load_point(const YkDeriveForces *f, const YkDeriveLoad *load, size_t push);

// --- parts of entering
bool yk_derive_enter_masses(YkDeriveForces *f);
bool yk_derive_enter_loads(YkDeriveForces *f);
bool yk_derive_allocate_multipliers(YkDeriveForces *f);
bool yk_derive_enter_contacts(YkDeriveForces *f);
bool yk_derive_find_junctions(YkDeriveForces *f); // of contacts; false when out of memory
bool yk_derive_enter_meshes(YkDeriveForces *f);   // the contacts of relations, after those of joints
bool yk_derive_sort_contacts(YkDeriveForces *f);  // false when out of memory
bool yk_derive_sort_pushes(YkDeriveForces *f);
// contact_names.c: marks joints and relations (behind them) between two bodies that another joint or relation is
// between, too. Returns false when out of memory.
bool yk_derive_find_doubles(YkDerivation *d, bool *is_double);
// Makes a new symbol of a joint's or relation's force: letter, bodies ("12"), part.
const char *yk_derive_force_name(const YkDeriveForces *f, const char *letter, const char *name, const char *part);
// Returns "01": exerted by the ground on body 1; the name is added if others join the same two bodies. index: of
// the joint, or joint count + relation.
const char *yk_derive_between(const YkDeriveForces *f, const int32_t body[2], size_t index, const char *name);
// Returns the positive root of a square as a symbol; exact if it is a number.
const YkPoisson *yk_derive_root(YkDeriveForces *f, const char *name, const char *word, const YkPoisson *square);
// Returns over / under of constants: exact if that is a polynomial, otherwise a symbol.
const YkPoisson *yk_derive_ratio(YkDeriveForces *f, const char *name, const char *word, const YkPoisson *over,
                                 const YkPoisson *under);
// Returns whether it is 0 with the definitions of roots, ratios and the lines of action of cams.
bool yk_derive_is_nothing(const YkDeriveForces *f, const YkPoisson *a);
// Returns the vector from a body's reference to a place given in its axes, in world axes.
const YkPoisson *yk_derive_arm(YkDeriveForces *f, int32_t body, const YkPoisson *at);
// Does the same for the place where a joint's force acts; on the first body of a slide it moves along the line.
const YkPoisson *yk_derive_joint_arm(YkDeriveForces *f, int32_t joint, int side);
// Returns a load's value: an element, or a symbol for it, named by both texts.
const YkPoisson *yk_derive_load_value(YkDeriveForces *f, const YkStrength *strength, const char *name,
                                      const char *ending);

#endif
