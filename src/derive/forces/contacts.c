// Contacts: what joints and junctions exert on bodies.
#include "derive/forces/free_bodies.h"

// An unknown of a joint (of a junction: on a body): its symbol.
static int32_t unknown(YkDeriveForces *f, const char *letter, const char *name, char part, int32_t joint, int32_t body)
{
    YkDerivation *d = f->d;
    const char *ending = part == 'x' ? "x" : part == 'y' ? "y" : "";
    int32_t symbol = yk_derive_symbol(d, yk_derive_force_name(f, letter, name, ending), YK_RING_FORCE);
    if (symbol < 0) return symbol;
    f->reaction_joint[f->reaction_count] = joint;
    f->reaction_body[f->reaction_count] = body;
    f->reaction_part[f->reaction_count] = part;
    f->reactions[f->reaction_count++] = symbol;
    return symbol;
}

static const YkPoisson *unknown_vector(YkDeriveForces *f, const char *name, int32_t joint, int32_t body)
{
    int32_t x = unknown(f, "F", name, 'x', joint, body), y = unknown(f, "F", name, 'y', joint, body);
    return yk_ring_vector(f->d->ring, x, y);
}

// --- Junctions' contacts

static const YkDeriveContact *contact_on(const YkDeriveForces *f, int32_t junction, int32_t body)
{
    for (int32_t k = f->junctions[junction].first_contact; k != YK_NONE; k = f->contacts[k].next)
        if (f->contacts[k].push.body == body) return &f->contacts[k];
    return NULL;
}

static void add_at_junction(YkDeriveForces *f, YkDeriveJunction *junction, YkDeriveContact contact)
{
    int32_t index = (int32_t)f->contact_count;
    if (junction->last_contact == YK_NONE)
        junction->first_contact = index;
    else
        f->contacts[junction->last_contact].next = index;
    junction->last_contact = index;
    contact.next = YK_NONE;
    f->contacts[f->contact_count++] = contact;
}

static void add_junction_contact(YkDeriveForces *f, int32_t joint, int side)
{
    YkDerivation *d = f->d;
    int32_t junction = f->junction_of[joint], body = d->model->joints[joint].body[side];
    if (contact_on(f, junction, body)) return;
    YkDeriveJunction *of = &f->junctions[junction];
    const char *mark = d->model->body_count > 10 ? "_" : "";
    const char *name = yk_derive_numbered(d, yk_derive_text(d, of->name, mark, ""), (size_t)body);
    const YkPoisson *force = unknown_vector(f, name, joint, body), *zero = yk_ring_rational(d->ring, 0, 1);
    add_at_junction(f, of,
                    (YkDeriveContact){.joint = joint,
                                      .junction = junction,
                                      .letter = "F",
                                      .between = name,
                                      .push = {body, yk_derive_joint_arm(f, joint, side), force, zero}});
    of->force = yk_ring_subtract(d->ring, of->force, force);
}

// Marks the bodies that pins of the junction join to `body` without pin `joint`.
static void mark_side(const YkDeriveForces *f, int32_t joint, int32_t body, bool *marked)
{
    const YkModel *model = f->d->model;
    bool grew = true;
    marked[body] = true;
    while (grew) {
        grew = false;
        for (int32_t j = f->junctions[f->junction_of[joint]].first_joint; j != YK_NONE; j = f->next_at_junction[j]) {
            if (j == joint) continue;
            const int32_t *b = model->joints[j].body;
            if (marked[b[0]] == marked[b[1]]) continue;
            marked[b[0]] = marked[b[1]] = grew = true;
        }
    }
}

// Returns the force that a pin of a junction carries: the forces on all bodies beyond it, seen from the junction's
// place. If pins form a ring among themselves, this is one possible share.
// marked: per body, none at the beginning and at the end.
static const YkPoisson *share_of_pin(YkDeriveForces *f, int32_t joint, bool *marked)
{
    YkDerivation *d = f->d;
    const YkJoint *j = &d->model->joints[joint];
    const YkDeriveJunction *junction = &f->junctions[f->junction_of[joint]];
    const YkPoisson *sum = yk_ring_rational(d->ring, 0, 1);
    mark_side(f, joint, j->body[1], marked);
    bool holds_place = marked[junction->place.body];
    for (int32_t k = junction->first_contact; k != YK_NONE; k = f->contacts[k].next)
        if (marked[f->contacts[k].push.body] != holds_place) sum = yk_ring_add(d->ring, sum, f->contacts[k].push.force);
    for (int32_t k = junction->first_contact; k != YK_NONE; k = f->contacts[k].next)
        marked[f->contacts[k].push.body] = false;
    return holds_place ? yk_ring_negate(d->ring, sum) : sum;
}

// --- Joints' contacts

static const YkPoisson *normal_of(YkDerivation *d, int32_t joint)
{
    const YkPoisson *line =
        yk_ring_multiply(d->ring, d->bodies[d->model->joints[joint].body[0]].unit, yk_derive_along(d, joint));
    return yk_ring_multiply(d->ring, yk_ring_i(d->ring), line);
}

static void enter_joint(YkDeriveForces *f, int32_t joint)
{
    YkDerivation *d = f->d;
    const YkJoint *j = &d->model->joints[joint];
    const YkPart *part = yk_part(j->kind);
    const char *name = yk_derive_between(f, j->body, (size_t)joint, j->name), *letter = part->slides ? "N" : "F";
    const YkPoisson *force, *moment = yk_ring_rational(d->ring, 0, 1);
    if (part->slides) {
        const YkPoisson *size = yk_ring_of(d->ring, unknown(f, "N", name, 'n', joint, YK_NONE));
        force = yk_ring_multiply(d->ring, size, normal_of(d, joint));
    } else {
        force = unknown_vector(f, name, joint, YK_NONE);
    }
    if (!part->turns) moment = yk_ring_of(d->ring, unknown(f, "M", name, 'm', joint, YK_NONE));
    f->joint_force[joint] = force;
    f->joint_moment[joint] = moment;
    for (int side = 0; side < 2; side++) {
        YkDerivePush push = {j->body[side], yk_derive_joint_arm(f, joint, side), force, moment};
        if (side == 0) push.force = yk_ring_negate(d->ring, force), push.moment = yk_ring_negate(d->ring, moment);
        f->contacts[f->contact_count++] = (YkDeriveContact){.joint = joint,
                                                            .junction = YK_NONE,
                                                            .letter = letter,
                                                            .between = name,
                                                            .moment = part->turns ? NULL : "M",
                                                            .is_negative = side == 0,
                                                            .push = push,
                                                            .next = YK_NONE};
    }
}

// --- A guide's moment and the moment balance of a body whose forces all meet in its centre say nothing.

static bool is_turned(const YkDeriveForces *f, int32_t body)
{
    size_t count;
    const int32_t *pushes = yk_derive_pushes_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveLoad *load = &f->loads[pushes[k] / 2];
        bool is_along_guide = load->joint != YK_NONE && yk_ring_is_zero(load->push[0].moment);
        if (load->kind != YK_DERIVE_GRAVITY && load->kind != YK_DERIVE_DRIVE && !is_along_guide) return true;
    }
    return false;
}

static void find_trivial(YkDeriveForces *f, int32_t body)
{
    const YkDerivation *d = f->d;
    int slides = 0;
    size_t count;
    const int32_t *contacts = yk_derive_contacts_on(f, body, &count);
    for (size_t k = 0; k < count; k++) {
        const YkDeriveContact *c = &f->contacts[contacts[k]];
        if (c->joint == YK_NONE && c->letter && yk_ring_is_zero(c->push.arm)) continue; // along the guide
        if (c->joint == YK_NONE) return;
        YkPartKind kind = d->model->joints[c->joint].kind;
        slides += kind == YK_SLIDE;
        bool is_bearing = kind == YK_SLIDE && !c->is_negative;
        if ((kind != YK_PIN && !is_bearing) || !yk_ring_is_zero(c->push.arm)) return;
    }
    f->bodies[body].is_trivial = slides == 1 && !is_turned(f, body);
}

static bool allocate(YkDeriveForces *f)
{
    YkArena *arena = f->d->arena;
    size_t joints = f->d->model->joint_count, ties = f->d->mech->relation_count, most = 4 * joints + ties + 1;
    f->contacts = YK_NEW(arena, YkDeriveContact, 2 * joints + 4 * ties + 1);
    f->junctions = YK_NEW(arena, YkDeriveJunction, joints + 1);
    f->junction_of = YK_NEW(arena, int32_t, joints + 1);
    f->next_at_junction = YK_NEW(arena, int32_t, joints + 1);
    f->is_double = YK_NEW(arena, bool, joints + ties + 1);
    f->joint_force = YK_NEW(arena, const YkPoisson *, joints + 1);
    f->joint_moment = YK_NEW(arena, const YkPoisson *, joints + 1);
    f->reactions = YK_NEW(arena, int32_t, most);
    f->reaction_joint = YK_NEW(arena, int32_t, most);
    f->reaction_body = YK_NEW(arena, int32_t, most);
    f->reaction_part = YK_NEW(arena, char, most);
    return !yk_arena_failed(arena);
}

bool yk_derive_enter_contacts(YkDeriveForces *f)
{
    YkDerivation *d = f->d;
    bool *marked = YK_NEW(d->arena, bool, d->model->body_count + 1);
    if (!allocate(f) || !yk_derive_find_doubles(d, f->is_double) || !yk_derive_find_junctions(f)) {
        d->failed = true;
        return false;
    }
    for (size_t j = 0; j < d->model->joint_count; j++) {
        if (d->model->joints[j].is_free) {
            f->joint_force[j] = f->joint_moment[j] = yk_ring_rational(d->ring, 0, 1);
            continue;
        }
        if (f->junction_of[j] == YK_NONE) enter_joint(f, (int32_t)j);
        for (int side = 0; side < 2 && f->junction_of[j] != YK_NONE; side++) add_junction_contact(f, (int32_t)j, side);
    }
    for (size_t j = 0; j < d->model->joint_count; j++) {
        if (f->junction_of[j] == YK_NONE) continue;
        f->joint_force[j] = share_of_pin(f, (int32_t)j, marked);
        f->joint_moment[j] = yk_ring_rational(d->ring, 0, 1);
    }
    f->joint_contact_count = f->contact_count;
    if (!yk_derive_enter_meshes(f) || !yk_derive_sort_contacts(f)) return false;
    for (size_t b = 1; b < d->model->body_count; b++) find_trivial(f, (int32_t)b);
    return yk_derivation_is_well(d);
}
