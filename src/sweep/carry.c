// Carries an assembly along while the dimensions of the machine change.
#include <yoke/move.h>
#include <stdlib.h>
#include <string.h>
#include "compile/variant.h"
#include "solve/track.h"

// STEP_LEAST: of the path; MOVED_MOST: rad, or lengths over the size.
static const double STEP_LEAST = 0x1p-14, MOVED_MOST = 0.05;

typedef struct Carrier {
    YkState *state;
    YkVariant *variant;
    const double *from, *to; // [parameter]
    double *values, *inputs; // scratch; the inputs at the start: [3 * input + k]
    size_t count;
    const YkMotion *goal;
} Carrier;

static YkStatus stand(Carrier *c, double part)
{
    YkState *s = c->state;
    for (size_t k = 0; k < c->count; k++)
        c->values[k] = part == 1 ? c->to[k] : c->from[k] + part * (c->to[k] - c->from[k]);
    for (size_t i = 0; i < s->mech->input_count; i++) {
        double from = c->inputs[3 * i];
        s->input[3 * i] = part == 1 ? c->goal[i].position : from + part * (c->goal[i].position - from);
        s->input[3 * i + 1] = c->goal[i].velocity;
        s->input[3 * i + 2] = c->goal[i].acceleration;
    }
    YkStatus status = yk_variant_set(c->variant, c->values);
    if (status >= 0) status = s->mech->has_groups ? yk_state_settle(s, MOVED_MOST) : yk_state_solve(s);
    if (status >= 0) yk_state_refer(s);
    return status;
}

static YkStatus carry(Carrier *c)
{
    YkStatus status = YK_OK;
    for (double at = 0, h = 0.125; at < 1;) {
        double next = at + h < 1 ? at + h : 1;
        status = stand(c, next);
        if (yk_state_is_stopped(c->state)) return YK_STOPPED;
        if (status >= 0) {
            at = next;
            yk_pace_reach(c->state->pace, at);
            h = 2 * h;
        } else if ((h *= 0.5) < STEP_LEAST) {
            return status == YK_BAD_MODEL ? status : YK_NO_ASSEMBLY;
        }
    }
    return status;
}

YkStatus yk_state_carry(YkState *s, YkVariant *variant, const double *from, const double *to, size_t count,
                        const YkMotion *goal)
{
    if (!s->has_pose || s->mech != variant->mech) return YK_BAD_ARGUMENT;
    size_t inputs = 3 * s->mech->input_count;
    double *room = calloc(count + inputs + 1, sizeof *room);
    if (!room) return YK_NO_MEMORY;
    memcpy(room + count, s->valid_input, inputs * sizeof *room);
    Carrier c = {s, variant, from, to, room, room + count, count, goal};
    bool is_own = yk_state_begin(s);
    YkStatus status = yk_state_end(s, is_own, carry(&c));
    free(room);
    return status;
}

YkStatus yk_state_take_labels(YkState *to, const YkState *from)
{
    const YkMechanism *a = to->mech, *b = from->mech;
    if (a->block_count != b->block_count || a->has_groups || a->coordinate_count != b->coordinate_count ||
        a->reference_count != b->reference_count)
        return YK_BAD_ARGUMENT;
    for (size_t k = 0; k < a->block_count; k++)
        if (a->blocks[k].kind != b->blocks[k].kind || strcmp(a->blocks[k].label, b->blocks[k].label) != 0)
            return YK_BAD_ARGUMENT;
    memcpy(to->branch, from->branch, a->block_count);
    memcpy(to->slot_reference, from->slot_reference, a->reference_count * sizeof *to->slot_reference);
    for (size_t c = 0; c < a->coordinate_count; c++) to->reference[c] = yk_state_coordinate(from, c).position;
    return YK_OK;
}
