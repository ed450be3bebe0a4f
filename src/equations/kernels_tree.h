// Open trees of pins over lanes: each lane is a state with a machine of its own. The recursion of tree_pins.c runs over
// all links for a few lanes at a time: what one link passes to the next stays in the first-level cache. Featherstone
// 1983.
#ifndef EQUATIONS_KERNELS_TREE_H
#define EQUATIONS_KERNELS_TREE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "equations/tree_noise.h"

// The given values of a link, each a row of lanes: its pin on the parent relative to the parent's own pin, the centre
// of mass relative to its own pin, mass, inertia about the centre of mass.
enum {
    YK_GIVEN_AT_X,
    YK_GIVEN_AT_Y,
    YK_GIVEN_CENTER_X,
    YK_GIVEN_CENTER_Y,
    YK_GIVEN_MASS,
    YK_GIVEN_INERTIA,
    YK_GIVEN_COUNT
};
// The axis of their own along which all links' vectors lie, for chains; those across it are 0 then.
typedef enum YkAxis { YK_AXIS_NONE, YK_AXIS_X, YK_AXIS_Y } YkAxis;

// The results for a link, a few lanes at a time.
enum { YK_TREE_LANES = 32 };

typedef double YkFew[YK_TREE_LANES];

typedef struct YkInertiaFew { // of YkInertia
    YkFew J, h_x, h_y, xx, xy, yy;
} YkInertiaFew;

static inline YkInertia yk_inertia_read(const YkInertiaFew *rows, size_t i)
{
    return (YkInertia){rows->J[i], yk_vec(rows->h_x[i], rows->h_y[i]), rows->xx[i], rows->xy[i], rows->yy[i]};
}

static inline void yk_inertia_write(YkInertiaFew *rows, size_t i, YkInertia own)
{
    rows->J[i] = own.J, rows->h_x[i] = own.h.x, rows->h_y[i] = own.h.y;
    rows->xx[i] = own.xx, rows->xy[i] = own.xy, rows->yy[i] = own.yy;
}

typedef struct YkTreeFound {
    YkFew c, s, w;               // absolute
    YkInertiaFew inertia, noise; // of its children, about its pin: see tree_pins.c
    YkFew f_x, f_y, n;
    YkFew by, turn, on_x, on_y, bias_x, bias_y, across_x, across_y;
    YkFew pin_x, pin_y, alpha; // accelerations: of its pin, of its turning
} YkTreeFound;

typedef struct YkTreeRows { // of a link; links come after their parents
    const double *given[YK_GIVEN_COUNT];
    double sign[YK_GIVEN_MASS];   // +1 or -1, by which the rows of vectors are multiplied
    const double *q, *v, *torque; // of its coordinate
    double *a;                    // found: the coordinate's acceleration
    int32_t parent;               // link, or -1: the ground
    bool has_children, is_first;  // is_first: of its parent's children, the last in order, which is handled first
    bool has_mass;                // the file gives one
    double sense;                 // of the coordinate: +1 or -1
} YkTreeRows;

typedef struct YkTreeLanes {
    const YkTreeRows *link;
    YkTreeFound *found; // [link]
    size_t link_count;
    const double *gravity[2];
    const double *const *checked; // rows that must contain numbers of reasonable size
    size_t checked_count;
    YkAxis axis;
    double side; // of two links along an axis: the sign of their vectors, if it is one for all, all senses are +1 and
                 // gravity acts along y alone; otherwise 0
} YkTreeLanes;

// Computes the accelerations of n states. ok[lane] is 1 on entry, or -1 if something is wrong already. On return it is
// 1; 0 if no inertia resists; -1 if a checked row contains no number or one beyond all measure, a mass is not positive
// or an inertia is negative. Accelerations are 0 unless ok. *well: whether all are.
void yk_lanes_tree(bool *well, const YkTreeLanes *tree, double *ok, size_t n);

// Does the same for a short chain, in one pass.
void yk_lanes_chain(bool *well, const YkTreeLanes *tree, double *ok, size_t n);

// Computes row = sign * value, or adds that to row.
void yk_lanes_tree_part(double *row, const double *value, double sign, bool adds, size_t n);

#endif
