// Forces in an equation besides their symbols: efforts, reactions of joints and relations, and the wrench on the frame.
#include <string.h>
#include "prove/quantities.h"
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

// Returns whether it is the file's name, or as equations can write it: sun_planet for sun-planet.
static bool is_word(const char *name, size_t length, const char *word)
{
    bool is = strlen(word) == length;
    for (size_t k = 0; k < length && is; k++) is = name[k] == word[k] || (name[k] == '_' && word[k] == '-');
    return is;
}

static bool takes_ending(const char *name, size_t *length, const char *ending)
{
    size_t size = strlen(ending);
    if (*length <= size || strncmp(name + *length - size, ending, size) != 0) return false;
    *length -= size;
    return true;
}

// Returns what a load along a joint exerts on its second body; if that is the ground, minus what it exerts on the
// first.
static const YkPoisson *effort_of_load(const YkDeriveForces *f, const YkDeriveLoad *load, bool is_distance)
{
    YkDerivation *d = f->d;
    const int32_t *body = d->model->joints[load->joint].body;
    const YkDerivePush *push = load->push_count > 0 ? &load->push[0] : NULL;
    for (size_t k = 0; k < load->push_count; k++)
        if (load->push[k].body == body[1]) push = &load->push[k];
    if (!push) return NULL;
    const YkPoisson *line = yk_ring_multiply(d->ring, d->bodies[body[0]].unit, yk_derive_along(d, load->joint));
    const YkPoisson *effort = is_distance ? yk_ring_dot(d->ring, line, push->force) : push->moment;
    return push->body == body[1] ? effort : yk_ring_negate(d->ring, effort);
}

// Returns the unknown effort of a drive, or that of `efforts:`.
static const YkPoisson *effort(const YkDeriveForces *f, const char *name, size_t length)
{
    YkDerivation *d = f->d;
    if (!takes_ending(name, &length, ".effort")) return NULL;
    for (size_t c = 0; c < d->tree_count; c++) {
        const YkDeriveCoordinate *of = &d->coordinates[c];
        if (!is_word(name, length, of->name)) continue;
        for (size_t k = 0; k < f->effort_count; k++)
            if (f->effort_coordinate[k] == (int32_t)c) return yk_ring_of(d->ring, f->efforts[k]);
        for (size_t k = 0; k < f->load_count; k++) {
            const YkDeriveLoad *load = &f->loads[k];
            if (load->kind != YK_DERIVE_EFFORT || load->joint != of->joint) continue;
            if (yk_ring_is_zero(load->push[0].force) != of->is_distance) // a pin-slot has efforts of both kinds
                return effort_of_load(f, load, of->is_distance);
        }
        return NULL;
    }
    return NULL;
}

typedef enum Part { NO_PART, PART_X, PART_Y, PART_MOMENT } Part;

static Part take_part(const char *name, size_t *length, const char *x, const char *y, const char *moment)
{
    if (takes_ending(name, length, x)) return PART_X;
    if (takes_ending(name, length, y)) return PART_Y;
    return takes_ending(name, length, moment) ? PART_MOMENT : NO_PART;
}

static const YkPoisson *part_of(YkRing *ring, Part part, const YkPoisson *force, const YkPoisson *moment)
{
    if (part == PART_MOMENT) return moment;
    return part == PART_X ? yk_ring_real(ring, force) : yk_ring_imaginary(ring, force);
}

// Returns what a planet's own pin bears, as solve gives it, of the force of the pins of all equal planets: its share of
// the teeth's, and its own weight and inertia, which the equations have once.
static const YkPoisson *own_pin_force(const YkDeriveForces *f, size_t joint)
{
    YkRing *ring = f->d->ring;
    const YkJoint *pin = &f->d->model->joints[joint];
    if (pin->copies < 2) return f->joint_force[joint];
    int32_t planet = pin->body[pin->copied_side];
    const YkPoisson *pull = yk_ring_multiply(ring, f->bodies[planet].mass, f->bodies[planet].acceleration);
    for (size_t k = 0; k < f->load_count; k++)
        for (size_t p = 0; p < f->loads[k].push_count && f->loads[k].kind == YK_DERIVE_GRAVITY; p++)
            if (f->loads[k].push[p].body == planet) pull = yk_ring_subtract(ring, pull, f->loads[k].push[p].force);
    int64_t others = pin->copied_side == 1 ? pin->copies - 1 : 1 - pin->copies;
    const YkPoisson *own = yk_ring_scale(ring, f->joint_force[joint], 1, pin->copies);
    return yk_ring_add(ring, own, yk_ring_scale(ring, pull, others, pin->copies));
}

// Returns the force of one planet's teeth, of that of all equal planets'.
static const YkPoisson *own_mesh_force(const YkDeriveForces *f, size_t tie)
{
    const YkDerivation *d = f->d;
    const YkRelation *of = &d->mech->relations[tie];
    int32_t copies = of->kind == YK_RELATION_GEAR ? d->model->gears[of->index].copies : 0;
    const YkPoisson *force = f->meshes[tie].push.force;
    return copies > 1 ? yk_ring_scale(d->ring, force, 1, copies) : force;
}

// Returns the reaction of a joint on its second body by its first; the same for gears, racks, belts and cams.
static const YkPoisson *reaction(const YkDeriveForces *f, const char *name, size_t length)
{
    YkDerivation *d = f->d;
    Part part = take_part(name, &length, ".force.x", ".force.y", ".moment");
    if (part == NO_PART) return NULL;
    for (size_t j = 0; j < d->model->joint_count; j++)
        if (is_word(name, length, d->model->joints[j].name))
            return part_of(d->ring, part, own_pin_force(f, j), f->joint_moment[j]);
    for (size_t k = 0; k < d->tie_count; k++)
        if (is_word(name, length, d->ties[k].name) && d->ties[k].kind != YK_RELATION_LAW)
            return part_of(d->ring, part, own_mesh_force(f, k), f->meshes[k].push.moment);
    return NULL;
}

// --- The wrench on the frame: external actions less the inertia of the bodies, about the world's origin

static void add_push(YkRing *ring, const YkPoisson *at, const YkPoisson *force, const YkPoisson *moment,
                     const YkPoisson **sum)
{
    const YkPoisson *turning = yk_ring_add(ring, yk_ring_cross(ring, at, force), moment);
    sum[0] = yk_ring_add(ring, sum[0], force);
    sum[1] = yk_ring_add(ring, sum[1], turning);
}

static const YkPoisson *shaking(const YkDeriveForces *f, const char *name)
{
    YkDerivation *d = f->d;
    YkRing *ring = d->ring;
    size_t length = strlen(name);
    Part part = take_part(name, &length, ".x", ".y", ".moment");
    if (part == NO_PART || !is_word(name, length, "shaking") || d->most_depth > YK_DERIVE_DEPTH_MAX) return NULL;
    const YkPoisson *zero = yk_ring_rational(ring, 0, 1), *sum[] = {zero, zero};
    for (size_t k = 0; k < f->load_count; k++) {
        const YkDeriveLoad *load = &f->loads[k];
        if (load->kind != YK_DERIVE_GRAVITY && load->kind != YK_DERIVE_FORCE) continue;
        for (size_t i = 0; i < load->push_count; i++) {
            const YkDerivePush *push = &load->push[i];
            add_push(ring, yk_ring_add(ring, f->bodies[push->body].position, push->arm), push->force, push->moment,
                     sum);
        }
    }
    for (size_t b = 1; b < d->model->body_count; b++) {
        const YkDeriveMass *m = &f->bodies[b];
        const YkPoisson *taken = yk_ring_negate(ring, yk_ring_multiply(ring, m->mass, m->acceleration));
        const YkPoisson *turned = yk_ring_negate(ring, yk_ring_multiply(ring, m->inertia, d->bodies[b].spin_rate));
        add_push(ring, m->position, taken, turned, sum);
    }
    return part_of(ring, part, sum[0], sum[1]);
}

// Returns the reaction F21x = -F12x, which the second body exerts on the first.
static const YkPoisson *opposite(const YkDeriveForces *f, const char *name)
{
    static const char *const letters[] = {"F", "F", "N", "M"}, *const parts[] = {"x", "y", "", ""};
    YkDerivation *d = f->d;
    if (strchr("FNM", name[0]) == NULL) return NULL;
    for (size_t j = 0; j < d->model->joint_count; j++) {
        const YkJoint *joint = &d->model->joints[j];
        const int32_t back[2] = {joint->body[1], joint->body[0]};
        const char *pair = yk_derive_between(f, joint->body, j, joint->name);
        const char *turned = yk_derive_between(f, back, j, joint->name);
        for (size_t k = 0; k < sizeof letters / sizeof *letters; k++) {
            if (strcmp(name, yk_derive_force_name(f, letters[k], turned, parts[k])) != 0) continue;
            int32_t symbol = yk_ring_find(d->ring, yk_derive_force_name(f, letters[k], pair, parts[k]));
            if (symbol >= 0) return yk_ring_negate(d->ring, yk_ring_of(d->ring, symbol));
        }
    }
    return NULL;
}

const YkPoisson *yk_derive_force_quantity(const YkDeriveForces *f, const char *name)
{
    size_t length = strlen(name);
    const YkPoisson *a = effort(f, name, length);
    if (!a) a = reaction(f, name, length);
    if (!a) a = shaking(f, name);
    return a ? a : opposite(f, name);
}
