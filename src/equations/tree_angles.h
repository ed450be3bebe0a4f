// Absolute angles of an open tree's links, from the joints' coordinates: outwards, in blocks.
#ifndef EQUATIONS_TREE_ANGLES_H
#define EQUATIONS_TREE_ANGLES_H
#include "equations/tree_links.h"

// How a link's angle follows from its parent's.
typedef struct YkLinkTurn {
    int32_t parent;
    int32_t input; // or YK_NONE: the parent's angle
    int32_t fork;  // its index among the links with a child that does not come right after them, or YK_NONE
    float sense;   // +1, -1, 0
} YkLinkTurn;

typedef struct YkTreeAngles {
    YkLinkTurn *turn; // [link]; 0 is the ground
    size_t count, fork_count;
    double *c, *s, *w;  // [link] cos and sin of the absolute angle; its rate
    double *fork_angle; // [fork]
} YkTreeAngles;

bool yk_tree_angles_start(YkTreeAngles *angles, const YkTreeLinks *links, YkArena *arena);
// Computes the angles from q[input], v[input], modulo a turn before they grow: no digits are lost along a chain that
// coils up.
void yk_tree_angles_find(const YkTreeAngles *angles, const double *q, const double *v);

#endif
