// Gears: their centres on the carrier, the pitch point between them, the line of action through it.
#include <stdlib.h>
#include "derive/forces/meshes.h"
#include "derive/inside.h"

// Continues from `body`, on which the axis is `at`. Returns false if the carrier is not on the way.
static bool follow_axis(YkMeshAxis *axis, int32_t body, const YkPoisson *at)
{
    const YkModel *model = axis->m->d->model;
    axis->seen[body] = true;
    axis->at = at;
    if (body == axis->carrier) return true;
    for (size_t j = 0; j < model->joint_count; j++)
        for (int side = 0; side < 2; side++) {
            const YkJoint *joint = &model->joints[j];
            bool is_axial = joint->kind == YK_PIN || joint->kind == YK_WELD;
            if (!is_axial || joint->body[side] != body || axis->seen[joint->body[!side]]) continue;
            if (!yk_ring_is_same(yk_mesh_at(axis->m, (int32_t)j, side), at)) continue;
            axis->held.holders[axis->held.count++] = (YkDeriveHolder){(int32_t)j, side};
            if (follow_axis(axis, joint->body[!side], yk_mesh_at(axis->m, (int32_t)j, !side))) return true;
            axis->held.count--;
        }
    return false;
}

// `at` is NULL if the axis cannot be followed in symbols.
YkMeshAxis yk_mesh_axis(YkMeshMaking *m, int32_t wheel, int32_t carrier)
{
    size_t bodies = m->d->model->body_count;
    YkMeshAxis axis = {.m = m, .carrier = carrier, .seen = yk_derive_scratch(m->d, bodies, sizeof *axis.seen)};
    axis.held.holders = YK_NEW(m->d->arena, YkDeriveHolder, bodies + 1);
    if (!axis.seen || !axis.held.holders)
        m->d->failed = true;
    else if (!follow_axis(&axis, wheel, yk_ring_rational(m->ring, 0, 1)))
        axis.at = NULL;
    if (m->d->failed) axis.at = NULL;
    free(axis.seen);
    axis.seen = NULL;
    return axis;
}

// Returns the vector from the first centre to the second in the carrier's axes: by the carrier's own points, otherwise
// as the tree places them.
static const YkPoisson *line_of_centers(YkMeshMaking *m, const YkGear *gear, const YkMeshAxis axes[2])
{
    YkRing *ring = m->ring;
    YkDerivation *d = m->d;
    if (axes[0].at && axes[1].at) return yk_ring_subtract(ring, axes[1].at, axes[0].at);
    const YkPoisson *second = yk_derive_origin(d, gear->body[1]), *first = yk_derive_origin(d, gear->body[0]);
    const YkPoisson *line = yk_ring_subtract(ring, second, first);
    return yk_ring_multiply(ring, yk_ring_conjugate(ring, d->bodies[gear->carrier].unit), line);
}

static double constant_value(YkDerivation *d, const YkPoisson *a)
{
    double *values = yk_derive_scratch(d, yk_ring_symbol_count(d->ring) + 64, sizeof *values);
    if (!values) {
        d->failed = true;
        return 0;
    }
    for (size_t k = 0; k < d->model->parameter_count; k++)
        if (d->parameters[k] >= 0) values[d->parameters[k]] = d->model->parameters[k].value;
    for (size_t k = 0; k < d->constant_count; k++) values[d->constants[k].symbol] = d->constants[k].value;
    yk_ring_complete(d->ring, values);
    double value = a ? yk_ring_value(d->ring, a, values).x : 0;
    free(values);
    return value;
}

// Finds length * direction = vector, length > 0: exact along an axis, otherwise a root.
static const YkPoisson *length_of(YkMeshMaking *m, const YkPoisson *vector, const YkPoisson **direction)
{
    YkRing *ring = m->ring;
    for (int quarter = 0; quarter < 2; quarter++) {
        const YkPoisson *back = quarter ? yk_ring_negate(ring, yk_ring_i(ring)) : yk_ring_rational(ring, 1, 1);
        const YkPoisson *along = yk_ring_multiply(ring, back, vector);
        if (!along || !yk_ring_is_real(ring, along)) continue;
        int sign = constant_value(m->d, along) < 0 ? -1 : 1;
        *direction = yk_ring_scale(ring, yk_ring_conjugate(ring, back), sign, 1);
        return yk_ring_scale(ring, along, sign, 1);
    }
    const YkPoisson *length = yk_derive_root(m->f, yk_derive_text(m->d, "c_", m->tie->name, ""),
                                             "distance of the centres", yk_ring_dot(ring, vector, vector));
    *direction = yk_ring_divide(ring, vector, length);
    return length;
}

// Returns the direction of the push on the second wheel against that of the line of centres: across it, turned by the
// pressure angle.
static const YkPoisson *line_of_action(YkMeshMaking *m, const YkGear *gear)
{
    YkRing *ring = m->ring;
    m->mesh->lean = yk_derive_angle(m->d, yk_derive_force_name(m->f, "alpha", m->between, ""));
    m->mesh->lean_value = gear->pressure_angle;
    if (m->mesh->lean < 0) return NULL;
    const YkPoisson *lean = yk_ring_unit(ring, m->mesh->lean);
    if (!gear->is_internal) lean = yk_ring_conjugate(ring, lean);
    return yk_ring_multiply(ring, yk_ring_i(ring), lean);
}

// Adds the force of the teeth of all equal planets on the one in the file, its opposite on the carrier's axis, and
// their couple on the wheel about that axis. The carrier touches no teeth: its force is told as one of the gears, as
// the couple is, and the planet's as the wheel's.
static void push_planets(YkMeshMaking *m, const YkGear *gear, const YkMeshAxis axes[2], const YkPoisson *arm[2],
                         const YkPoisson *force)
{
    YkRing *ring = m->ring;
    int k = gear->planet;
    int32_t wheel = gear->body[!k], bodies[2] = {gear->body[0], gear->body[1]};
    const YkPoisson *lever = yk_ring_subtract(ring, arm[!k], yk_mesh_center(m, wheel));
    const YkPoisson *couple = yk_ring_cross(ring, lever, force);
    YkMeshHeld held[2] = {{NULL, 0}, {NULL, 0}};
    const YkPoisson *at[2] = {arm[0], arm[1]};
    at[!k] = yk_mesh_arm(m, gear->carrier, yk_derive_origin(m->d, wheel));
    bodies[!k] = gear->carrier;
    held[k] = axes[k].held;
    m->by[k] = m->d->model->bodies[wheel].name;
    m->by[!k] = m->tie->name;
    yk_mesh_couple(m, wheel, yk_ring_scale(ring, yk_ring_coefficient(ring, couple, m->mesh->symbol, 1), k ? -1 : 1, 1));
    yk_mesh_force(m, "N", bodies, held, at, force);
}

// Returns what the unknown is, for its legend.
static const char *force_in_words(YkMeshMaking *m, const YkGear *gear)
{
    bool is_shared = gear->copies > 1;
    return yk_derive_text(
        m->d,
        is_shared ? "the sum of the forces that the teeth of all equal planets exert, turned to pitch point "
                  : "the force between these gears at their pitch point ",
        m->point,
        is_shared ? ", along the line of action; the forces of the planets' pins are such sums too, and "
                    "the carrier takes the opposite of both, of which a couple remains"
                  : ", along their line of action");
}

void yk_mesh_gear(YkMeshMaking *m, const YkRelation *of)
{
    const YkGear *gear = &m->d->model->gears[of->index];
    YkRing *ring = m->ring;
    const YkPoisson *a = yk_derive_expression(m->d, gear->teeth_expr[0]),
                    *b = yk_derive_expression(m->d, gear->teeth_expr[1]);
    if (gear->is_internal) b = yk_ring_negate(ring, b);
    if (!(gear->center_distance > 0)) {
        yk_mesh_unknown(m, "T", gear->body, "the couple on a wheel of these gears, for each of its teeth");
        yk_mesh_couples(m, gear->body, gear->carrier, a, b);
        m->mesh->effort = m->unknown;
        return;
    }
    m->point = yk_derive_pitch_name(m->d, (size_t)of->index);
    yk_mesh_unknown(m, "N", gear->body, force_in_words(m, gear));
    YkMeshAxis axes[2];
    for (int k = 0; k < 2; k++) axes[k] = yk_mesh_axis(m, gear->body[k], gear->carrier);
    const YkPoisson *direction, *distance = length_of(m, line_of_centers(m, gear, axes), &direction);
    int sign = gear->is_internal ? -1 : 1; // of a + b
    const YkPoisson *sum = yk_ring_scale(ring, yk_ring_add(ring, a, b), sign, 1);
    // Half the module: pitch radii over teeth.
    const YkPoisson *half = yk_derive_ratio(m->f, yk_derive_text(m->d, "r_", m->tie->name, ""),
                                            "pitch radius of these gears over the number of teeth", distance, sum);
    const YkPoisson *line = yk_ring_multiply(ring, m->d->bodies[gear->carrier].unit, direction);
    const YkPoisson *action = line_of_action(m, gear);
    const YkPoisson *across = yk_ring_imaginary(ring, action), *arm[2];
    for (int k = 0; k < 2; k++) {
        const YkPoisson *radius = yk_ring_multiply(ring, k ? b : a, half);
        radius = yk_ring_scale(ring, radius, k ? -sign : sign, 1);
        arm[k] = yk_ring_add(ring, yk_mesh_center(m, gear->body[k]), yk_ring_multiply(ring, radius, line));
    }
    const YkPoisson *force = yk_ring_product(ring, (const YkPoisson *[]){m->unknown, line, action}, 3);
    if (yk_gear_is_about_axis(gear))
        push_planets(m, gear, axes, arm, force);
    else
        yk_mesh_force(m, "N", gear->body, (YkMeshHeld[]){axes[0].held, axes[1].held}, arm, force);
    const YkPoisson *lever = yk_ring_scale(ring, yk_ring_multiply(ring, half, across), -sign, 1);
    m->mesh->effort = yk_ring_multiply(ring, lever, m->unknown);
}
