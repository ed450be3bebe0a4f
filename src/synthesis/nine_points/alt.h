// Alt's problem: all four-bars whose coupler point passes nine given points, at any angles of the input.
//
// Isotropic coordinates: a vector of the plane is a pair of complex numbers, (z, z^) with z^ the conjugate of z for
// what is real. The coupler point begins at the origin and goes to (d_j, d^_j). A dyad has a fixed pivot at a and a
// moving pivot that begins at x; the coupler turns by t_j = e^(i angle). The moving pivot is then at d_j + x t_j, and
// its distance from the fixed one is that of the beginning:
//   u (t - 1) + v (1/t - 1) + w = 0,  u = d^ x - a^ x,  v = d x^ - a x^,  w = d (x^ - a^) + d^ (x - a) + d d^.
// Two dyads that share the coupler give two such equations for g = t - 1 and g^ = 1/t - 1; by Cramer's rule g = G/D and
// g^ = H/D, and g + g^ + g g^ = 0 leaves one equation in the eight unknowns of the two dyads for each point but the
// first:
//   D G + D H + G H = 0.
// Source: Wampler, Morgan & Sommese 1992, J. Mechanical Design 114; Alt 1923, Z. angew. Math. Mech. 3.
#ifndef SYNTHESIS_ALT_H
#define SYNTHESIS_ALT_H
#include <stdint.h>
#include "base/pace.h"
#include "num/complex.h"

enum {
    YK_ALT_SIZE = 8,       // unknowns and equations
    YK_ALT_PLACES = 16,    // d_1 .. d_8, d^_1 .. d^_8
    YK_ALT_POINTS = 9,     // with the first one
    YK_ALT_TRIPLES = 1442, // of cognates: the solutions of generic points up to the names of the dyads
    YK_ALT_NAMES = 6,      // solutions in a triple: of its three fixed pivots two are taken, in either order
    YK_ALT_ROUTES = 4      // from the stored start to the points, tried one after the other
};

// The unknowns of a dyad; the second dyad's follow the first's.
enum { YK_ALT_X, YK_ALT_A, YK_ALT_X_HAT, YK_ALT_A_HAT, YK_ALT_DYAD };

// alt_system.c: evaluates F[8]; its Jacobian J[8][8] by the unknowns; and its derivative by_rate[8] as the places
// change by rate[16]. J may be NULL, and so may rate with by_rate.
void yk_alt_evaluate(const YkVec *places, const YkVec *x, YkVec *F, YkVec *J, const YkVec *rate, YkVec *by_rate);
// alt_disc.c: evaluates F[8] with twice the precision. Large linkages nearly cancel in the equations.
void yk_alt_residual(const YkVec *places, const YkVec *x, YkVec *F);
// Finds t = e^(i angle) of the coupler at place j (0 to 7). Returns false if it is not determined.
bool yk_alt_turn(const YkVec *places, const YkVec *x, size_t j, YkVec *turn);

// alt_follow.c: a path from the places `from` along the straight line to the places `to`.
typedef struct YkAltPath {
    const YkVec *from, *to; // [16]
    bool is_fine;           // residuals of twice the precision, ten times as long: for what passes near infinity
    YkPace *pace;
} YkAltPath;
// Follows the solution x from the beginning to the end. Returns whether x is then a solution there. Cost: some 3 ms.
// Source: Sommese & Wampler 2005, ch. 2.
bool yk_alt_follow(const YkAltPath *path, YkVec *x);
// Improves x by Newton's method until it stands still. Returns the relative size of the last step, or infinity.
double yk_alt_polish(const YkVec *places, YkVec *x);

// alt_names.c: gives the same linkage other names: its dyads swapped, or its first fixed pivot and the third one of
// Roberts' triple. Together they make all six names. Source: Roberts 1875; Wampler, Morgan & Sommese 1992.
void yk_alt_swap(const YkVec *x, YkVec *swapped);
void yk_alt_cognate(const YkVec *x, YkVec *cognate);
// Gives x the name `name`: 0 to 2 pair the pivots a b, a c, b c; 3 to 5 the same the other way round.
void yk_alt_name(size_t name, const YkVec *x, YkVec *named);

// alt_start.c: finds start solution `index` of YK_ALT_TRIPLES, improved to rounding, and the places that all of them
// share. Returns false past the last one.
bool yk_alt_start(size_t index, YkVec *x);
const YkVec *yk_alt_start_places(void); // [16]

// Nine points as seen from the first, over their size.
typedef struct YkAltTask {
    YkVec places[YK_ALT_PLACES], origin;
    double size; // m
    uint64_t seed;
} YkAltTask;
// alt_paths.c: poses the problem. `seed` chooses the routes.
void yk_alt_pose(const YkVec *point, uint64_t seed, YkAltTask *task);

// The equations keep their form as all z and all z^ are multiplied by a number each: a route begins at the start
// solutions multiplied by numbers of modulus 1, so that every pair of numbers leads along other places to those of the
// task.
typedef struct YkAltRoute {
    YkVec z, hat;
    YkVec from[YK_ALT_PLACES];
} YkAltRoute;
// Lays route `number` of a task, 0 to YK_ALT_ROUTES - 1.
void yk_alt_lay(const YkAltTask *task, size_t number, YkAltRoute *route);
// Follows path `piece` of YK_ALT_ROUTES * YK_ALT_TRIPLES: start solution piece % YK_ALT_TRIPLES along one of the
// routes. If it comes too close to infinity, its other names are tried, which may stay away from it. Returns whether it
// arrived.
bool yk_alt_path(const YkAltTask *task, size_t piece, YkPace *pace, YkVec *x);

#endif
