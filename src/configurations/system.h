// The polynomial system of a group at a pose.
//
// With z = e^(i Phi) for an unknown angle, every loop of a group is a sum of A_j z_j, of A_m d_m (a slide along a known
// line) or A_m d_m z_j (a slide along a line that turns with unknown j), and a constant; its conjugate has conj(A) and
// 1/z_j in place of A and z_j. Set free, the two coefficient arrays are independent complex numbers: the system is a
// member of a family in which paths can be followed. Lengths are over the machine's size.
// Source: Wampler 1999, "Solving the kinematics of planar mechanisms" (isotropic coordinates).
//
// With relations between the unknowns (gears, belts, racks) the system is one in real unknowns: Phi_j, rad, in place of
// z_j. Its rows are every loop in x and in y, then the relations sum p_j Phi_j + sum q_m d_m + C, modulo 2 pi where
// they count turns.
#ifndef CONFIGURATIONS_SYSTEM_H
#define CONFIGURATIONS_SYSTEM_H
#include <stdbool.h>
#include <stdint.h>
#include "base/vec.h"
#include "solve/run.h"

enum { YK_SYSTEM_LOOPS_MAX = 7 }; // beyond this a group has too many solutions to follow all

// The structure, which one topology keeps. Unknown k < angles is an angle, the others are slides.
typedef struct YkShape {
    size_t loops, angles, unknowns; // unknowns = 2 loops + relations
    size_t relations, whole; // of a system in real unknowns, see below: of them, those that hold modulo 2 pi, the first
    int turning[2 * YK_SYSTEM_LOOPS_MAX];   // of a slide: the angle whose line it follows, or -1; of an angle: -1
    size_t column[2 * YK_SYSTEM_LOOPS_MAX]; // of an unknown: the group's column
} YkShape;

// The coefficients of the loops, then of their conjugates: [2][loops][unknowns + 1], the constants last. In real
// unknowns those of the relations follow, [relations][unknowns + 1].

typedef enum YkOutside { // why a group is not such a system
    YK_OUTSIDE_NOT,
    YK_OUTSIDE_RELATIONS, // gears, cams and the like
    YK_OUTSIDE_REDUNDANT, // equations that repeat others
    YK_OUTSIDE_LARGE,
    YK_OUTSIDE_LINES // a distance along more than one line
} YkOutside;

// Reads the structure of block `index`, a group.
YkOutside yk_shape_read(YkShape *shape, const YkMechanism *mech, size_t index);
// Reads the columns of the block and the lines of its slides alone, whatever its relations are and however many
// equations it has. Returns false if there are too many, or a distance along more than one line.
bool yk_shape_read_columns(YkShape *shape, const YkMechanism *mech, size_t index);
// Reads the coefficients at the pose of `run`: [2][loops][unknowns + 1]. Earlier blocks must be solved.
void yk_coefficients_read(const YkShape *shape, const YkRun *run, size_t index, YkVec *coefficients);
static inline size_t yk_coefficient_count(const YkShape *shape) // of one of the two arrays
{
    return shape->loops * (shape->unknowns + 1);
}

// Returns the size that measures changes of an unknown: 1 for an angle, its own for z, or the machine's for a distance.
double yk_unknown_size(const YkShape *shape, const YkVec *x, size_t unknown);

// Evaluates F[unknowns] (loops, then conjugates) at x, and the Jacobian J[unknowns][unknowns] if it is not NULL.
// Cost 4 loops^2 multiplications.
void yk_system_evaluate(const YkShape *shape, const YkVec *coefficients, const YkVec *x, YkVec *F, YkVec *J);

#endif
