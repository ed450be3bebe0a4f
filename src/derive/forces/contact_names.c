// Names of contacts: the two bodies, and a suffix that distinguishes contacts of the same two bodies.
#include <stdlib.h>
#include "derive/forces/free_bodies.h"

static uint64_t pair_of(const int32_t body[2])
{
    uint64_t a = (uint32_t)body[0], b = (uint32_t)body[1];
    return a < b ? a << 32 | b : b << 32 | a;
}

// The bodies that a relation ties directly; those of a law are held by the joint along which it acts.
static bool is_between(const YkModel *model, const YkRelation *r, int32_t body[2])
{
    const YkRack *rack = r->kind == YK_RELATION_RACK ? &model->racks[r->index] : NULL;
    const YkCam *cam = r->kind == YK_RELATION_CAM ? &model->cams[r->index] : NULL;
    const int32_t *pair = r->kind == YK_RELATION_GEAR   ? model->gears[r->index].body
                          : r->kind == YK_RELATION_BELT ? model->belts[r->index].body
                                                        : NULL;
    for (int k = 0; pair && k < 2; k++) body[k] = pair[k];
    if (rack) body[0] = rack->pinion, body[1] = rack->rack;
    if (cam) body[0] = cam->cam, body[1] = cam->follower;
    return pair || rack || cam;
}

typedef struct Pair {
    uint64_t bodies;
    int32_t index;
} Pair;

static int by_bodies(const void *a, const void *b)
{
    const Pair *left = a, *right = b;
    return left->bodies < right->bodies ? -1 : left->bodies > right->bodies;
}

bool yk_derive_find_doubles(YkDerivation *d, bool *is_double)
{
    const YkModel *model = d->model;
    size_t count = model->joint_count;
    Pair *pairs = yk_derive_scratch(d, count + d->mech->relation_count + 1, sizeof *pairs);
    if (!pairs) return false;
    for (size_t j = 0; j < count; j++) pairs[j] = (Pair){pair_of(model->joints[j].body), (int32_t)j};
    for (size_t k = 0; k < d->mech->relation_count; k++) {
        int32_t body[2];
        if (is_between(model, &d->mech->relations[k], body))
            pairs[count++] = (Pair){pair_of(body), (int32_t)(model->joint_count + k)};
    }
    qsort(pairs, count, sizeof *pairs, by_bodies);
    for (size_t k = 1; k < count; k++)
        if (pairs[k].bodies == pairs[k - 1].bodies) is_double[pairs[k].index] = is_double[pairs[k - 1].index] = true;
    free(pairs);
    return true;
}

const char *yk_derive_between(const YkDeriveForces *f, const int32_t body[2], size_t index, const char *name)
{
    YkDerivation *d = f->d;
    char digits[48] = {0}, *pair = yk_derive_digits(digits + sizeof digits - 1, (size_t)body[1]);
    if (d->model->body_count > 10) *--pair = '_';
    pair = yk_derive_digits(pair, (size_t)body[0]);
    bool is_double = f->is_double[index];
    return yk_derive_text(d, pair, is_double ? "_" : "", is_double ? name : "");
}

const char *yk_derive_force_name(const YkDeriveForces *f, const char *letter, const char *name, const char *part)
{
    const char *const parts[] = {letter, f->d->model->body_count > 10 ? "_" : "", name, part};
    const char *text = yk_page_join(f->d->arena, parts, 4);
    f->d->failed |= !text;
    return text ? text : "";
}
