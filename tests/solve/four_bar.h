// Four-bars by closed form: an oracle of its own, independent of the library.
#ifndef TESTS_SOLVE_FOUR_BAR_H
#define TESTS_SOLVE_FOUR_BAR_H
#include "machine.h"

// Crank a on O2 = (0, 0), coupler b, rocker c on O4 = (d, 0).
typedef struct FourBar {
    double a, b, c, d;
} FourBar;

// Directions of coupler and rocker in the world, rad.
typedef struct FourBarPose {
    double coupler, rocker;
    bool closes;
} FourBarPose;

// Where the circles about A and O4 meet; branch = sign of cross(AB, O4B), which is - of the block's determinant
// order's.
static inline FourBarPose four_bar_pose(FourBar f, double theta, int branch)
{
    double ax = f.a * cos(theta), ay = f.a * sin(theta), dx = f.d - ax, dy = -ay, l2 = dx * dx + dy * dy, l = sqrt(l2);
    double along = (l2 + f.b * f.b - f.c * f.c) / (2 * l), off2 = f.b * f.b - along * along, off = sqrt(fmax(off2, 0));
    double bx = ax + (along * dx + branch * off * dy) / l, by = ay + (along * dy - branch * off * dx) / l;
    return (FourBarPose){atan2(by - ay, bx - ax), atan2(by, bx - f.d), off2 >= 0};
}

static inline double link_length_sum(FourBar f)
{
    return f.a + f.b + f.c + f.d;
}

// Grashof's s + l - p - q over the sum of lengths: negative where a link turns through.
static inline double grashof_excess(FourBar f)
{
    double shortest = fmin(fmin(f.a, f.b), fmin(f.c, f.d)), longest = fmax(fmax(f.a, f.b), fmax(f.c, f.d));
    return (2 * (shortest + longest) - link_length_sum(f)) / link_length_sum(f);
}

// Whether the crank turns through: Grashof, and the shortest link is the crank (crank-rocker) or the frame (drag link).
static inline bool crank_turns(FourBar f)
{
    double shortest = fmin(fmin(f.a, f.b), fmin(f.c, f.d));
    return grashof_excess(f) < 0 && (f.a <= shortest || f.d <= shortest);
}

// Assembled at crank angle theta on the given branch: the guesses are that branch's own angles.
static inline Machine four_bar_machine(FourBar f, double theta, int branch)
{
    char text[1024];
    FourBarPose p = four_bar_pose(f, theta, branch);
    snprintf(text, sizeof text,
             "bodies:\n"
             "  ground: {points: {O2: [0, 0], O4: [%.17g, 0]}}\n"
             "  crank: {points: {O2: [0, 0], A: [%.17g, 0]}}\n"
             "  coupler: {points: {A: [0, 0], B: [%.17g, 0]}}\n"
             "  rocker: {points: {O4: [0, 0], B: [%.17g, 0]}}\n"
             "joints:\n"
             "  O2: {pin: [ground, crank], angle: theta2}\n"
             "  A: {pin: [crank, coupler], angle: gamma}\n"
             "  O4: {pin: [ground, rocker], angle: theta4}\n"
             "  B: {pin: [coupler, rocker]}\n"
             "drives: {theta2: %.17g}\n"
             "start: {gamma: %.17g, theta4: %.17g}\n",
             f.d, f.a, f.b, f.c, theta, p.coupler - theta, p.rocker);
    return machine_parse(text, true);
}

#endif
