// The parts of the forces of gears, racks, belts and cams: unknowns, places, forces and couples on bodies.
#include "derive/forces/meshes.h"

void yk_mesh_unknown(YkMeshMaking *m, const char *letter, const int32_t body[2], const char *word)
{
    YkDeriveForces *f = m->f;
    m->between = yk_derive_between(f, body, f->d->model->joint_count + m->index, m->tie->name);
    m->mesh->symbol = yk_derive_symbol(m->d, yk_derive_force_name(f, letter, m->between, ""), YK_RING_FORCE);
    m->mesh->word = word;
    if (m->mesh->symbol < 0) return;
    f->reaction_joint[f->reaction_count] = f->reaction_body[f->reaction_count] = YK_NONE;
    f->reaction_part[f->reaction_count] = 'r';
    f->reactions[f->reaction_count++] = m->mesh->symbol;
    m->unknown = yk_ring_of(m->ring, m->mesh->symbol);
}

void yk_mesh_add_contact(YkMeshMaking *m, YkDeriveContact contact)
{
    contact.joint = contact.junction = YK_NONE;
    contact.point = m->point;
    m->f->contacts[m->f->contact_count++] = contact;
}

YkMeshHeld yk_mesh_held_by(YkMeshMaking *m, int32_t joint, int side)
{
    YkMeshHeld held = {YK_NEW(m->d->arena, YkDeriveHolder, 1), 1};
    if (held.holders) held.holders[0] = (YkDeriveHolder){joint, side};
    m->d->failed |= !held.holders;
    return held;
}

// Adds a force on body[1] and its opposite on body[0]; the arms lead from their references to where it acts.
void yk_mesh_force(YkMeshMaking *m, const char *letter, const int32_t body[2], const YkMeshHeld held[2],
                   const YkPoisson *const arm[2], const YkPoisson *force)
{
    const YkPoisson *zero = yk_ring_rational(m->ring, 0, 1);
    for (int k = 0; k < 2; k++) {
        YkDerivePush push = {body[k], arm[k], k ? force : yk_ring_negate(m->ring, force), zero};
        yk_mesh_add_contact(m, (YkDeriveContact){.by = m->by[k] ? m->by[k] : m->d->model->bodies[body[!k]].name,
                                                 .letter = letter,
                                                 .between = m->between,
                                                 .is_negative = k == 0,
                                                 .holders = held[k].holders,
                                                 .holder_count = held[k].holders ? held[k].count : 0,
                                                 .push = push});
        if (k) m->mesh->push = push;
    }
}

// Adds a couple under a name of its own, for the wheels of a belt: neither carries the opposite of the other's.
void yk_mesh_couple(YkMeshMaking *m, int32_t body, const YkPoisson *moment)
{
    const YkPoisson *zero = yk_ring_rational(m->ring, 0, 1);
    YkText number = {0};
    yk_text_format(&number, "%d", (int)body);
    const char *between = yk_derive_text(m->d, m->tie->name, "_", yk_text_get(&number));
    m->d->failed |= number.failed;
    yk_text_free(&number);
    if (!moment || yk_ring_is_zero(moment)) return;
    yk_mesh_add_contact(m,
                        (YkDeriveContact){.by = m->tie->name,
                                          .between = between,
                                          .moment = "M",
                                          .push = {body, zero, zero, yk_ring_multiply(m->ring, moment, m->unknown)}});
}

// Adds couples on two bodies, and the remainder on a third; the unknown's value is that of the second.
void yk_mesh_couples(YkMeshMaking *m, const int32_t body[2], int32_t third, const YkPoisson *a, const YkPoisson *b)
{
    const YkPoisson *zero = yk_ring_rational(m->ring, 0, 1), *c = yk_ring_negate(m->ring, yk_ring_add(m->ring, a, b));
    yk_mesh_couple(m, body[0], a);
    yk_mesh_couple(m, body[1], b);
    yk_mesh_couple(m, third, c);
    m->mesh->push = (YkDerivePush){body[1], zero, zero, yk_ring_multiply(m->ring, b, m->unknown)};
}

const YkPoisson *yk_mesh_center(YkMeshMaking *m, int32_t body)
{
    return yk_derive_arm(m->f, body, yk_ring_rational(m->ring, 0, 1));
}

// Returns the vector from a body's reference to a place of the world.
const YkPoisson *yk_mesh_arm(YkMeshMaking *m, int32_t body, const YkPoisson *place)
{
    return yk_ring_subtract(m->ring, place, m->f->bodies[body].position);
}

// Returns where a joint holds its first or second body, in that body's axes.
const YkPoisson *yk_mesh_at(YkMeshMaking *m, int32_t joint, int side)
{
    YkDerivePlace place = yk_derive_place(m->d, joint, side);
    return yk_derive_at(m->d, place.point);
}

// Returns the unit vector along a slide's line in the world, forwards for its second body.
const YkPoisson *yk_mesh_line(YkMeshMaking *m, int32_t joint)
{
    return yk_ring_multiply(m->ring, m->d->bodies[m->d->model->joints[joint].body[0]].unit,
                            yk_derive_along(m->d, joint));
}
