// Shared by the files of --check.
#ifndef PROVE_CHECK_INSIDE_H
#define PROVE_CHECK_INSIDE_H
#include "prove/check.h"
#include <yoke/variant.h>
#include "prove/loop_point.h"

enum {
    YK_CHECK_POINTS = 4,
    YK_CHECK_POINTS_OF_ROOTS = 8, // roots have a random sign at each: nothing that depends on it may pass
    YK_CHECK_POINTS_TRIED = 20 * YK_CHECK_POINTS_OF_ROOTS,
    YK_CHECK_POSES = 24,       // of this machine
    YK_CHECK_TRIES_A_POSE = 4, // some cannot be reached, and at some an equation has no value
    YK_CHECK_MACHINES = 3,     // with other dimensions
    YK_CHECK_MACHINES_TRIED = YK_CHECK_MACHINES + 4,
    YK_CHECK_MACHINE_POSES = 8, // of each of them
    YK_CHECK_POSES_MIN = 8,     // the least that a verdict needs
    YK_CHECK_SEGMENTS = 4,
    YK_CHECK_SEEN_MAX = YK_CHECK_POSES + 2 * YK_CHECK_MACHINES * YK_CHECK_MACHINE_POSES
};

// Positions and rates of the tree's coordinates, at poses of this machine and of others like it.
typedef struct YkCheckSeen {
    double *motion; // [count] rows of tree_count positions and tree_count rates
    size_t count;
} YkCheckSeen;

// A pose of the numeric engine.
typedef struct YkCheckPose {
    YkState *state;
    double *values;    // of all symbols there,
    double *elsewhere; // and with coordinates that are *not* on the machine
    size_t symbols;    // number of these
    uint64_t seed;     // the numbers drawn for `elsewhere` begin here,
    uint64_t behind;   // and ends here
} YkCheckPose;

// Poses of a machine, each made on demand: the start, then random ones.
typedef struct YkCheckPoses {
    YkCheckPose *pose[YK_CHECK_POSES * YK_CHECK_TRIES_A_POSE];
    size_t count, tried;
    uint64_t seed;
    double start_margin;
    YkState *work;
    YkMotion *target;   // [inputs]
    bool is_of_segment; // in the segments that one equation is about
} YkCheckPoses;

typedef enum YkCheckGround { // where a proof can be based
    YK_GROUND_UNTRIED,
    YK_GROUND_FIRM, // the points of the field are this machine's
    YK_GROUND_NONE
} YkCheckGround;

// Points of the machine's motion over the field, made on demand; made anew when there are new symbols.
typedef struct YkCheckPoints {
    YkFieldPoint *point[YK_CHECK_POINTS_TRIED];
    size_t count, tried, symbols;
    size_t open; // attempts in which the loops did not close
    YkCheckGround ground;
    bool is_exhausted;        // no ground, but only since no point tried had roots
    const YkLoopBonds *bonds; // NULL: none
} YkCheckPoints;

// Shared by the equations of one derivation as long as they start at one state; the derivation owns it
// (check_shared.c).
typedef struct YkCheckShared {
    YkState *start;
    const YkDynamics *dynamics;
    bool *is_prescribed; // [inputs], of the dynamics
    YkCheckPoses poses;
    YkFieldPoints *anywhere;          // points of the field, off the machine
    YkCheckPoints points, bound;      // of the machine: without bonds, and with the latest ones found
    struct YkCheckVariants *variants; // check_variants.c; NULL: not made yet
} YkCheckShared;

typedef struct YkCheck {
    YkDerivation *d;
    YkState *state;
    const YkState *start;
    YkDynamics *dynamics;
    YkEquation equation;
    const YkForm *difference; // left - right
    const char *text;
    size_t length;
    double *values, *elsewhere; // [value_count]: of all symbols, with room for a few more
    size_t value_count;
    uint64_t seed;
    const YkPoisson *within[YK_CHECK_SEGMENTS]; // must lie in 0 to 1 for the equation to hold
    size_t within_count;
    bool has_time; // the equation contains t
    bool failed;   // out of memory
    YkCheckSeen *seen;
    YkCheckShared *shared; // NULL: of a machine with other dimensions
    YkCheckPoses *poses;   // shared ones, or its own
    YkCheckPoses own_poses;
    YkCheckPoints *points;
} YkCheck;

// --- check_shared.c
// Returns what equations from this state on share: known already, or new. Returns NULL when out of memory.
YkCheckShared *yk_check_share(YkDerivation *d, const YkState *state, const YkDynamics *dynamics);

// --- check_open.c
// Reads the equation; d, state, text and length are set. Close it in any case.
typedef enum YkCheckOpened { YK_CHECK_OPEN, YK_CHECK_NOT_READ, YK_CHECK_NO_ROOM } YkCheckOpened;
// poses: shared ones, for an equation without segments.
YkCheckOpened yk_check_open(YkCheck *check, YkCheckPoses *poses, YkPlace place, YkProblems *problems);
void yk_check_close(YkCheck *check);

// --- check_proof.c: over the prime field
typedef enum YkProof { YK_PROVED, YK_REFUTED, YK_NO_PROOF } YkProof;
YkProof yk_check_prove(YkCheck *check, const YkForm *zero); // is it 0 on the machine, for all dimensions?
void yk_check_free_points(YkCheckPoints *points);
// From now on uses points of this assembly.
void yk_check_bind(YkCheck *check, const YkLoopBonds *bonds);

// --- check_poses.c: with the file's numbers
// Returns the pose with that index, of at most `most`; NULL after the last one. Its values are those of all
// present symbols.
const YkCheckPose *yk_check_pose(YkCheck *check, YkCheckPoses *poses, size_t index, size_t most);
void yk_check_free_poses(YkCheckPoses *poses);
bool yk_check_solve(YkCheck *check);       // the state, at its inputs, with forces
void yk_check_fill_values(YkCheck *check); // of the state
// Computes the same values with coordinates that are not on the machine.
void yk_check_disturb(YkCheck *check, double *values);
double yk_check_uniform(YkCheck *check, double low, double high);
// Returns whether the values lie in the segment that the equation is about.
bool yk_check_is_within(const YkCheck *check, const double *values);
// Copies its values to those of the check. Returns false when out of memory.
bool yk_check_take_values(YkCheck *check, const YkCheckPose *pose);

// --- check_compare.c
// Compares both sides at the start, then at random poses, `most` of them. Stops at a pose that shows a difference,
// with the state and the values there. poses: how many were compared.
bool yk_check_differs(YkCheck *check, size_t most, size_t *poses);
typedef enum YkCheckOutcome { YK_CHECK_SAME, YK_CHECK_DIFFERENT, YK_CHECK_NO_NUMBER } YkCheckOutcome;
YkCheckOutcome yk_check_judge(YkCheck *check); // both sides at the state's pose, whose values are left
// Returns whether this form is 0 at the poses of this machine.
bool yk_check_is_zero_at_poses(YkCheck *check, const YkForm *zero);

// --- check_exact.c: both sides with the file's numbers, if these alone decide
typedef enum YkCheckExact { YK_EXACT_EQUAL, YK_EXACT_DIFFERENT, YK_EXACT_UNKNOWN } YkCheckExact;
YkCheckExact yk_check_exactly(YkCheck *check);

// --- check_drives.c: as the drives move the machine, at random times
bool yk_check_has_drives(const YkCheck *check);
// Compares both sides. Stops at a time that shows a difference, with the state there. times: how many were compared.
bool yk_check_differs_in_drive(YkCheck *check, size_t *times);

// --- check_variants.c: machines with other numbers
// Machines whose parameters differ a little from the file's, made on demand, for all equations.
typedef struct YkCheckMachine {
    double *target; // [count]: the parameters that vary
    uint64_t seed;  // of its poses
    YkVariant *variant;
    YkState *state, *here; // its start; where an equation is compared
    YkDerivation *d;
    YkDynamics *dynamics;
    YkCheckPoses poses;
    bool is_machine; // one that the symbols describe
} YkCheckMachine;
typedef struct YkCheckVariants {
    YkCheck *check;    // the present check
    const char **name; // parameters that vary: [count]
    double *own, *value;
    size_t count;
    bool is_started;
    YkCheckMachine machine[YK_CHECK_MACHINES_TRIED], other; // random ones in order; one for any use
    size_t machine_count;
    uint64_t seed;
    double reach;
} YkCheckVariants;
YkCheckVariants *yk_check_variants(YkCheck *check); // NULL: no parameter can vary, or out of memory
void yk_check_free_variants(YkCheckVariants *variants);
YkCheckMachine *yk_check_machine(YkCheckVariants *variants, size_t index); // the random one; NULL past the last
// Returns the machine with these parameters, [count].
YkCheckMachine *yk_check_machine_at(YkCheckVariants *variants, const double *target, uint64_t seed);
const char *yk_check_list_names(const YkCheckVariants *variants, YkArena *arena, bool varied); // NULL: none

// --- check_machines.c: with other numbers
// Compares both sides on machines whose parameters differ a little from the file's: verdict->machines,
// machine_poses, varied, counter.
void yk_check_machines(YkCheck *check, YkCheckVerdict *verdict);

// --- check_bonds.c
// Returns what binds the angles at all poses seen, in the derivation's arena; NULL if nothing does, or out of memory.
const YkLoopBonds *yk_check_find_bonds(YkCheck *check);

// --- check_show.c: a refutation, with the state and the values there
void yk_check_show(YkCheck *check, YkArena *arena, YkCheckShown *shown);

// --- check_slips.c
// Returns "with the other sign before `d3*cos(theta2)` it would be true": what the author of a false equation may have
// meant, if that is true for all dimensions, or can only be tested; otherwise NULL. In the derivation's arena.
const char *yk_check_slip(YkCheck *check);

#endif
