// Open trees of pins over lanes: one lane a state, with a machine of its own. The recursion of tree_pins.c, a link at a
// time over all lanes. Featherstone 1983.
#ifndef DYNAMICS_KERNELS_TREE_H
#define DYNAMICS_KERNELS_TREE_H
#include <stdbool.h>
#include <stddef.h>

// Rows of a link, each a row of lanes. What is given: its pin on the parent from the parent's own pin, the centre of
// mass from its own pin, mass, inertia about the centre of mass. Then what is found.
enum {
    YK_ROW_AT_X,
    YK_ROW_AT_Y,
    YK_ROW_CENTER_X,
    YK_ROW_CENTER_Y,
    YK_ROW_MASS,
    YK_ROW_INERTIA,
    YK_ROW_GIVEN, // how many are given
    YK_ROW_ANGLE = YK_ROW_GIVEN,
    YK_ROW_C,
    YK_ROW_S,
    YK_ROW_W,
    YK_ROW_MASS_OUT, // of all links from here outward
    YK_ROW_J,        // what the subtree shows at the parent's pin; before: the sum over the children at this link's
    YK_ROW_H_X,
    YK_ROW_H_Y,
    YK_ROW_XX,
    YK_ROW_XY,
    YK_ROW_YY,
    YK_ROW_F_X,
    YK_ROW_F_Y,
    YK_ROW_N,
    YK_ROW_LEAST, // inertia that stands behind the pin from the children
    YK_ROW_BY,
    YK_ROW_TURN,
    YK_ROW_ON_X,
    YK_ROW_ON_Y,
    YK_ROW_BIAS_X,
    YK_ROW_BIAS_Y,
    YK_ROW_ACROSS_X,
    YK_ROW_ACROSS_Y,
    YK_ROW_COUNT
};

// Absolute angle and rate: the parent's (NULL: the ground's) plus sense times the coordinate; then cos and sin.
void yk_lanes_tree_angle(double *const *link, double *const *parent, const double *q, const double *v, double sense,
                         size_t n);
// Lets the link's pin go under a torque (NULL: none) and shows the rest to the parent (NULL: the ground), which stores
// it (is_first) or adds it to its other children's. has_children: their sum stands in the link's rows. ok[lane] becomes
// 0 where no inertia resists.
void yk_lanes_tree_inward(double *const *link, double *const *parent, bool has_children, bool is_first,
                          const double *torque, double sense, double *ok, size_t n);
// The acceleration of the coordinate, given that of the parent's pin and turning (parent NULL: gx, gy is gravity); the
// link's own goes into YK_ROW_F_X, F_Y and N.
void yk_lanes_tree_outward(double *const *link, double *const *parent, const double *gx, const double *gy, double sense,
                           double *a, size_t n);
// ok[lane] = -1 where a value is beyond all measure, or none.
void yk_lanes_tree_fits(const double *value, double *ok, size_t n);
// ok[lane] = -1 where a mass is not positive or an inertia negative; has_mass: the file gives one.
void yk_lanes_tree_check(double *const *link, bool has_mass, double *ok, size_t n);
// a = 0 where not ok or not finite; the latter makes ok 0.
void yk_lanes_tree_mask(double *a, double *ok, size_t n);

#endif
