// Finds what a batch of forces alone need not compute: directions that no step reads, such as those of most wheels.
#include "batch/inside.h"

static void mark_steps(const YkMechanism *mech, bool *is_read)
{
    for (size_t k = 0; k < mech->step_count; k++) {
        const YkStep *s = &mech->steps[k];
        if (s->kind == YK_STEP_TURN || s->kind == YK_STEP_COMPOSE) is_read[s->parent] = true;
        if (s->kind == YK_STEP_COMPOSE) is_read[s->other] = true;
    }
    for (size_t k = 0; k < mech->term_count; k++) is_read[mech->terms[k].slot] = true;
    for (size_t k = 0; k < mech->block_count; k++)
        for (size_t line = 0; line < 2; line++) is_read[mech->blocks[k].line_slot[line]] = true;
    for (size_t k = 0; k < mech->source_count; k++)
        if (mech->sources[k].kind == YK_SOURCE_SLOT) is_read[mech->sources[k].index] = true;
}

bool yk_batch_find_rates_alone(YkBatch *b)
{
    const YkMechanism *mech = b->mech;
    if (b->is_along || b->needs_state || !b->forces || b->plain_count > 0) return true;
    bool *is_read = YK_NEW(b->arena, bool, mech->slot_count);
    b->rates_alone = YK_NEW(b->arena, bool, mech->slot_count);
    b->idle = YK_NEW(b->arena, bool, mech->slot_count);
    if (yk_arena_failed(b->arena)) return false;
    mark_steps(mech, is_read);
    for (size_t k = 1; k < mech->slot_count; k++) {
        b->rates_alone[k] = !is_read[k] && !yk_lane_forces_need_direction(b->forces->lanes, (int32_t)k);
        b->idle[k] = b->rates_alone[k] && !yk_lane_forces_need_rates(b->forces->lanes, (int32_t)k);
    }
    return true;
}
