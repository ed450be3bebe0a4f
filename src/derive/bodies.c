// Bodies: gives each that turns an angle of its own, and leads from body form to joint form.
#include "derive/inside.h"

enum { ANGLE_TERMS_MAX = 3000000 };

// Returns the sense of a body's joint: its coordinate counts from first to second body; -1 if the tree goes backwards.
static int sense(const YkDerivation *d, int32_t body)
{
    return d->model->joints[d->bodies[body].joint].body[1] == body ? 1 : -1;
}

static bool enter_own_angle(YkDerivation *d, YkDeriveBody *body, const char *name)
{
    YkText text = {0};
    bool is_joint = yk_names_find(&d->model->joint_names, name) != YK_NONE; // then NAME.angle is the joint's
    yk_text_format(&text, is_joint ? "%s_body.angle" : "%s.angle", name);
    body->angle = yk_derive_angle(d, yk_text_get(&text));
    body->rate = yk_ring_rates(d->ring, body->angle);
    body->acceleration = body->rate + 1;
    d->failed |= text.failed;
    yk_text_free(&text);
    d->change_count += 3;
    return body->rate >= 0;
}

static bool turn_with(YkDerivation *d, int32_t index)
{
    YkDeriveBody *body = &d->bodies[index];
    const YkDeriveBody *parent = &d->bodies[body->parent];
    const char *name = d->model->bodies[index].name;
    int32_t coordinate = d->joint_angle[body->joint];
    body->joints_in_angle = parent->joints_in_angle + (coordinate != YK_NONE);
    if (body->joints_in_angle > d->most_joints) d->most_joints = body->joints_in_angle;
    if (coordinate == YK_NONE) { // a slide or a weld keeps the angle
        const YkPoisson *turned = yk_derive_turn(d, d->model->joints[body->joint].turned_expr);
        if (sense(d, index) < 0) turned = yk_ring_conjugate(d->ring, turned);
        body->angle = parent->angle, body->rate = parent->rate, body->acceleration = parent->acceleration;
        body->turn = yk_ring_multiply(d->ring, parent->turn, turned);
    } else {
        const YkDeriveCoordinate *c = &d->coordinates[coordinate];
        bool is_coordinate = parent->angle == YK_NONE &&
                             yk_ring_is_same(parent->unit, yk_ring_rational(d->ring, 1, 1)) && sense(d, index) > 0;
        if (is_coordinate) body->angle = c->position, body->rate = c->rate, body->acceleration = c->acceleration;
        if (!is_coordinate && !enter_own_angle(d, body, name)) return false;
        body->turn = yk_ring_rational(d->ring, 1, 1);
    }
    if (body->angle == YK_NONE) {
        body->unit = body->turn;
        body->spin = body->spin_rate = yk_ring_rational(d->ring, 0, 1);
        return body->unit != NULL;
    }
    body->unit = yk_ring_multiply(d->ring, yk_ring_unit(d->ring, body->angle), body->turn);
    body->spin = yk_ring_of(d->ring, body->rate);
    body->spin_rate = yk_ring_of(d->ring, body->acceleration);
    return body->unit && body->spin && body->spin_rate;
}

bool yk_derive_enter_bodies(YkDerivation *d)
{
    const YkMechanism *mech = d->mech;
    d->bodies = YK_NEW(d->arena, YkDeriveBody, d->model->body_count + 1);
    if (!d->bodies) return false;
    for (size_t k = 0; k < d->model->body_count; k++) {
        int32_t b = mech->tree_order[k];
        YkDeriveBody *body = &d->bodies[b];
        *body = (YkDeriveBody){.name = d->model->bodies[b].name,
                               .parent = mech->tree.parent[b],
                               .joint = mech->tree.joint[b],
                               .angle = YK_NONE,
                               .rate = YK_NONE,
                               .acceleration = YK_NONE};
        if (mech->tree.depth[b] > d->most_depth) d->most_depth = mech->tree.depth[b];
        if (body->parent == YK_NONE) {
            body->unit = body->turn = yk_ring_rational(d->ring, 1, 1);
            body->spin = body->spin_rate = yk_ring_rational(d->ring, 0, 1);
        } else if (!turn_with(d, b)) {
            return false;
        }
    }
    return true;
}

void yk_derive_combination(const YkDerivation *d, int32_t body, int32_t *B)
{
    for (size_t k = 0; k < d->tree_count; k++) B[k] = 0;
    for (; d->bodies[body].parent != YK_NONE; body = d->bodies[body].parent) {
        int32_t c = d->joint_angle[d->bodies[body].joint];
        if (c != YK_NONE) B[c] = sense(d, body);
    }
}

static const YkPoisson *angle_by_parent(YkDerivation *d, const YkPoisson *before, const YkPoisson *step, int32_t body)
{
    return sense(d, body) > 0 ? yk_ring_add(d->ring, before, step) : yk_ring_subtract(d->ring, before, step);
}

// Finds, in joint form, a body's angle (of its axes, outside cos and sin), its spin and the spin's rate from those of
// its parent.
static bool in_joint_form(YkDerivation *d, int32_t body, const YkPoisson *(*forms)[4])
{
    YkRing *ring = d->ring;
    const YkDeriveBody *b = &d->bodies[body];
    const YkPoisson **here = forms[body], **before = forms[b->parent];
    int32_t index = d->joint_angle[b->joint];
    if (index == YK_NONE) {
        const YkExpr *turned = d->model->joints[b->joint].turned_expr;
        const YkPoisson *unit = yk_derive_turn(d, turned);
        if (sense(d, body) < 0) unit = yk_ring_conjugate(ring, unit);
        here[0] = angle_by_parent(d, before[0], yk_derive_expression(d, turned), body);
        here[1] = before[1], here[2] = before[2];
        here[3] = yk_ring_multiply(ring, before[3], unit);
        return here[0] && here[3];
    }
    const YkDeriveCoordinate *c = &d->coordinates[index];
    const YkPoisson *unit = yk_ring_unit(ring, c->position);
    if (sense(d, body) < 0) unit = yk_ring_conjugate(ring, unit);
    here[0] = angle_by_parent(d, before[0], yk_ring_of(ring, c->position), body);
    here[1] = angle_by_parent(d, before[1], yk_ring_of(ring, c->rate), body);
    here[2] = angle_by_parent(d, before[2], yk_ring_of(ring, c->acceleration), body);
    here[3] = yk_ring_multiply(ring, before[3], unit);
    return here[0] && here[1] && here[2] && here[3];
}

// In a chain of n bodies the joint form of all angles has n^2 / 2 terms, so there is a limit.
bool yk_derive_is_long(const YkDerivation *d)
{
    size_t terms = 0;
    for (size_t b = 0; b < d->model->body_count; b++) terms += (size_t)d->bodies[b].joints_in_angle;
    return terms > ANGLE_TERMS_MAX;
}

static bool make_changes(YkDerivation *d)
{
    size_t bodies = d->model->body_count, count = 0;
    if (yk_derive_is_long(d)) return yk_ring_fail(d->ring, YK_RING_SIZE) != NULL;
    const YkPoisson *(*forms)[4] = (const YkPoisson *(*)[4])yk_arena_alloc(d->arena, bodies + 1, sizeof *forms);
    d->change_capacity = d->change_count + 1;
    YkRingChange *changes = YK_NEW(d->arena, YkRingChange, d->change_capacity);
    d->body_angles = YK_NEW(d->arena, const YkPoisson *, bodies + 1);
    if (!forms || !changes || !d->body_angles) return false;
    for (int k = 0; k < 4; k++) forms[0][k] = yk_ring_rational(d->ring, k == 3, 1);
    for (size_t k = 1; k < bodies; k++) {
        int32_t b = d->mech->tree_order[k];
        const YkDeriveBody *body = &d->bodies[b];
        if (!in_joint_form(d, b, forms)) return false;
        int32_t c = d->joint_angle[body->joint];
        if (c == YK_NONE || body->angle == d->coordinates[c].position) continue; // no symbol of its own
        changes[count++] = (YkRingChange){body->angle, forms[b][0], forms[b][3]};
        changes[count++] = (YkRingChange){body->rate, forms[b][1], NULL};
        changes[count++] = (YkRingChange){body->acceleration, forms[b][2], NULL};
    }
    for (size_t b = 0; b < bodies; b++) d->body_angles[b] = forms[b][0];
    d->changes = changes;
    return true;
}

// Notes that memory ran out, unless the ring has refused: its status says why.
static void note_lack(YkDerivation *d)
{
    d->failed |= yk_ring_status(d->ring) == YK_RING_OK;
}

YkRingChanges *yk_derive_to_joints(YkDerivation *d)
{
    if (d->change_count == 0) return NULL;
    if (!d->to_joints && (d->changes || make_changes(d)))
        d->to_joints = yk_ring_changes(d->ring, d->changes, d->change_count);
    if (!d->to_joints) note_lack(d);
    return d->to_joints;
}

const YkPoisson *yk_derive_in_joints(YkDerivation *d, const YkPoisson *a)
{
    if (!a || d->change_count == 0) return a;
    YkRingChanges *changes = yk_derive_to_joints(d);
    return changes ? yk_ring_change(d->ring, a, changes) : NULL;
}

const YkPoisson *yk_derive_body_angle(YkDerivation *d, int32_t body)
{
    if (!d->changes && !make_changes(d)) {
        note_lack(d);
        return NULL;
    }
    return d->body_angles[body];
}

bool yk_derive_define(YkDerivation *d, int32_t symbol, const YkPoisson *meaning)
{
    if (symbol < 0 || !meaning || (!d->changes && !make_changes(d))) return false;
    meaning = yk_derive_in_joints(d, meaning);
    if (!YK_ROOM_IN(d->arena, d->changes, d->change_count, d->change_capacity)) return false;
    d->changes[d->change_count++] = (YkRingChange){symbol, meaning, NULL};
    d->definition_count++;
    d->to_joints = NULL; // must be prepared again
    return meaning != NULL;
}
