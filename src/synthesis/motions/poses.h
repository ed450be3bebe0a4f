// Dyads through positions: the links that can join a body, which is to take given positions, to the ground.
//
// A point z of the body and a point F of the ground belong to a dyad if their distance is the same at all positions
// (d, R): |d + R z - F|^2 = const. The difference of two such conditions is linear in the seven monomials
// (1, z_x, z_y, F_x, F_y, z . F, z x F), so that n positions give n - 1 rows of seven numbers. Points at infinity stand
// for slides. Source: Burmester 1888; the rows: Ge, Zhao & Purwar 2013, J. Mechanisms Robotics 5, 021003.
#ifndef SYNTHESIS_POSES_H
#define SYNTHESIS_POSES_H
#include <stdbool.h>
#include <stddef.h>
#include <yoke/synthesis.h>
#include "base/vec.h"

enum { YK_MONOMIALS = 7, YK_POSES_MAX = 5 };

// A position of the body: where its origin is, and how far it is turned, rad. With is_rate it is the limit of a second
// position beside this one, in the direction of a velocity (m/s) and a rate of turning (rad/s); only their ratio
// counts. Lists of positions may end with them.
typedef struct YkPose {
    YkVec at;
    double angle;
    bool is_rate;
    YkVec velocity;
    double rate;
} YkPose;

// The rows of some positions, in units of their spread about their middle, so that all entries are near 1.
typedef struct YkPoseRows {
    YkVec middle;
    double scale;
    size_t count; // of rows
    double row[YK_POSES_MAX - 1][YK_MONOMIALS];
} YkPoseRows;

void yk_pose_rows(const YkPose *pose, size_t count, YkPoseRows *rows);
// Evaluates row k at a moving and a fixed pivot, in the units of the rows.
double yk_pose_row(const YkPoseRows *rows, size_t k, YkVec z, YkVec F);
// Returns the RR dyad of two pivots given in the units of the rows.
YkDyad yk_pose_dyad(const YkPoseRows *rows, const YkPose *first, YkVec z, YkVec F);
// Returns a point of the body in the world.
static inline YkVec yk_pose_apply(YkPose pose, YkVec z)
{
    return yk_add(pose.at, yk_mul(yk_unit(pose.angle), z));
}

// All dyads through five positions.
typedef struct YkFivePoses {
    YkDyad dyad[4];
    size_t count;         // real ones
    size_t complex_count; // finite ones, at most 4
    bool is_special;      // infinitely many: the positions are not general
} YkFivePoses;
void yk_five_poses(const YkPose pose[5], YkFivePoses *found);

// RR dyads through four positions: a cubic curve of moving pivots (Burmester's circle-point curve). Rays from one of
// the poles, which lies on it, meet it in at most two further points each: ray `index` of `count`. Returns how many
// dyads.
typedef struct YkFourPoses {
    YkPoseRows rows;
    YkPose first;
    YkVec pole;      // in the body
    bool is_special; // no position is turned against another
} YkFourPoses;
void yk_four_poses(const YkPose pose[4], YkFourPoses *four);
size_t yk_four_poses_ray(const YkFourPoses *four, double angle, YkDyad dyad[2]);
// The dyad whose moving pivot goes along a line of the ground through two or three positions; `along` as for a pivot.
bool yk_pose_slide(const YkPose *pose, size_t count, double direction, double along, YkDyad *dyad);
// The dyad whose line, fixed in the body at a direction in its axes, always goes through the same point of the ground,
// through two or three positions: the one above, seen from the body. `along` chooses the point of the ground on the
// line that two positions leave.
bool yk_pose_block(const YkPose *pose, size_t count, double direction, double along, YkDyad *dyad);
// The dyads with a slide through four positions: at most one PR and one RP. Returns how many.
size_t yk_four_poses_slides(const YkPose pose[4], YkDyad dyad[2]);

// Returns whether two or three positions leave a dyad with this fixed pivot, and the dyad. For two positions its moving
// pivot is at `along` on a line of the body, in units of the positions' spread; for three `along` is not used.
bool yk_pose_pivot(const YkPose *pose, size_t count, YkVec fixed, double along, YkDyad *dyad);

#endif
