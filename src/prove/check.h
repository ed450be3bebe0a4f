// Is an equation true of this machine? Several methods support each other:
// - as an identity: both sides are the same element of the ring, whatever the coordinates are;
// - with the file's numbers: both sides are equal at many random poses of the numeric engine;
// - on the loops, for all dimensions: both sides are equal at random points of the machine's own motion over the prime
//   field p = 2^64 - 2^32 + 1 (loop_point.c), on the assembly on which the machine is (loop_assembly.c). A false
//   equation passes one point by chance with probability about degree / p;
// - with other numbers, if that is not a proof: at poses of machines with parameters near the file's.
// Inputs take any motion, whatever drives them; only what a lock holds stands still, in the field as in the engine.
#ifndef PROVE_CHECK_H
#define PROVE_CHECK_H
#include "base/problems.h"
#include "derive/derive.h"
#include "ring/proof/form.h"

typedef enum YkCheckKind {
    YK_CHECK_TRUE,        // for all dimensions
    YK_CHECK_TRUE_HERE,   // with this file's numbers; the verdict says what is known about others
    YK_CHECK_TRUE_DRIVEN, // as the drives move the machine; not when inputs move in any other way
    YK_CHECK_FALSE,
    YK_CHECK_UNDECIDED, // no pose could be found, or the numbers are inconclusive
    YK_CHECK_UNREADABLE // a problem says why
} YkCheckKind;

// Both sides at a pose where they differ.
typedef struct YkCheckShown {
    double left, right;
    int order;          // of the highest derivative of a coordinate in the equation
    const char *forces; // "F12x = 3.25, M03 = -0.5", its unknown forces there, SI; or NULL
    double time;
    bool has_time;             // the equation contains the time
    const char *machine;       // "a = 0.053, b = 0.21", SI: parameters that differ from the file's; NULL: none
    const YkMotion *positions; // [coordinates of the tree]
} YkCheckShown;

typedef struct YkCheckVerdict {
    YkCheckKind kind;
    bool is_identity;     // true: even if the loops were open
    bool is_in_segment;   // the poses are in the segment of a motion program that the equation is about
    size_t poses;         // number of poses of the numeric engine at which both sides were compared
    size_t machines;      // true here: number of machines with other dimensions at which it was compared too
    size_t machine_poses; // number of their poses in all
    const char *varied;   // their parameters that differ from the file's: "a, b"; NULL: none were tried
    const char *kept;     // parameters that could not vary; NULL: none
    bool is_too_large;    // true here: neither a proof nor other machines were tried
    bool is_false_there;  // only true here: `shown` is a machine with other dimensions
    bool is_refuted;      // only true here: by exact arithmetic it does not hold in general for other numbers
    YkCheckShown shown;   // false, or false elsewhere
    const char *slip;     // false: "with the other sign before `d3*cos(theta2)` it would be true"; or NULL
} YkCheckVerdict;

// Decides whether "LEFT = RIGHT" is true, in the file's names (theta1', theta1.rate, lever.angle, tan and quotients
// allowed). The state must be assembled; its inputs and pose change, and a false equation leaves it at the pose that
// shows it. dynamics: for equations with forces; may be NULL.
YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems);

// Frees what checks have found out about the machine and keep for others; yk_derivation_free calls it.
void yk_check_forget(YkDerivation *d);

// --- equation.c
typedef struct YkEquationTerm { // a summand of a side: its sign and its place
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

// --- loop_point.c
// Makes a random point of the machine's motion, dimensions included, over the prime field. Returns NULL if none could
// be made (*is_possible false) or when out of memory. loop_assembly.c tells whether it is of the machine's own
// assembly. Free it with yk_field_point_free.
// loop_assembly.c. Free it with yk_field_point_free.
YkFieldPoint *yk_derive_loop_point(YkDerivation *d, uint64_t seed, bool *is_possible);

#endif
