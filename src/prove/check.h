// Is an equation true of this machine? By ways that support each other:
// - as an identity: both sides are the same element of the ring, whatever the coordinates are;
// - with the file's numbers: both sides are equal at many random poses of the numeric engine;
// - on the loops, for all dimensions: both sides are equal at random points of the machine's own motion over the prime
//   field p = 2^64 - 2^32 + 1 (loop_point.c), on the assembly on which the machine is (loop_assembly.c). A false
//   equation passes one point by chance with probability about degree / p;
// - with other numbers, where that is no proof: at poses of machines with parameters beside the file's.
// Inputs take any motion, whatever drives them; only what a lock holds stands, in the field as in the engine.
#ifndef PROVE_CHECK_H
#define PROVE_CHECK_H
#include "base/problems.h"
#include "derive/derive.h"
#include "ring/proof/form.h"

typedef enum YkCheckKind {
    YK_CHECK_TRUE,        // for all dimensions
    YK_CHECK_TRUE_HERE,   // with this file's numbers; of other numbers the verdict tells what is known
    YK_CHECK_TRUE_DRIVEN, // as the drives move the machine; not where inputs move in any other way
    YK_CHECK_FALSE,
    YK_CHECK_UNDECIDED, // no pose could be found, or the numbers do not tell
    YK_CHECK_UNREADABLE // a problem says why
} YkCheckKind;

// Both sides at a pose at which they differ.
typedef struct YkCheckShown {
    double left, right;
    int order;          // of the highest derivative of a coordinate in the equation
    const char *forces; // "F12x = 3.25, M03 = -0.5", the unknown forces in it there, SI; or NULL
    double time;
    bool has_time;             // the equation speaks of it
    const char *machine;       // "a = 0.053, b = 0.21", SI: parameters that are not the file's; NULL: all are
    const YkMotion *positions; // [coordinates of the tree]
} YkCheckShown;

typedef struct YkCheckVerdict {
    YkCheckKind kind;
    bool is_identity;     // true: even if the loops were open
    bool is_in_segment;   // poses are those in the segment of a motion program of which the equation speaks
    size_t poses;         // of the numeric engine, at which both sides were compared
    size_t machines;      // true here: others, with other dimensions, at which it was compared, too,
    size_t machine_poses; // at so many poses in all
    const char *varied;   // their parameters that are not the file's: "a, b"; NULL: none were tried
    const char *kept;     // parameters that could not vary; NULL: none
    bool is_too_large;    // true here: a proof was not tried, nor other machines
    bool is_false_there;  // true here only: `shown` is a machine with other dimensions
    bool is_refuted;      // true here only: for other numbers it does not hold in general, by exact arithmetic
    YkCheckShown shown;   // false, or false elsewhere
    const char *slip;     // false: "with the other sign before `d3*cos(theta2)` it would be true"; or NULL
} YkCheckVerdict;

// Decides about "LEFT = RIGHT", in the file's names (theta1', theta1.rate, lever.angle, tan and quotients allowed). The
// state must be assembled; its inputs and pose change, and for a false equation it is left at the pose that shows it.
// dynamics: for equations with forces; may be NULL.
YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems);

// What checks have found out about the machine and keep for others; yk_derivation_free calls it.
void yk_check_forget(YkDerivation *d);

// --- equation.c
typedef struct YkEquationTerm { // a summand of a side: its sign, and where it stands
    bool is_right, is_negative;
    size_t start, end;
    const YkForm *form; // without the sign
} YkEquationTerm;
enum { YK_EQUATION_TERMS_MAX = 64 };
typedef struct YkEquation {
    const YkForm *left, *right;
    YkEquationTerm terms[YK_EQUATION_TERMS_MAX]; // the first so many
    size_t term_count;
} YkEquation;
bool yk_equation_read(YkDerivation *d, const char *text, size_t length, YkPlace place, YkProblems *problems,
                      YkEquation *equation);

// --- loop_point.c: a random point of the machine's motion, dimensions included, over the prime field; NULL if none
// could be made (*is_possible false) or memory ran out. Whether it is of the assembly on which the machine is:
// loop_assembly.c. Free it with yk_field_point_free.
YkFieldPoint *yk_derive_loop_point(YkDerivation *d, uint64_t seed, bool *is_possible);

#endif
