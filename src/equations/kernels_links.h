// Open trees of pins, slides and pin-slots over lanes: each lane is a state of the same machine. The recursion is that
// of tree_joints.c, for a few lanes at a time.
#ifndef EQUATIONS_KERNELS_LINKS_H
#define EQUATIONS_KERNELS_LINKS_H
#include "equations/kernels_tree.h"
#include "equations/tree_links.h"

// Results for a link; the ground's rows are set once, by yk_link_lanes_start.
typedef struct YkLinkFound {
    YkFew c, s, w;                      // absolute
    YkFew shift_x, shift_y;             // the link's point, in its own axes
    YkFew arm_x, arm_y, line_x, line_y; // from the parent's point; the line's direction: world axes
    YkFew bias_x, bias_y;               // of its point's acceleration
    YkInertiaFew inertia, noise;        // articulated
    YkFew f_x, f_y, n;
    YkFew turn_by, turn_x, turn_y; // the answers of its freedoms
    YkFew slide_by, slide_turn, slide_x, slide_y;
    YkFew a_x, a_y, alpha; // accelerations: of its point, of its turning
} YkLinkFound;

// The effort along an input besides the lanes' own: constant - stiffness q - damping v.
typedef struct YkLinkLoad {
    double constant, stiffness, damping;
} YkLinkLoad;

// The motion of a few states. All rows are [input], beginning with the lane 0.
typedef struct YkLinkBlock {
    YkFew *q, *v, *effort;           // given; q and v at the end of the step
    YkFew *at_q, *at_v, *a, *torque; // where the rates are sought, and what is found there
    YkFew *sum_q, *sum_v;
    YkFew ok; // 1, or 0 if a freedom has no inertia or a number is not finite
} YkLinkBlock;

typedef struct YkLinkLanes {
    const YkTreeLinks *links;
    const YkLinkLoad *load; // [input]
    size_t input_count;
    YkLinkFound *found; // [link]
    YkLinkBlock block;
} YkLinkLanes;

// Sets the rows of the ground, which accelerates against gravity so that gravity acts on every mass.
void yk_link_lanes_start(YkLinkLanes *lanes, YkVec gravity);
// Makes one step of length h by the classical Runge-Kutta method, for the first n lanes of the block. A lane whose ok
// is 0 on return has no state at its end.
void yk_lanes_links_step(YkLinkLanes *lanes, double h, size_t n);

#endif
