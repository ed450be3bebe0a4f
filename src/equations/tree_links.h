// The links of an open tree: bodies welded together are one rigid link; every other link is attached to the one before
// it by one joint. All constants are computed here.
//
// Axes of a link: at its joint's point, and turned so that the link's absolute angle is its parent's plus or minus the
// joint's coordinate, without a constant; a link that slides has its parent's angle. The joint's point is that of the
// first body of the link: `at` of a pin; `to` of a slide or pin-slot, or `from` if the line belongs to the link.
#ifndef EQUATIONS_TREE_LINKS_H
#define EQUATIONS_TREE_LINKS_H
#include "compile/mechanism.h"

typedef struct YkTreeLink {
    int32_t parent;          // a link before it; link 0 is the ground
    int32_t angle, distance; // inputs, or YK_NONE
    double sense;            // of the angle: +1, -1 if the joint's first body is in this link; 0 without an angle
    bool line_is_own;        // the line is fixed in this link; otherwise in the parent
    YkVec at;                // the joint's point on the parent at distance 0
    YkVec line; // direction in which the joint's point moves relative to the parent as the distance grows (a reversed
                // joint: against the line in the file); in the axes of the link that has the line
    double mass, inertia; // kg; kg m^2 about the centre of mass
    YkVec center;         // if it has mass
} YkTreeLink;

typedef struct YkTreeLinks {
    YkTreeLink *link; // in preorder: a link's first child comes right after it
    size_t count;     // including the ground
    bool has_slides;  // a joint with a distance
} YkTreeLinks;

// Builds the links of a mechanism without loops whose coordinates are all inputs. Returns false when out of memory.
// Cost O(bodies).
bool yk_tree_links_build(YkTreeLinks *links, const YkMechanism *mech, YkArena *arena);

#endif
