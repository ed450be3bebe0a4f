// Numbers for the symbols: from the file, and from a pose of the numeric engine.
#include <stdlib.h>
#include "derive/inside.h"

static void set(double *values, int32_t symbol, double value)
{
    if (symbol >= 0) values[symbol] = value;
}

static YkMotion closing_distance(const YkDerivation *d, const YkDeriveCoordinate *c, const YkState *state)
{
    YkChannel channel = {.kind = YK_CHANNEL_JOINT_DISTANCE, .index = c->joint, .quantity = YK_QUANTITY_LENGTH};
    YkMotion motion;
    (void)d;
    motion.position = yk_state_channel(state, channel);
    channel.order = 1;
    motion.velocity = yk_state_channel(state, channel);
    channel.order = 2;
    motion.acceleration = yk_state_channel(state, channel);
    return motion;
}

static void fill_coordinates(const YkDerivation *d, const YkState *state, double *values)
{
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        YkMotion motion = c->in_tree ? yk_state_coordinate(state, k) : closing_distance(d, c, state);
        set(values, c->position, motion.position);
        set(values, c->rate, motion.velocity);
        set(values, c->acceleration, motion.acceleration);
    }
}

// A body's own angle is that of the first body of its orientation, against which its axes do not turn.
static void fill_bodies(YkDerivation *d, const YkState *state, double *values)
{
    YkMotion *motions = yk_derive_scratch(d, d->model->body_count, sizeof *motions);
    if (!motions) return;
    yk_state_bodies(state, motions);
    for (size_t b = yk_model_body_count(d->model); b < d->model->body_count; b++) motions[b] = yk_state_body(state, b);
    for (size_t b = 0; b < d->model->body_count; b++) {
        const YkDeriveBody *body = &d->bodies[b];
        if (body->joint == YK_NONE || d->joint_angle[body->joint] == YK_NONE) continue;
        set(values, body->angle, motions[b].position);
        set(values, body->rate, motions[b].velocity);
        set(values, body->acceleration, motions[b].acceleration);
    }
    free(motions);
}

void yk_derive_values(YkDerivation *d, const YkState *state, YkDynamics *dynamics, double *values)
{
    for (size_t s = 0; s < yk_ring_symbol_count(d->ring); s++) values[s] = 0;
    set(values, d->time, yk_state_time(state));
    for (size_t k = 0; k < d->model->parameter_count; k++) set(values, d->parameters[k], d->model->parameters[k].value);
    for (size_t k = 0; k < d->constant_count; k++) set(values, d->constants[k].symbol, d->constants[k].value);
    fill_bodies(d, state, values);
    fill_coordinates(d, state, values); // a body's angle may be a coordinate: the same number
    for (size_t k = 0; k < d->source_count && yk_derivation_is_well(d); k++) // otherwise symbols may be missing
        d->sources[k].fill(d->sources[k].context, state, dynamics, values);
    yk_ring_complete(d->ring, values);
    for (size_t k = d->change_count - d->definition_count; k < d->change_count; k++)
        set(values, d->changes[k].symbol, yk_ring_value(d->ring, d->changes[k].value, values).x);
    if (d->definition_count > 0) yk_ring_complete(d->ring, values); // roots of what was defined
}

const YkPoisson *yk_derive_fraction(YkDerivation *d, const YkFraction *a)
{
    const YkWhole *parts[] = {&a->over, &a->under};
    int64_t whole[] = {0, 1};
    for (int k = 0; k < 2; k++) {
        const YkWhole *part = parts[k];
        if (part->count > 2 || (part->count == 2 && part->limb[1] >= 0x80000000u)) return NULL;
        if (part->count > 0) whole[k] = (int64_t)part->limb[0];
        if (part->count > 1) whole[k] |= (int64_t)part->limb[1] << 32;
    }
    return yk_ring_rational(d->ring, a->is_negative ? -whole[0] : whole[0], whole[1]);
}

bool yk_derive_add_source(YkDerivation *d, YkDeriveSource fill, void *context)
{
    if (!YK_ROOM(d->sources, d->source_count, d->source_capacity)) {
        d->failed = true;
        return false;
    }
    d->sources[d->source_count].fill = fill;
    d->sources[d->source_count++].context = context;
    return true;
}

bool yk_derive_add_relation(YkDerivation *d, const YkPoisson *zero)
{
    if (!zero || !YK_ROOM(d->relations, d->relation_count, d->relation_capacity)) {
        d->failed = d->failed || zero;
        return false;
    }
    d->relations[d->relation_count++] = zero;
    return true;
}

bool yk_derive_add_unknown(YkDerivation *d, int32_t symbol)
{
    if (!YK_ROOM(d->unknowns, d->unknown_count, d->unknown_capacity)) {
        d->failed = true;
        return false;
    }
    d->unknowns[d->unknown_count++] = symbol;
    return true;
}
