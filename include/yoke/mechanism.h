// The mechanism: the compiled machine - its graph, its loops, its freedom, and the order in which it is solved.
// A mechanism is constant once compiled and may be shared between threads.
#ifndef YOKE_MECHANISM_H
#define YOKE_MECHANISM_H

#include <yoke/model.h>
#include <yoke/progress.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkMechanism YkMechanism;

typedef struct YkCompileOptions {
    // Coordinates that the caller sets (`--at`, the coordinate of a sweep), by name; they precede the file's drives.
    const char *const *inputs;
    size_t input_count;
    YkProgress progress; // watches the compilation; {NULL}: not watched
    // One flag a cam of the model: whether its follower is off it, which then moves as if the cam were not there.
    // NULL: all are in contact.
    const bool *open_cams;
} YkCompileOptions;

YK_API YkCompileOptions yk_default_compile_options(void);

// Compiles a model. The inputs are taken, until the freedom is used up, from options->inputs, the drives, the
// coordinates of `start:` in their order, then any others. The model must outlive the mechanism. Returns NULL with
// problems added (over-driven machine, input that closes a loop, ...).
// Cost: linear in the number of joints for machines made of dyads.
YK_API YkMechanism *yk_mechanism_compile(const YkModel *model, const YkCompileOptions *options, YkProblems *problems);
YK_API void yk_mechanism_free(YkMechanism *mech);
YK_API const YkModel *yk_mechanism_model(const YkMechanism *mech);

// Coordinates of the spanning tree, in the order of the file's joints. Unnamed ones are called `joint.angle` and
// `joint.distance`. A driven or held coordinate is an input.
typedef struct YkCoordinateInfo {
    const char *name;
    size_t joint;
    bool is_distance; // in metres; otherwise in radians
    bool is_declared; // the file names it
    bool has_drive;   // an expression of time drives it
    bool is_held;     // a lock holds it: its drive stands still
    bool has_start;   // `start:` gives it a value
    int input;        // its index among the inputs, or -1
} YkCoordinateInfo;
YK_API size_t yk_coordinate_count(const YkMechanism *mech);
YK_API YkCoordinateInfo yk_coordinate_info(const YkMechanism *mech, size_t coordinate);
YK_API size_t yk_coordinate_find(const YkMechanism *mech, const char *name); // YK_NOT_FOUND if there is none
YK_API size_t yk_input_count(const YkMechanism *mech);
YK_API size_t yk_input_coordinate(const YkMechanism *mech, size_t input); // the coordinate that is input i

// Freedom, computed in two ways: by Gruebler's count 3 (bodies - 1) - sum of constraints, and by the rank of the loop
// equations.
typedef struct YkFreedom {
    int gruebler;
    int by_rank;      // -1 if the machine could not be assembled for it
    size_t redundant; // constraints that repeat others = by_rank - gruebler
    size_t driven;    // coordinates with a drive
} YkFreedom;
YK_API YkFreedom yk_mechanism_freedom(const YkMechanism *mech);

// Loops of the spanning tree, each with the joint that closes it.
YK_API size_t yk_loop_count(const YkMechanism *mech);
YK_API size_t yk_loop_joint(const YkMechanism *mech, size_t loop);
YK_API size_t yk_loop_bodies(const YkMechanism *mech, size_t loop, size_t *bodies,
                             size_t capacity); // in order round the loop

// Blocks: sets of unknowns that are solved together, in the order of solution.
typedef enum YkBlockKind {
    YK_BLOCK_RRR,   // dyad with two unknown angles: two circles intersect
    YK_BLOCK_RRP,   // dyad with an unknown angle and a distance along a known line: a circle intersects a line
    YK_BLOCK_RPR,   // dyad with an unknown angle and a distance along the line that turns with it
    YK_BLOCK_PP,    // dyad with two unknown distances (RPP, PRP, PPR): two lines intersect
    YK_BLOCK_LINK,  // one unknown, two equations: repeats constraints
    YK_BLOCK_CHECK, // no unknown: a redundant loop, only checked
    YK_BLOCK_GROUP  // a larger Assur group, solved by Newton's method
} YkBlockKind;
typedef struct YkBlockInfo {
    YkBlockKind kind;
    const char *label; // name of the joint that labels its branch ("A"), unique among blocks
    int assur_class;   // 2 for dyads, 3 and more for groups, 0 for LINK and CHECK
    size_t unknowns, equations;
    size_t joint_count;    // joints of the group, see yk_block_joint
    size_t body_count;     // bodies that the block places
    size_t relation_count; // gears, racks, belts, cams and laws solved together with its loops, see yk_block_relation
} YkBlockInfo;
YK_API size_t yk_block_count(const YkMechanism *mech);
YK_API YkBlockInfo yk_block_info(const YkMechanism *mech, size_t block);
YK_API size_t yk_block_joint(const YkMechanism *mech, size_t block, size_t index);
YK_API size_t yk_block_body(const YkMechanism *mech, size_t block, size_t index);
YK_API const char *yk_block_relation(const YkMechanism *mech, size_t block, size_t index); // its name
YK_API const char *yk_block_kind_name(YkBlockKind kind);
// Redundant constraints: the joint whose loop adds only constraints that others already imply.
YK_API size_t yk_redundant_count(const YkMechanism *mech);
YK_API size_t yk_redundant_joint(const YkMechanism *mech, size_t index);

// Returns the length by which lengths are scaled, m: the largest length in the machine.
YK_API double yk_mechanism_size(const YkMechanism *mech);

// A channel: one number of a pose. Its names, as `--of` takes them:
//   theta2, theta2.rate, theta2.accel      a coordinate (any joint: JOINT.angle, JOINT.distance)
//   lever.angle, lever.angle.rate, .accel  a body's angle to the ground (lever.rate, lever.accel for short)
//   ram.C.x, ram.C.y, ram.C.x.rate, .accel a point; also ram.C.speed
//   C.transmission                         the transmission angle of the block labelled C, rad in [0, pi/2]
//   A.force.x, A.force.y, A.force, A.moment  a joint's reaction on its second body by its first (A.force: its size)
//   G.force.x, ...                         the same for gears, racks, belts and cams, by their names
//   theta1.effort                          effort along a coordinate, from its drive or from the file; not a number
//                                          where dry friction at rest lets every effort of an interval hold the machine
//   theta1.effort.from, theta1.effort.to   the ends of that interval; otherwise the effort itself
//   energy, kinetic, potential             J
//   shaking.x, shaking.y, shaking.moment   what the machine exerts on its frame, about the world's origin
typedef enum YkChannelKind {
    YK_CHANNEL_TIME,
    YK_CHANNEL_COORDINATE,
    YK_CHANNEL_JOINT_ANGLE,
    YK_CHANNEL_JOINT_DISTANCE,
    YK_CHANNEL_BODY,
    YK_CHANNEL_POINT_X,
    YK_CHANNEL_POINT_Y,
    YK_CHANNEL_POINT_SPEED,
    YK_CHANNEL_TRANSMISSION,
    // forces from here on: only yk_dynamics_channel answers them
    YK_CHANNEL_FORCE_X,
    YK_CHANNEL_FORCE_Y,
    YK_CHANNEL_FORCE,
    YK_CHANNEL_MOMENT,
    YK_CHANNEL_EFFORT,
    YK_CHANNEL_ENERGY,
    YK_CHANNEL_KINETIC,
    YK_CHANNEL_POTENTIAL,
    YK_CHANNEL_SHAKING_X,
    YK_CHANNEL_SHAKING_Y,
    YK_CHANNEL_SHAKING_MOMENT,
    YK_CHANNEL_EFFORT_FROM,
    YK_CHANNEL_EFFORT_TO
} YkChannelKind;
typedef struct YkChannel {
    YkChannelKind kind;
    int index;           // of the coordinate, joint, body, point or block; of contacts after all joints
    int order;           // 0 value, 1 rate, 2 acceleration
    YkQuantity quantity; // for its unit
} YkChannel;
// Returns whether only yk_dynamics_channel can answer it.
static inline bool yk_channel_needs_forces(YkChannel channel)
{
    return channel.kind >= YK_CHANNEL_FORCE_X;
}
// Reads the name of a channel. Returns YK_OK, or YK_BAD_ARGUMENT with a problem (and a suggestion) added.
YK_API YkStatus yk_channel_parse(const YkMechanism *mech, const char *name, YkChannel *channel, YkProblems *problems);
// Writes its name as `--of` takes it, at most capacity bytes with a final NUL. Returns the length needed.
YK_API size_t yk_channel_name(const YkMechanism *mech, YkChannel channel, char *text, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
