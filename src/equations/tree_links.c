// Builds the links of an open tree.
#include "equations/tree_links.h"
#include "part/part.h"

// The place of a body in its link: its origin, and its x axis as a unit vector.
typedef struct Seat {
    YkVec origin, unit;
    int32_t link;
} Seat;

typedef struct Builder {
    const YkMechanism *mech;
    YkTreeLinks *links;
    Seat *seat;                          // [body]
    int32_t *first_child, *next_sibling; // [body], or YK_NONE
} Builder;

static YkVec unit_of(double angle)
{
    return angle == 0 ? yk_vec(1, 0) : yk_unit(angle);
}

static int32_t input_of(const YkMechanism *mech, int32_t joint, bool is_distance)
{
    int32_t coordinate = yk_tree_coordinate(mech, joint, is_distance);
    return coordinate == YK_NONE ? YK_NONE : mech->coordinates[coordinate].input;
}

static YkVec seated(Seat seat, YkVec at)
{
    return yk_add(seat.origin, yk_mul(seat.unit, at));
}

// Returns the direction of a link's line; see YkTreeLink.
static YkVec line_of(const YkJoint *joint, bool is_reversed, Seat parent, Seat own)
{
    return is_reversed ? yk_scale(-1, yk_mul(own.unit, joint->along)) : yk_mul(parent.unit, joint->along);
}

// Seats a body whose parent is seated: in the same link by a weld, otherwise in a new one.
static void seat_body(Builder *b, int32_t body)
{
    int32_t j = b->mech->tree.joint[body];
    const YkJoint *joint = &b->mech->model->joints[j];
    const YkPart *part = yk_part(joint->kind);
    bool is_reversed = joint->body[0] == body;
    Seat parent = b->seat[b->mech->tree.parent[body]], *own = &b->seat[body];
    YkVec at = seated(parent, joint->at[is_reversed ? 1 : 0]), start = yk_vec(0, 0);
    own->unit = parent.unit;
    if (!part->turns) own->unit = yk_mul(parent.unit, unit_of(is_reversed ? -joint->turned : joint->turned));
    if (part->turns || part->slides) {
        own->link = (int32_t)b->links->count++;
        b->links->link[own->link] =
            (YkTreeLink){.parent = parent.link,
                         .angle = part->turns ? input_of(b->mech, j, false) : YK_NONE,
                         .distance = part->slides ? input_of(b->mech, j, true) : YK_NONE,
                         .sense = !part->turns ? 0 : (is_reversed ? -1 : 1),
                         .line_is_own = part->turns && part->slides && is_reversed,
                         .at = at,
                         .line = part->slides ? line_of(joint, is_reversed, parent, *own) : yk_vec(0, 0)};
        b->links->has_slides |= part->slides;
    } else {
        own->link = parent.link;
        start = at;
    }
    own->origin = yk_sub(start, yk_mul(own->unit, joint->at[is_reversed ? 0 : 1]));
}

// Seats bodies in preorder, without a stack: down to a first child, on to a sibling, back up.
static void seat_all(Builder *b)
{
    int32_t body = 0;
    for (;;) {
        if (b->first_child[body] != YK_NONE) {
            body = b->first_child[body];
        } else {
            while (body != 0 && b->next_sibling[body] == YK_NONE) body = b->mech->tree.parent[body];
            if (body == 0) return;
            body = b->next_sibling[body];
        }
        seat_body(b, body);
    }
}

static void list_children(Builder *b)
{
    size_t n = b->mech->model->body_count;
    for (size_t k = 0; k < n; k++) b->first_child[k] = b->next_sibling[k] = YK_NONE;
    for (size_t k = n - 1; k > 0; k--) {
        int32_t parent = b->mech->tree.parent[k];
        b->next_sibling[k] = b->first_child[parent];
        b->first_child[parent] = (int32_t)k;
    }
}

// Sums masses and centres first, so that inertias are summed about the final centres, without differences.
static void sum_masses(const Builder *b)
{
    const YkModel *model = b->mech->model;
    YkTreeLink *link = b->links->link;
    for (size_t k = 1; k < model->body_count; k++) {
        const YkBody *body = &model->bodies[k];
        YkTreeLink *own = &link[b->seat[k].link];
        if (!body->has_mass) continue;
        own->mass += body->mass;
        own->center = yk_add(own->center, yk_scale(body->mass, seated(b->seat[k], body->center)));
    }
    for (size_t k = 1; k < b->links->count; k++)
        link[k].center = link[k].mass > 0 ? yk_scale(1 / link[k].mass, link[k].center) : yk_vec(0, 0);
    for (size_t k = 1; k < model->body_count; k++) {
        const YkBody *body = &model->bodies[k];
        YkTreeLink *own = &link[b->seat[k].link];
        if (!body->has_mass) continue;
        YkVec arm = yk_sub(seated(b->seat[k], body->center), own->center);
        own->inertia += body->inertia + body->mass * yk_dot(arm, arm);
    }
}

bool yk_tree_links_build(YkTreeLinks *links, const YkMechanism *mech, YkArena *arena)
{
    size_t n = mech->model->body_count;
    Builder b = {.mech = mech, .links = links};
    *links = (YkTreeLinks){.link = YK_NEW(arena, YkTreeLink, n), .count = 1};
    b.seat = YK_NEW(arena, Seat, n);
    b.first_child = YK_NEW(arena, int32_t, n);
    b.next_sibling = YK_NEW(arena, int32_t, n);
    if (yk_arena_failed(arena)) return false;
    links->link[0] = (YkTreeLink){.parent = YK_NONE, .angle = YK_NONE, .distance = YK_NONE};
    b.seat[0] = (Seat){.unit = {1, 0}};
    list_children(&b);
    seat_all(&b);
    sum_masses(&b);
    return true;
}
