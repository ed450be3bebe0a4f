// What the files of --check share.
#ifndef DERIVE_CHECK_INSIDE_H
#define DERIVE_CHECK_INSIDE_H
#include "derive/check.h"
#include "derive/loop_point.h"

enum {
    YK_CHECK_POINTS = 4,
    YK_CHECK_POINTS_OF_ROOTS = 8, // roots have a random sign at each: what hangs on it must not pass
    YK_CHECK_POINTS_TRIED = 20 * YK_CHECK_POINTS_OF_ROOTS,
    YK_CHECK_POSES = 24,        // of this machine
    YK_CHECK_MACHINES = 3,      // with other dimensions
    YK_CHECK_MACHINE_POSES = 8, // of each of them
    YK_CHECK_POSES_MIN = 8,     // a verdict needs so many
    YK_CHECK_SEGMENTS = 4,
    YK_CHECK_SEEN_MAX = YK_CHECK_POSES + 2 * YK_CHECK_MACHINES * YK_CHECK_MACHINE_POSES
};

// Positions and rates of the tree's coordinates at poses of this machine and of others like it.
typedef struct YkCheckSeen {
    double *motion; // [count] rows of tree_count positions and tree_count rates
    size_t count;
} YkCheckSeen;

typedef enum YkCheckGround { // where a proof may stand
    YK_GROUND_UNTRIED,
    YK_GROUND_FIRM, // the points of the field are this machine's
    YK_GROUND_NONE
} YkCheckGround;

typedef struct YkCheck {
    YkDerivation *d;
    YkState *state, *start;
    double start_margin;
    YkDynamics *dynamics;
    YkEquation equation;
    const YkForm *difference; // left - right
    const char *text;
    size_t length;
    double *values; // [value_count]: of all symbols, and room for a few more
    size_t value_count;
    uint64_t seed;
    const YkPoisson *within[YK_CHECK_SEGMENTS]; // lie in 0 to 1 where the equation is to hold
    size_t within_count;
    bool has_time; // the equation speaks of t
    size_t kept_size[YK_CHECK_POSES];
    bool failed;                  // out of memory
    double *kept[YK_CHECK_POSES]; // values at poses that were compared
    size_t kept_count;
    YkCheckSeen *seen;
    YkFieldPoint *points[YK_CHECK_POINTS_TRIED]; // of the machine's motion, made at first use
    size_t point_count, points_tried, points_symbols;
    YkCheckGround ground;
    const YkLoopBonds *bonds; // of the points; NULL: none
} YkCheck;

// --- check.c: reads the equation; d, state, text and length are set. Close it in any case.
typedef enum YkCheckOpened { YK_CHECK_OPEN, YK_CHECK_NOT_READ, YK_CHECK_NO_ROOM } YkCheckOpened;
YkCheckOpened yk_check_open(YkCheck *check, YkPlace place, YkProblems *problems);
void yk_check_close(YkCheck *check);

// --- check_proof.c: over the prime field
typedef enum YkProof { YK_PROVED, YK_REFUTED, YK_NO_PROOF } YkProof;
YkProof yk_check_prove(YkCheck *check, const YkForm *zero); // is it 0 on the machine, for all dimensions?
void yk_check_free_points(YkCheck *check);
// From now on points of this assembly.
void yk_check_bind(YkCheck *check, const YkLoopBonds *bonds);

// --- check_poses.c: with the file's numbers
// Compares both sides at the start, then at random poses, `most` of them; stops at a pose that shows a difference, with
// the state there. poses: how many were compared.
bool yk_check_differs(YkCheck *check, size_t most, size_t *poses);
// --- check_exact.c: both sides with the file's numbers, where these alone decide
typedef enum YkCheckExact { YK_EXACT_EQUAL, YK_EXACT_DIFFERENT, YK_EXACT_UNKNOWN } YkCheckExact;
YkCheckExact yk_check_exactly(YkCheck *check);

// --- check_drives.c: as the drives move the machine, at random times
bool yk_check_has_drives(const YkCheck *check);
// Compares both sides; stops at a time that shows a difference, with the state there. times: how many were compared.
bool yk_check_differs_in_drive(YkCheck *check, size_t *times);
void yk_check_fill_values(YkCheck *check); // of the state
bool yk_check_solve(YkCheck *check);       // the state, at its inputs, with forces
typedef enum YkCheckOutcome { YK_CHECK_SAME, YK_CHECK_DIFFERENT, YK_CHECK_NO_NUMBER } YkCheckOutcome;
YkCheckOutcome yk_check_judge(YkCheck *check); // both sides at the state's pose; disturbs the values
double yk_check_uniform(YkCheck *check, double low, double high);
// The smallest transmission angle of the dyads: at 0 two configurations meet.
double yk_check_margin(const YkCheck *check);
// Is this form 0 at the poses that were kept?
bool yk_check_is_zero_at_poses(YkCheck *check, const YkForm *zero);
void yk_check_free_poses(YkCheck *check);

// --- check_machines.c: with other numbers
// Compares both sides on machines whose parameters are a little beside the file's: verdict->machines, machine_poses,
// varied, counter.
void yk_check_machines(YkCheck *check, YkCheckVerdict *verdict);

// --- check_bonds.c: what binds the angles at all poses that were seen; NULL where nothing does, or memory ran out. In
// the derivation's arena.
const YkLoopBonds *yk_check_find_bonds(YkCheck *check);

// --- check_show.c: what a refutation is shown with
void yk_check_show(YkCheck *check, YkArena *arena, YkCheckShown *shown);

// --- check_slips.c: "with the other sign before `d3*cos(theta2)` it would be true", or NULL: what the hand that wrote
// a false equation may have meant, where that is true for all dimensions, or can only be tried. In the derivation's
// arena.
const char *yk_check_slip(YkCheck *check);

#endif
