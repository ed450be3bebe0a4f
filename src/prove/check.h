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

// Decides whether "LEFT = RIGHT" is true, in the file's names (theta1', theta1.rate, lever.angle, tan and quotients
// allowed). The state must be assembled; its inputs and pose change, and a false equation leaves it at the pose that
// shows it. dynamics: for equations with forces; may be NULL.
YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems);

// --- equation.c
typedef struct YkEquationTerm { // a summand of a side: its sign and its place
    bool is_right, is_negative;
    size_t start, end;
    const YkForm *form; // without the sign
} YkEquationTerm;
enum { YK_EQUATION_TERMS_MAX = 64 };
typedef struct YkEquation {
    const YkForm *left, *right;
    YkEquationTerm terms[YK_EQUATION_TERMS_MAX]; // the first ones, up to a limit
    size_t term_count;
} YkEquation;
bool yk_equation_read(YkDerivation *d, const char *text, size_t length, YkPlace place, YkProblems *problems,
                      YkEquation *equation);

#endif
