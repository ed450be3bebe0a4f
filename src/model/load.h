// The inside of the loader, shared by its files while a tree of nodes becomes a YkModel.
//
// Reading and evaluating are two passes. The first reads every section, and puts each expression that is more than a
// number into a list of uses. The second checks the names in them, infers dimensions over the whole file, orders and
// evaluates the parameters, then fills the targets. A value that could not be determined is NaN, which means "reported
// already" to the checks.
#ifndef MODEL_LOAD_H
#define MODEL_LOAD_H
#include "base/problems.h"
#include "base/text.h"
#include "doc/node.h"
#include "model/model.h"

enum { YK_NAME_MAX = 100, YK_COUNT_MAX = 10000000, YK_REPORTED = -2 };
#define YK_VALUE_MAX 1e100

#define YK_DIM(l, m, t, a) ((YkDimension){.length = (l), .mass = (m), .time = (t), .angle = (a)})
#define YK_DIM_NUMBER YK_DIM(0, 0, 0, 0)
#define YK_DIM_ANGLE YK_DIM(0, 0, 0, 1)
#define YK_DIM_LENGTH YK_DIM(1, 0, 0, 0)
#define YK_DIM_MASS YK_DIM(0, 1, 0, 0)
#define YK_DIM_TIME YK_DIM(0, 0, 1, 0)
#define YK_DIM_ANGLE_RATE YK_DIM(0, 0, -1, 1)
#define YK_DIM_SPEED YK_DIM(1, 0, -1, 0)
#define YK_DIM_ANGLE_ACCELERATION YK_DIM(0, 0, -2, 1)
#define YK_DIM_ACCELERATION YK_DIM(1, 0, -2, 0)
#define YK_DIM_FORCE YK_DIM(1, 1, -2, 0)
#define YK_DIM_TORQUE YK_DIM(2, 1, -2, 0)
#define YK_DIM_INERTIA YK_DIM(2, 1, 0, 0)
#define YK_DIM_STIFFNESS YK_DIM(0, 1, -2, 0)
#define YK_DIM_DAMPING YK_DIM(0, 1, -1, 0)
#define YK_DIM_TURN_STIFFNESS YK_DIM(2, 1, -2, -1)
#define YK_DIM_TURN_DAMPING YK_DIM(2, 1, -1, -1)

// The names that an expression may mention besides parameters and pi.
typedef enum YkScope { YK_SCOPE_CONSTANT, YK_SCOPE_TIME, YK_SCOPE_STATE } YkScope;

// Describes a value for messages: "x of point `A` of `link1`" is {"x of ", "point", "A", "link1"}; all but noun may be
// NULL.
typedef struct YkSubject {
    const char *axis, *noun, *part, *owner;
} YkSubject;

// A name that means something else in one value alone: `length` of a spring in its force.
typedef struct YkOwnName {
    const char *name, *means;
    const char *whose; // for messages
} YkOwnName;

typedef struct YkWant {
    YkDimension dimension;
    YkScope scope;
    YkSubject subject;
    const YkOwnName *own; // [.], the last without a name; or NULL
} YkWant;

// An expression that waits for its value.
typedef struct YkUse {
    YkExpr *expr;
    YkDimension dimension;
    YkScope scope;
    const char *what;
    double *target; // SI; NULL if only names and dimensions matter
    bool is_bad;    // a name in it is unknown
} YkUse;

typedef struct YkLoader {
    YkModel *model;
    YkArena *arena; // that of the model
    YkProblems *problems;
    const YkNode *root;
    const YkLoadOptions *options;
    YkDimensions *dimensions;
    YkUse *uses;
    size_t use_count, use_capacity;
    size_t coordinate_capacity;
    const YkExpr **replaced; // per parameter: the expression that an override replaced, or NULL
    YkNames fixed;           // names whose dimension is already fixed
    YkText text;             // scratch
    bool *is_wheel;          // per body: gears, belts or racks name it, so its centre is its origin
    bool has_bad_units;      // what bare numbers mean is not known
    bool has_bad_joint;      // a joint's bodies are unknown, so connections cannot be judged
    bool is_sketch;          // what nothing connects to the ground is welded to it
    bool failed;             // out of memory
} YkLoader;

// Counts the work of an entry of a section, or of an expression. Returns false once the caller has stopped the loading:
// the steps that are left are then passed over, and what was read so far is discarded.
static inline bool yk_load_goes_on(const YkLoader *loader)
{
    enum { ENTRY = 1000 };
    return yk_pace_spend(loader->arena->pace, ENTRY);
}

// source.c: keeps the text, with the values that overrides replaced.
void yk_load_keep_source(YkLoader *loader, const char *source, size_t length);
// Adds to `text` the source of a model with new values of a section of plain values: `parameters`, `start`. Comments
// and layout stay. Returns false if the section has other entries, or a value that is folded over lines by `>`;
// text->failed is set when out of memory.
bool yk_source_replace(const char *source, const char *section, const YkOverride *values, size_t count, YkText *text);

// A document that is not a machine but has units, parameters and values as a machine's file has them, such as a task.
// yk_model_read then gives a model that holds these and nothing else.
typedef struct YkSheet {
    const char *noun;        // "a task file"
    const char *const *keys; // all top-level keys, `units` and `parameters` among them; NULL-terminated
    void (*read)(YkLoader *loader, void *context);   // the first pass: reads the sections
    void (*finish)(YkLoader *loader, void *context); // checks that need values; NaN: reported already
    void *context;
} YkSheet;

// values.c: single values, pairs of values, and kinds of nodes.
const char *yk_load_subject(YkLoader *loader, const YkSubject *subject); // in scratch
bool yk_load_is_empty(const YkNode *node);                               // nothing, `~` or `null`
// Returns whether a node is of this kind; reports it as wrong or empty otherwise.
bool yk_load_expect(YkLoader *loader, const YkNode *node, YkNodeKind kind, const YkSubject *subject);
// Returns the place where the expression of a scalar begins (after its quote).
YkPlace yk_load_text_place(const YkNode *node);
// Reads a scalar; the target gets its value now (a plain number) or in the second pass. Returns NULL after a mistake.
YkExpr *yk_load_value(YkLoader *loader, const YkNode *node, const YkWant *want, double *target);
// Returns whether a node is a list of two; otherwise adds a problem.
bool yk_load_expect_pair(YkLoader *loader, const YkNode *node, const YkWant *want);
// Reads [x, y].
bool yk_load_pair(YkLoader *loader, const YkNode *node, const YkWant *want, YkExpr *expr[2], YkVec *target);
// strengths.c: reads an expression, or {law: NAME, of: expression}; without `want->own` the scope is that of `want`.
YkStrength yk_load_strength(YkLoader *loader, const YkNode *node, const YkWant *want);
// Reports a value that cannot be, in the file's units. The message takes a noun, its owner, the amount and its unit:
// "the %s of %q is %e %s; it must be positive".
void yk_load_refuse_amount(YkLoader *loader, YkCode code, const YkExpr *expr, double value, YkDimension dimension,
                           const char *message, const char *noun, const char *owner);
// Reports a value that is not finite or too large, and returns false for it.
bool yk_load_in_range(YkLoader *loader, YkPlace place, double value);

// keys.c: sections and their keys.
// Returns a section of the file: a map, or NULL if it is missing, empty or (reported) something else.
const YkNode *yk_load_section(YkLoader *loader, const char *key);
// Reports every key of the map that is not among `keys` (NULL-terminated).
void yk_load_check_keys(YkLoader *loader, const YkNode *map, const char *const *keys, const YkSubject *subject);
const YkNode *yk_load_key(const YkNode *map, const char *key); // the key itself, for its place; or NULL
// Returns whether a section may have this many entries; reports it otherwise.
bool yk_load_count_fits(YkLoader *loader, const YkNode *section, size_t count, const char *noun);

// Reads the value of a key: returns its expression, or NULL if it is left out (the target is 0) or wrong (NaN).
YkExpr *yk_load_key_value(YkLoader *loader, const YkNode *map, const char *key, const YkWant *want, double *target);
// Returns the node of a required key; NULL if it is missing (reported).
const YkNode *yk_load_require(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject);

// names.c: which names are allowed, and the nearest name.
bool yk_load_name(YkLoader *loader, const YkNode *node, const char *noun);
bool yk_load_symbol_name(YkLoader *loader, const YkNode *node, const char *noun); // for expressions
// Hints at the nearest name, for the last problem, among structs of `size` bytes that begin with their name; returns
// false if none is near.
bool yk_load_hint_nearest(YkProblems *problems, const char *name, const void *items, size_t count, size_t size);
void yk_load_hint_nearest_key(YkLoader *loader, const char *name, const char *const *keys);
void yk_load_hint_nearest_symbol(YkLoader *loader, const char *name); // parameters and coordinates

// find.c: finds bodies and points by name, and reports names that do not exist.
int32_t yk_load_find_point(YkLoader *loader, int32_t body, const char *name);    // YK_NONE, silent
int32_t yk_load_body(YkLoader *loader, const YkNode *node);                      // YK_NONE, reported
int32_t yk_load_point(YkLoader *loader, int32_t body, const YkNode *node);       // YK_NONE, reported
int32_t yk_load_body_point(YkLoader *loader, const YkNode *node, int32_t *body); // "body.point"

// coordinates.c
// Declares the coordinate `name` of a joint; reports a name that is taken. Returns its index or YK_NONE.
int32_t yk_load_declare(YkLoader *loader, const char *name, YkPlace place, int32_t joint, bool is_distance);
// Returns the coordinate that NAME, NAME.rate, JOINT.angle, JOINT.distance.rate, ... refer to; declares JOINT.angle if
// it has no name yet. Returns YK_NONE if there is none; YK_REPORTED if the joint has no such freedom (reported).
int32_t yk_load_coordinate(YkLoader *loader, const char *text, YkPlace place, bool *is_rate);
const char *yk_load_rate_name(YkLoader *loader, const char *coordinate); // NAME.rate, in the arena
// Does the same for a key of drives, start, efforts or stops: reports every failure, also `.rate` if is_rate is NULL.
int32_t yk_load_coordinate_key(YkLoader *loader, const YkNode *key, bool *is_rate);
// Allocates one byte for every coordinate that exists or that this section may declare.
unsigned char *yk_load_new_seen(YkLoader *loader, const YkNode *section);
// Returns the coordinate of a key that names it for the first time in its section; otherwise a negative number
// (reported).
int32_t yk_load_coordinate_once(YkLoader *loader, const YkNode *key, unsigned char *seen, bool *is_rate);

// The sections, one file each.
void yk_load_units(YkLoader *loader);
void yk_load_parameters(YkLoader *loader);
void yk_load_overrides(YkLoader *loader);
void yk_load_bodies(YkLoader *loader);
void yk_load_points(YkLoader *loader, const YkNode *bodies, const YkNode **nodes);
void yk_load_mass(YkLoader *loader, int32_t body, const YkNode *node);
void yk_load_joints(YkLoader *loader);
void yk_load_laws(YkLoader *loader);                       // after the joints, before everything that uses laws
int32_t yk_load_law(YkLoader *loader, const YkNode *node); // a law by name; YK_NONE, reported
// Adds a law over an angle that is not of the file, to be made later; YK_NONE when out of memory.
int32_t yk_load_make_law(YkLoader *loader, const char *name, YkPlace place);
void yk_load_cam_arcs(YkLoader *loader, YkCam *cam, const YkNode *node); // cam_arcs_read.c: reads them
void yk_load_finish_cam_arcs(YkLoader *loader, const YkCam *cam);        // makes the law of the lift
void yk_load_cams(YkLoader *loader);                                     // after the laws
// free_joints.c: joints that leave all three freedoms.
size_t yk_load_count_free(YkLoader *loader);
size_t yk_load_count_planets(YkLoader *loader); // room for bodies, and joints, that yk_load_share_planets may add
void yk_load_carriages(YkLoader *loader);       // after the bodies of the file, whose room has to suffice
// Makes joint `index`, whose bodies are read, of itself and the joint `slide` with the carriage between them.
void yk_load_free_joint(YkLoader *loader, int32_t index, int32_t carriage, int32_t slide, const YkNode *node);
void yk_load_joint_points(YkLoader *loader, YkJoint *joint, const YkNode *node);
void yk_load_drives(YkLoader *loader);
void yk_load_starts(YkLoader *loader);
void yk_load_gravity(YkLoader *loader);
void yk_load_efforts(YkLoader *loader);
void yk_load_forces(YkLoader *loader);
void yk_load_springs(YkLoader *loader);
void yk_load_stops(YkLoader *loader);
void yk_load_friction(YkLoader *loader, const YkNode *node, YkJoint *joint);
void yk_load_wheels(YkLoader *loader); // before the joints: finds which bodies are wheels
void yk_load_gears(YkLoader *loader);
void yk_load_racks(YkLoader *loader);
// racks.c: the pin by which a body holds the pinion's centre; NULL: none.
const YkJoint *yk_rack_pin(const YkModel *model, const YkRack *rack, int32_t body);
bool yk_rack_keeps_side(const YkModel *model, const YkRack *rack); // racks.c: of its pinion, where points have moved
void yk_load_belts(YkLoader *loader);
void yk_load_locks(YkLoader *loader);
void yk_load_engage(YkLoader *loader); // options->lock, after everything else

// The second pass.
void yk_load_check_uses(YkLoader *loader);      // expressions.c: the names in every expression
void yk_load_infer(YkLoader *loader);           // expressions.c: dimensions
void yk_load_eval_parameters(YkLoader *loader); // order.c: each once, after those it needs
void yk_load_check_overrides(YkLoader *loader); // overrides.c: against the dimension in the file
void yk_load_eval_uses(YkLoader *loader);       // expressions.c
void yk_load_keep_uses(YkLoader *loader);       // in the model, for redesigns
void yk_load_check_gravity(YkLoader *loader);   // model/loads/gravity.c: warns of units that no one would mean
void yk_load_finish_laws(YkLoader *loader);     // model/laws/build.c
void yk_load_finish_cams(YkLoader *loader);     // model/transmissions/cams_finish.c: after joints and laws
void yk_load_finish_masses(YkLoader *loader);   // model/loads/mass.c
void yk_load_finish_joints(YkLoader *loader);   // joint_points.c
void yk_load_finish_forces(YkLoader *loader);   // model/loads/forces.c
void yk_load_finish_springs(YkLoader *loader);  // model/loads/springs.c
void yk_load_finish_stops(YkLoader *loader);    // model/loads/stops.c
void yk_load_finish_friction(YkLoader *loader); // model/loads/friction.c
void yk_load_finish_gears(YkLoader *loader);    // model/transmissions/gears.c: after the joints, like the next two
void yk_load_share_planets(YkLoader *loader);   // model/transmissions/planets.c: after all loads and transmissions
void yk_load_finish_racks(YkLoader *loader);    // model/transmissions/racks.c
void yk_load_finish_belts(YkLoader *loader);    // model/transmissions/belts.c
void yk_load_check_connected(YkLoader *loader); // connected.c
void yk_load_check_links(YkLoader *loader);     // links.c
bool yk_load_size(YkModel *model);              // size.c; false when out of memory

// model/transmissions/wheels.c: shared by gears, racks and belts.
// Reads a list of two different bodies under `key`; reports anything else. The node may be NULL (reported already).
void yk_load_two_bodies(YkLoader *loader, const YkNode *list, const YkSubject *subject, int32_t body[2]);
// Returns the list of two values under a required key; NULL with the mistake reported.
const YkNode *yk_load_two_values(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject);
// Reads a key that is `true` or `false`; returns false if it is left out.
bool yk_load_yes_or_no(YkLoader *loader, const YkNode *map, const char *key, const YkSubject *subject);
// Returns the body that carries wheels, as `carrier:` names it; YK_NONE if it is left out, YK_REPORTED if it is wrong.
int32_t yk_load_carrier(YkLoader *loader, const YkNode *map);
// Finds the body that holds the axes of both wheels. Pins and welds that coincide on a body turn about one axis.
// `carrier` is the file's, or YK_NONE to infer it. Returns it, or YK_NONE with the reason reported; *distance is that
// of the two axes on it, m, and `center` (may be NULL) where they lie on it. Cost O(joints).
typedef struct YkWheelPair {
    const char *noun, *name; // "gears", the entry's name
    YkPlace place;
    int32_t body[2], carrier;
} YkWheelPair;
int32_t yk_load_find_carrier(YkLoader *loader, const YkWheelPair *pair, double *distance, YkVec center[2]);

// placeless_problems.c: passes on the problems of a value that has no place in the file; each message begins with the
// value and, unless NULL, the name of what it sets.
void yk_load_pass_on(YkProblems *problems, const YkProblems *found, const char *value, const char *name);

// Evaluates an expression at time t with the values of the model. Reports a fault unless it comes from a parameter
// without a value (reported already). Returns false if there is no value.
bool yk_load_eval(const YkModel *model, const YkExpr *expr, double t, YkJet *jet, YkProblems *problems);
// Evaluates an expression of one variable, which has the value x, with derivatives by it; returns as yk_expr_eval.
const YkExpr *yk_load_eval_of(const YkModel *model, const YkExpr *expr, const char *variable, double x, YkJet *jet,
                              const char **why);

#endif
