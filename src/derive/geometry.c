// The file's bodies and joints as elements: points, lines, masses, positions.
#include <string.h>
#include "derive/inside.h"

static const YkPoisson *vector(YkDerivation *d, const YkExpr *x, const YkExpr *y)
{
    const YkPoisson *along = yk_derive_expression(d, x), *across = yk_derive_expression(d, y);
    return yk_ring_add(d->ring, along, yk_ring_multiply(d->ring, yk_ring_i(d->ring), across));
}

const YkPoisson *yk_derive_at(YkDerivation *d, int32_t point)
{
    if (point == YK_NONE) return yk_ring_rational(d->ring, 0, 1);
    if (!d->points[point])
        d->points[point] = yk_ring_keep(d->ring, vector(d, d->model->points[point].x, d->model->points[point].y));
    return d->points[point];
}

const YkPoisson *yk_derive_along(YkDerivation *d, int32_t joint)
{
    const YkJoint *j = &d->model->joints[joint];
    if (j->along_expr) return yk_derive_turn(d, j->along_expr);
    const YkPoisson *across =
        yk_ring_scale(d->ring, yk_ring_i(d->ring), (int64_t)j->along.y, 1); // x, y or their opposites
    return yk_ring_add(d->ring, yk_ring_rational(d->ring, (int64_t)j->along.x, 1), across);
}

const YkPoisson *yk_derive_distance(YkDerivation *d, int32_t joint)
{
    int32_t c = d->joint_distance[joint];
    return c == YK_NONE ? NULL : yk_ring_of(d->ring, d->coordinates[c].position);
}

YkDerivePlace yk_derive_place(const YkDerivation *d, int32_t joint, int side)
{
    const YkJoint *j = &d->model->joints[joint];
    return (YkDerivePlace){j->body[side], j->point[side]};
}

const YkPoisson *yk_derive_position(YkDerivation *d, int32_t body, const YkPoisson *at)
{
    YkRing *ring = d->ring;
    const YkPoisson *sum = yk_ring_multiply(ring, d->bodies[body].unit, at);
    for (int32_t b = body; d->bodies[b].parent != YK_NONE; b = d->bodies[b].parent) {
        // From b's origin back over the joint: - at_b, + at_parent, and the slide along a line of the joint's first
        // body.
        int32_t joint = d->bodies[b].joint, parent = d->bodies[b].parent;
        int side = d->model->joints[joint].body[1] == b;
        YkDerivePlace here = yk_derive_place(d, joint, side), there = yk_derive_place(d, joint, !side);
        sum = yk_ring_subtract(ring, sum, yk_ring_multiply(ring, d->bodies[b].unit, yk_derive_at(d, here.point)));
        sum = yk_ring_add(ring, sum, yk_ring_multiply(ring, d->bodies[parent].unit, yk_derive_at(d, there.point)));
        if (d->joint_distance[joint] == YK_NONE) continue;
        const YkPoisson *slide = yk_derive_slide(d, joint);
        sum = side ? yk_ring_add(ring, sum, slide) : yk_ring_subtract(ring, sum, slide);
    }
    return sum;
}

const YkPoisson *yk_derive_slide(YkDerivation *d, int32_t joint)
{
    const YkPoisson *line =
        yk_ring_multiply(d->ring, d->bodies[d->model->joints[joint].body[0]].unit, yk_derive_along(d, joint));
    return yk_ring_multiply(d->ring, yk_derive_distance(d, joint), line);
}

const YkPoisson *yk_derive_origin(YkDerivation *d, int32_t body)
{
    return yk_derive_position(d, body, yk_ring_rational(d->ring, 0, 1));
}

const YkPoisson *yk_derive_mass(YkDerivation *d, int32_t body)
{
    const YkBody *b = &d->model->bodies[body];
    const YkPoisson **mass = &d->bodies[body].mass;
    if (!*mass) *mass = yk_derive_measure(d, b->mass_expr, YK_RING_MASS, "m", b->name);
    return *mass;
}

bool yk_derive_is_rod(const YkBody *body)
{
    return body->has_mass && body->rod[0] != YK_NONE && body->rod[1] != YK_NONE && body->rod[0] != body->rod[1];
}

const YkPoisson *yk_derive_center(YkDerivation *d, int32_t body)
{
    const YkBody *b = &d->model->bodies[body];
    if (!yk_derive_is_rod(b)) return vector(d, b->center_x, b->center_y);
    const YkPoisson *ends = yk_derive_at(d, b->rod[0]);
    ends = yk_ring_add(d->ring, ends, yk_derive_at(d, b->rod[1]));
    return yk_ring_scale(d->ring, ends, 1, 2);
}

// A uniform rod of length L: m L^2 / 12.
static const YkPoisson *inertia_of_rod(YkDerivation *d, int32_t body)
{
    const YkBody *b = &d->model->bodies[body];
    const YkPoisson *rod = yk_derive_at(d, b->rod[1]);
    rod = yk_ring_subtract(d->ring, rod, yk_derive_at(d, b->rod[0]));
    const YkPoisson *square = yk_ring_dot(d->ring, rod, rod), *mass = yk_derive_mass(d, body);
    return yk_ring_scale(d->ring, yk_ring_multiply(d->ring, mass, square), 1, 12);
}

const YkPoisson *yk_derive_inertia(YkDerivation *d, int32_t body)
{
    const YkBody *b = &d->model->bodies[body];
    const YkPoisson **inertia = &d->bodies[body].inertia;
    if (!*inertia)
        *inertia = yk_derive_is_rod(b) ? inertia_of_rod(d, body)
                                       : yk_derive_measure(d, b->inertia_expr, YK_RING_INERTIA, "I", b->name);
    return *inertia;
}

const YkPoisson *yk_derive_gravity(YkDerivation *d)
{
    return vector(d, d->model->gravity_x, d->model->gravity_y);
}

static bool is_stem_taken(const YkModel *model, const char *stem)
{
    size_t length = strlen(stem);
    for (size_t p = 0; p < model->point_count; p++) {
        const char *name = model->points[p].name;
        if (strncmp(name, stem, length) == 0 && strspn(name + length, "0123456789") == strlen(name + length))
            return true;
    }
    return false;
}

const char *yk_derive_pitch_name(YkDerivation *d, size_t gear_or_rack)
{
    static const char *const stems[] = {"P", "Q", "T", "pitch"};
    size_t k = 0;
    while (!d->pitch_stem && k + 1 < sizeof stems / sizeof *stems && is_stem_taken(d->model, stems[k])) k++;
    if (!d->pitch_stem) d->pitch_stem = stems[k];
    YkText text = {0};
    yk_text_format(&text, "%s%z", d->pitch_stem, gear_or_rack + 1);
    const char *name = yk_arena_copy(d->arena, yk_text_get(&text), text.length);
    d->failed |= !name;
    yk_text_free(&text);
    return name ? name : "";
}
