// Finds junctions: pins that join several bodies in one point, chained by the bodies on which they sit.
#include <stdlib.h>
#include "base/sets.h"
#include "derive/forces/free_bodies.h"

static const YkPoisson *at_of(YkDerivation *d, int32_t joint, int side)
{
    YkDerivePlace place = yk_derive_place(d, joint, side);
    return yk_derive_at(d, place.point);
}

static bool do_share_a_point(YkDerivation *d, int32_t a, int32_t b)
{
    const YkJoint *first = &d->model->joints[a], *second = &d->model->joints[b];
    for (int s = 0; s < 2; s++)
        for (int t = 0; t < 2; t++) {
            if (first->body[s] != second->body[t] || first->body[s] == 0) continue;
            const YkPoisson *at = at_of(d, a, s);
            if (yk_ring_is_same(at, at_of(d, b, t))) return true;
        }
    return false;
}

// Pins of each body, so that only neighbours are compared.
typedef struct PinsOf {
    int32_t *first, *next; // per body; per end of a joint
} PinsOf;

static void unite_neighbours(YkDerivation *d, const PinsOf *pins, int32_t *parent)
{
    for (size_t b = 1; b < d->model->body_count; b++)
        for (int32_t e = pins->first[b]; e != YK_NONE; e = pins->next[e])
            for (int32_t o = pins->next[e]; o != YK_NONE; o = pins->next[o])
                if (do_share_a_point(d, e / 2, o / 2)) yk_sets_join(parent, e / 2, o / 2);
}

// Numbers the sets of two or more pins by their first joint. last: per root, its junction's last joint so far.
static void number_junctions(YkDeriveForces *f, int32_t *parent, int32_t *size, int32_t *last)
{
    YkDerivation *d = f->d;
    for (size_t j = 0; j < d->model->joint_count; j++)
        if (d->model->joints[j].kind == YK_PIN) size[yk_root_of(parent, (int32_t)j)]++;
    for (size_t j = 0; j < d->model->joint_count; j++) {
        int32_t root = yk_root_of(parent, (int32_t)j);
        f->junction_of[j] = f->next_at_junction[j] = YK_NONE;
        if (d->model->joints[j].kind != YK_PIN || size[root] < 2) continue;
        int32_t before = last[root] - 1; // 0: none
        last[root] = (int32_t)j + 1;
        if (before >= 0) {
            f->junction_of[j] = f->junction_of[before];
            f->next_at_junction[before] = (int32_t)j;
            continue;
        }
        const YkJoint *joint = &d->model->joints[j];
        int side = joint->body[0] == 0;
        f->junctions[f->junction_count] =
            (YkDeriveJunction){.place = yk_derive_place(d, (int32_t)j, side),
                               .force = yk_ring_rational(d->ring, 0, 1),
                               .first_joint = (int32_t)j,
                               .first_contact = YK_NONE,
                               .last_contact = YK_NONE,
                               .name = yk_derive_point_name(d, joint->body[side], joint->point[side])};
        f->junction_of[j] = (int32_t)f->junction_count++;
    }
}

bool yk_derive_find_junctions(YkDeriveForces *f)
{
    const YkModel *model = f->d->model;
    size_t joints = model->joint_count, bodies = model->body_count;
    int32_t *block = yk_derive_scratch(f->d, 5 * joints + bodies + 1, sizeof *block);
    if (!block) return false;
    int32_t *parent = block, *size = block + joints;
    PinsOf pins = {block + 2 * joints, block + 2 * joints + bodies};
    int32_t *last = block + 4 * joints + bodies;
    for (size_t b = 0; b < bodies; b++) pins.first[b] = YK_NONE;
    yk_sets_begin(parent, joints);
    for (size_t j = 0; j < joints; j++)
        for (int side = 0; side < 2 && model->joints[j].kind == YK_PIN; side++) {
            int32_t *first = &pins.first[model->joints[j].body[side]];
            pins.next[2 * j + (size_t)side] = *first;
            *first = (int32_t)(2 * j) + side;
        }
    unite_neighbours(f->d, &pins, parent);
    number_junctions(f, parent, size, last);
    free(block);
    return true;
}
