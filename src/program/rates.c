// Computes velocities and accelerations: the same steps, differentiated.
#include "program/program.h"

YkRates yk_program_new_rates(YkProgram *p)
{
    const YkMechanism *mech = p->mech;
    YkRef zero = yk_graph_number(&p->graph, 0);
    YkRates r = {YK_NEW(p->arena, YkRef, mech->slot_count + 1), YK_NEW(p->arena, YkRef, mech->distance_count + 1),
                 YK_NEW(p->arena, YkRefVec, mech->node_count + 1)};
    if (yk_arena_failed(p->arena)) {
        p->failed = true;
        return r;
    }
    for (size_t k = 0; k <= mech->slot_count; k++) r.turn[k] = zero;
    for (size_t k = 0; k <= mech->distance_count; k++) r.slide[k] = zero;
    for (size_t k = 0; k <= mech->node_count; k++) r.node[k] = (YkRefVec){zero, zero};
    return r;
}

static void run_relation(YkProgram *p, size_t index, const YkRates *r, YkRates *s)
{
    YkRelationTerm target = p->mech->relations[index].target;
    YkRef value = yk_program_relation_rate(p, index, r ? r : s, r ? s : NULL);
    *(target.is_distance ? &s->slide[target.index] : &s->turn[target.index]) = value;
}

static void name_rates(YkProgram *p, const YkStep *step, const YkRates *s, const char *ending)
{
    YkGraph *g = &p->graph;
    if (step->kind != YK_STEP_BLOCK) return;
    const YkBlock *b = &p->mech->blocks[step->target];
    for (uint32_t k = 0; k < b->column_count; k++) {
        YkColumn c = b->kind == YK_BLOCK_GROUP ? p->mech->group_columns[b->first_column + k] : b->column[k];
        YkRef value = c.is_distance ? s->slide[c.index] : s->turn[c.index];
        const char *name = c.is_distance ? yk_program_distance_name(p, c.index) : yk_program_slot_name(p, c.index);
        yk_graph_name(g, value, "%s_%s", name, ending);
    }
}

// r: the first derivatives, if s are the second; otherwise NULL.
static void run_step(YkProgram *p, const YkStep *step, const YkRef *input, YkRates *r, YkRates *s)
{
    YkGraph *g = &p->graph;
    switch (step->kind) {
    case YK_STEP_TURN: {
        YkRef change = step->sign < 0 ? yk_graph_minus(g, input[step->input]) : input[step->input];
        s->turn[step->target] = yk_graph_add(g, s->turn[step->parent], change);
        break;
    }
    case YK_STEP_COMPOSE:
        s->turn[step->target] = yk_graph_add(g, s->turn[step->parent], s->turn[step->other]);
        break;
    case YK_STEP_DISTANCE:
        s->slide[step->target] = input[step->input];
        break;
    case YK_STEP_NODE: {
        const YkSum *sum = &p->mech->node_sums[step->target];
        s->node[step->target] = r ? yk_program_sum_accel(p, sum, r, s) : yk_program_sum_rate(p, sum, s);
        break;
    }
    case YK_STEP_BLOCK:
        yk_program_block_rates(p, (size_t)step->target, r ? r : s, r ? s : NULL);
        break;
    case YK_STEP_RELATION:
        run_relation(p, (size_t)step->target, r, s);
        break;
    case YK_STEP_CHECK:
        break;
    }
    name_rates(p, step, s, r ? "a" : "w");
}

// Returns whether all sources of a relation are sums of inputs: of turns, then of slides.
static bool are_linear(const YkMechanism *mech, const YkRelation *r, const bool *turns, const bool *slides)
{
    for (uint32_t k = r->first_source; k < r->first_source + r->source_count; k++) {
        const YkRelationSource *s = &mech->sources[k];
        bool is_known = s->kind == YK_SOURCE_INPUT || (s->kind == YK_SOURCE_SLOT && turns[s->index]) ||
                        (s->kind == YK_SOURCE_DISTANCE && slides[s->index]);
        if (!is_known) return false;
    }
    return !r->law;
}

// Returns where a step notes that its rates are sums of those of the inputs; NULL if they are not.
static bool *linear_place(const YkMechanism *mech, const YkStep *step, bool *turns, bool *slides)
{
    if (step->kind == YK_STEP_TURN) return turns[step->parent] ? &turns[step->target] : NULL;
    if (step->kind == YK_STEP_COMPOSE) return turns[step->parent] && turns[step->other] ? &turns[step->target] : NULL;
    if (step->kind == YK_STEP_DISTANCE) return &slides[step->target];
    if (step->kind != YK_STEP_RELATION) return NULL;
    const YkRelation *r = &mech->relations[step->target];
    if (!are_linear(mech, r, turns, slides)) return NULL;
    return r->target.is_distance ? &slides[r->target.index] : &turns[r->target.index];
}

void yk_program_linear_rates(YkProgram *p, const YkRef *input_rates, YkRates *s)
{
    const YkMechanism *mech = p->mech;
    bool *turns = YK_NEW(p->arena, bool, mech->slot_count + mech->distance_count + 2), *slides;
    if (!turns) {
        p->failed = true;
        return;
    }
    slides = turns + mech->slot_count + 1;
    turns[0] = true;
    p->input_rates = input_rates;
    for (size_t k = 0; k < mech->step_count; k++) {
        bool *place = linear_place(mech, &mech->steps[k], turns, slides);
        if (!place) continue;
        *place = true;
        run_step(p, &mech->steps[k], input_rates, NULL, s);
    }
}

YkRates yk_program_velocities(YkProgram *p, const YkRef *input_rates)
{
    YkRates r = yk_program_new_rates(p);
    p->input_rates = input_rates;
    yk_graph_section(&p->graph, "Velocities, block by block from the same determinants.");
    for (size_t k = 0; k < p->mech->step_count && !p->failed; k++)
        run_step(p, &p->mech->steps[k], input_rates, NULL, &r);
    return r;
}

YkRates yk_program_accelerations(YkProgram *p, const YkRates *velocities, const YkRef *input_accelerations)
{
    YkRates s = yk_program_new_rates(p), r = *velocities;
    p->input_rates = input_accelerations;
    yk_graph_section(&p->graph, "Accelerations, likewise.");
    for (size_t k = 0; k < p->mech->step_count && !p->failed; k++)
        run_step(p, &p->mech->steps[k], input_accelerations, &r, &s);
    return s;
}
