// Forward dynamics of open trees with slides and pin-slots. A link's point is its joint's point at this instant. If the
// line belongs to the link, that is a different point of the link from pose to pose; the equations hold for whichever
// point of the body is there.
//
// Over one joint: the link's point accelerates by a + alpha x arm - w^2 arm (as a point of the parent) + 2 w x line
// rate (Coriolis; w of the link that has the line) + line acceleration; slides keep the parent's alpha.
#include "equations/tree_joints.h"
#include "equations/tree_noise.h"

typedef struct Pose {
    YkVec shift;     // the link's point, in its own axes
    YkVec arm, line; // from the parent's point; the line's direction: world axes
    YkVec bias;      // of the acceleration, as above
    YkArticulated A;
    YkInertia noise;
    YkAnswer turn, slide;
    YkVec a;
    double alpha;
} Pose;

struct YkTreeJoints {
    YkTreeAngles angles;
    const YkTreeLinks *links;
    Pose *pose; // [link]
    YkVec gravity;
};

YkTreeJoints *yk_tree_joints_new(const YkTreeLinks *links, YkVec gravity, YkArena *arena)
{
    YkTreeJoints *joints = YK_NEW(arena, YkTreeJoints, 1);
    if (!joints || !yk_tree_angles_start(&joints->angles, links, arena)) return NULL;
    joints->links = links;
    joints->gravity = gravity;
    joints->pose = YK_NEW(arena, Pose, links->count);
    return yk_arena_failed(arena) ? NULL : joints;
}

// Visits parents before children: places every joint, and each link by itself.
static void place(const YkTreeJoints *joints, const double *q, const double *v)
{
    const YkTreeAngles *angles = &joints->angles;
    joints->pose[0] = (Pose){.a = yk_scale(-1, joints->gravity)}; // the ground accelerates against gravity
    for (size_t k = 1; k < angles->count; k++) {
        const YkTreeLink *link = &joints->links->link[k];
        Pose *pose = &joints->pose[k];
        size_t p = (size_t)link->parent, l = link->line_is_own ? k : p; // l: has the line
        YkVec e = yk_vec(angles->c[k], angles->s[k]), e_p = yk_vec(angles->c[p], angles->s[p]);
        double w_p = angles->w[p], d = 0, rate = 0;
        if (link->distance != YK_NONE) d = q[link->distance], rate = v[link->distance];
        YkVec along = yk_scale(d, link->line), at = yk_sub(link->at, joints->pose[p].shift);
        pose->shift = link->line_is_own ? yk_scale(-1, along) : yk_vec(0, 0);
        pose->arm = yk_mul(e_p, link->line_is_own ? at : yk_add(at, along));
        pose->line = yk_mul(l == k ? e : e_p, link->line);
        pose->bias = yk_add(yk_scale(-w_p * w_p, pose->arm), yk_scale(2 * angles->w[l] * rate, yk_quarter(pose->line)));
        YkVec center = yk_sub(link->center, pose->shift);
        double inertia = link->inertia + link->mass * yk_dot(center, center);
        pose->A = (YkArticulated){0};
        yk_articulated_add_body(&pose->A, link->mass, yk_scale(link->mass, yk_mul(e, center)), inertia, angles->w[k]);
        pose->noise = (YkInertia){0};
        yk_noise_add_body(&pose->noise, link->mass, inertia);
    }
}

static double along(const double *effort, int32_t input)
{
    return effort ? effort[input] : 0;
}

// Releases the freedoms of a link's joint. Returns -1, or the input without inertia.
static int release(const YkTreeLink *link, Pose *pose, const double *effort)
{
    YkArticulated *A = &pose->A;
    YkInertia *noise = &pose->noise;
    if (link->angle != YK_NONE) {
        if (!(A->of.J > YK_LEAST_OVER_NOISE * noise->J)) return link->angle;
        double trace = yk_inertia_trace(&A->of);
        pose->turn = yk_articulated_release_turn(A, link->sense * along(effort, link->angle));
        yk_noise_release_turn(noise, pose->turn.on, trace);
    }
    A->f = yk_add(A->f, yk_inertia_times(&A->of, pose->bias));
    A->n += yk_dot(A->of.h, pose->bias);
    if (link->distance != YK_NONE) {
        double pivot = yk_dot(pose->line, yk_inertia_times(&A->of, pose->line));
        if (!(pivot > YK_LEAST_OVER_NOISE * yk_noise_along(noise, pose->line))) return link->distance;
        const YkArticulated before = *A;
        pose->slide = yk_articulated_release_slide(A, pose->line, along(effort, link->distance));
        yk_noise_release_slide(noise, pose->line, pose->slide, &before);
    }
    return -1;
}

static int inward(const YkTreeJoints *joints, const double *effort)
{
    for (size_t k = joints->angles.count - 1; k > 0; k--) {
        const YkTreeLink *link = &joints->links->link[k];
        Pose *pose = &joints->pose[k], *parent = &joints->pose[link->parent];
        int culprit = release(link, pose, effort);
        if (culprit >= 0) return culprit;
        YkArticulated moved = yk_articulated_move(&pose->A, pose->arm);
        YkInertia noise = yk_noise_move(&pose->noise, yk_quarter(pose->arm), yk_inertia_trace(&pose->A.of));
        yk_articulated_add(&parent->A, &moved);
        yk_inertia_add(&parent->noise, &noise);
    }
    return -1;
}

static void outward(const YkTreeJoints *joints, double *out)
{
    for (size_t k = 1; k < joints->angles.count; k++) {
        const YkTreeLink *link = &joints->links->link[k];
        const Pose *parent = &joints->pose[link->parent];
        Pose *pose = &joints->pose[k];
        double alpha = parent->alpha;
        YkVec a = yk_add(yk_add(parent->a, pose->bias), yk_scale(alpha, yk_quarter(pose->arm)));
        if (link->distance != YK_NONE) {
            // The slide was released with the bias included, so its answer is to accelerations without it.
            YkAnswer s = pose->slide;
            double slide = s.by - s.turn * alpha - yk_dot(s.on, yk_sub(a, pose->bias));
            a = yk_add(a, yk_scale(slide, pose->line));
            out[link->distance] = slide;
        }
        if (link->angle != YK_NONE) {
            alpha = pose->turn.by - yk_dot(pose->turn.on, a);
            out[link->angle] = link->sense * (alpha - parent->alpha);
        }
        pose->a = a;
        pose->alpha = alpha;
    }
}

int yk_tree_joints_accelerate(YkTreeJoints *joints, const double *q, const double *v, const double *effort, double *a)
{
    yk_tree_angles_find(&joints->angles, q, v);
    place(joints, q, v);
    int culprit = inward(joints, effort);
    if (culprit < 0) outward(joints, a);
    return culprit;
}
