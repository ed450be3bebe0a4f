// A piece: one block of a machine, dyad or group, as a polynomial system whose coefficients are discs.
#ifndef MAP_PIECE_H
#define MAP_PIECE_H
#include "configurations/system.h"
#include "law/law.h"
#include "map/dual.h"

enum { YK_PIECE_UNKNOWNS = 2 * YK_SYSTEM_LOOPS_MAX, YK_PIECE_NUMBERS = YK_PIECE_UNKNOWNS * (YK_PIECE_UNKNOWNS + 1) };

typedef struct YkPiece {
    size_t block, step; // the step that solves it
    YkShape shape;
    struct YkMeshed *meshed; // of a system in real unknowns: its relations; otherwise NULL
    int32_t relation; // of a gear that takes a fraction of an angle that loops place, which is no block; or YK_NONE
} YkPiece;

// Bounds of a pose, or of all poses of an interval: [slot], [distance], [node].
typedef struct YkDiscs {
    const YkMechanism *mech;
    YkBall input;   // the mapped one, rad or m
    int32_t mapped; // its index among the inputs
    int32_t second; // another one that is mapped, or YK_NONE
    YkBall second_input;
    const double *others; // the values of all inputs: those of the others stay
    const double
        *ways; // or NULL; otherwise all inputs move, and `input` is the place on their way: others + input ways
    YkDual *slots, *distances, *nodes;
    YkLawBound *laws; // [relation]
} YkDiscs;

typedef struct YkDiscCoefficients { // [2][loops][unknowns + 1], the second half the conjugates of the first
    YkVec at[YK_PIECE_NUMBERS];
    double radius[YK_PIECE_NUMBERS];
    YkVec rate[YK_PIECE_NUMBERS]; // their derivatives
    double rate_radius[YK_PIECE_NUMBERS];
} YkDiscCoefficients;

typedef enum YkPieceStatus {
    YK_PIECE_READ,
    YK_PIECE_REPEATED,  // a dyad's loop, or one without unknowns, that repeats others
    YK_PIECE_REDUNDANT, // a group with equations that repeat others
    YK_PIECE_RELATIONS, // gears, cams and the like within a group
    YK_PIECE_LARGE,
    YK_PIECE_LINES
} YkPieceStatus;

bool yk_discs_start(YkDiscs *discs, const YkMechanism *mech); // returns false when out of memory
void yk_discs_end(YkDiscs *discs);

// Reads the structure of the block that a step solves.
YkPieceStatus yk_piece_read(YkPiece *piece, const YkMechanism *mech, size_t step);
// Returns whether a step other than a block's is one that discs can take: relations only if they turn nothing by a
// fraction of an angle that loops place, set no distance from such an angle, and if their law, if they have one,
// depends on inputs alone and has no jump.
bool yk_discs_can_take(const YkMechanism *mech, const YkStep *step);
// Takes a step that is not a block's, or that of a block that repeats others: its unknown, if it has one, is what it is
// where its loop closes.
void yk_discs_take(YkDiscs *discs, const YkStep *step);
// Returns by how much the loop of a block that repeats others misses, over the size (of a link: its square).
YkDual yk_discs_miss(const YkDiscs *discs, const YkBlock *block);
// Returns e^(i angle), where the angle is real; what inputs and laws of them are.
YkDual yk_dual_turn(YkDual angle);
YkDual yk_discs_input(const YkDiscs *discs, int32_t input);
YkDual yk_discs_law(const YkDiscs *discs, const YkRelation *relation);
YkDual yk_discs_sum(const YkDiscs *discs, const YkSum *sum);
// Computes the coefficients of a block at what is known.
void yk_piece_coefficients(const YkPiece *piece, const YkDiscs *discs, YkDiscCoefficients *out);
// Makes the unknowns of a block known: at[k], and their derivatives.
void yk_discs_place(YkDiscs *discs, const YkPiece *piece, const YkDual *x);
// Returns the size that measures changes of an unknown: of z its own, of a distance its own or the machine's.
double yk_piece_size(const YkPiece *piece, const YkVec *x, size_t unknown);
// Returns x - y of an unknown; whole turns do not count.
YkVec yk_piece_off(const YkPiece *piece, const YkVec *x, const YkVec *y, size_t unknown);

#endif
