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

static YkRefVec add_nodes(YkProgram *p, const YkSum *sum, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRefVec total = yk_graph_vec_number(g, 0, 0);
    if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, r->node[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, r->node[sum->minus]);
    return total;
}

static YkRefVec turned(YkProgram *p, size_t index)
{
    return yk_graph_vec_multiply(&p->graph, p->unit[p->mech->terms[index].slot], yk_program_term(p, index));
}

// (d u)' = d' u + d w i u
YkRefVec yk_program_sum_rate(YkProgram *p, const YkSum *sum, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRefVec total = add_nodes(p, sum, r);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec u = turned(p, sum->first + k);
        YkRef across = r->turn[term->slot];
        if (term->distance != YK_NONE) {
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, r->slide[term->distance], u));
            u = yk_graph_vec_scale(g, p->distance[term->distance], u);
        }
        total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, across, yk_graph_vec_quarter(g, u)));
    }
    return total;
}

// (d u)'' = d'' u + 2 d' w i u + d (a i u - w^2 u)
YkRefVec yk_program_sum_accel(YkProgram *p, const YkSum *sum, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    YkRefVec total = add_nodes(p, sum, s);
    for (uint32_t k = 0; k < sum->count; k++) {
        const YkTerm *term = &p->mech->terms[sum->first + k];
        YkRefVec u = turned(p, sum->first + k);
        YkRef w = r->turn[term->slot], a = s->turn[term->slot];
        if (term->distance != YK_NONE) {
            YkRef two = yk_graph_number(g, 2), speed = yk_graph_multiply(g, r->slide[term->distance], w),
                  twice = yk_graph_multiply(g, two, speed);
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, s->slide[term->distance], u));
            total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, twice, yk_graph_vec_quarter(g, u)));
            u = yk_graph_vec_scale(g, p->distance[term->distance], u);
        }
        total = yk_graph_vec_add(g, total, yk_graph_vec_scale(g, a, yk_graph_vec_quarter(g, u)));
        total = yk_graph_vec_subtract(g, total, yk_graph_vec_scale(g, yk_graph_multiply(g, w, w), u));
    }
    return total;
}

// Rates of a relation's sources.
static YkRef sources(YkProgram *p, uint32_t first, uint32_t count, const YkRef *input, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRef sum = yk_graph_number(g, 0);
    for (uint32_t k = first; k < first + count; k++) {
        const YkRelationSource *s = &p->mech->sources[k];
        YkRef rate = s->kind == YK_SOURCE_INPUT      ? input[s->index]
                     : s->kind == YK_SOURCE_COLUMN   ? yk_graph_number(g, 0) // known apart
                     : s->kind == YK_SOURCE_DISTANCE ? r->slide[s->index]
                                                     : r->turn[s->index];
        sum = yk_graph_add(g, sum, yk_graph_multiply(g, yk_graph_number(g, s->factor), rate));
    }
    return sum;
}

// Adds to the rate of a relation's argument the part of its group's unknowns, if it is solved in a group.
static YkRef columns_rate(YkProgram *p, const YkBlock *b, const YkRelation *relation, const YkRates *r)
{
    YkGraph *g = &p->graph;
    YkRef sum = yk_graph_number(g, 0);
    for (uint32_t k = 0; k < relation->argument_source_count; k++) {
        const YkRelationSource *s = &p->mech->sources[relation->first_argument_source + k];
        if (s->kind != YK_SOURCE_COLUMN) continue;
        const YkColumn *c = &p->mech->group_columns[b->first_column + (uint32_t)s->index];
        YkRef rate = c->is_distance ? r->slide[c->index] : r->turn[c->index];
        sum = yk_graph_add(g, sum, yk_graph_multiply(g, yk_graph_number(g, s->factor), rate));
    }
    return sum;
}

void yk_program_group_arguments(YkProgram *p, const YkBlock *b, const YkRates *r)
{
    for (uint32_t k = 0; k < b->relation_count; k++) {
        size_t index = (size_t)p->mech->group_relations[b->first_relation + k];
        if (!p->mech->relations[index].law) continue;
        YkRef own = columns_rate(p, b, &p->mech->relations[index], r);
        p->argument_rate[index] = yk_graph_add(&p->graph, p->argument_rate[index], own);
    }
}

static const YkBlock *group_of(const YkMechanism *mech, size_t relation)
{
    for (size_t b = 0; b < mech->block_count; b++)
        for (uint32_t k = 0; k < mech->blocks[b].relation_count && mech->blocks[b].kind == YK_BLOCK_GROUP; k++)
            if (mech->group_relations[mech->blocks[b].first_relation + k] == (int32_t)relation) return &mech->blocks[b];
    return NULL;
}

YkRef yk_program_argument_rate(YkProgram *p, size_t index, const YkRates *r)
{
    const YkRelation *relation = &p->mech->relations[index];
    YkRef *input = YK_NEW(p->arena, YkRef, p->mech->input_count + 1);
    if (!input) {
        p->failed = true;
        return 0;
    }
    for (size_t i = 0; i < p->mech->input_count; i++) input[i] = p->input[i].velocity;
    YkRef known = sources(p, relation->first_argument_source, relation->argument_source_count, input, r);
    const YkBlock *group = group_of(p->mech, index);
    return group ? yk_graph_add(&p->graph, known, columns_rate(p, group, relation, r)) : known;
}

// value' = sources' + f' x', value'' = sources'' + f' x'' + f'' x'^2; r: first derivatives, if s are second ones.
YkRef yk_program_relation_rate(YkProgram *p, size_t index, const YkRates *r, const YkRates *s)
{
    YkGraph *g = &p->graph;
    const YkRelation *relation = &p->mech->relations[index];
    const YkRates *of = s ? s : r;
    const YkRef *input = p->input_rates;
    YkRef value = sources(p, relation->first_source, relation->source_count, input, of);
    if (!relation->law) return value;
    YkRef x = sources(p, relation->first_argument_source, relation->argument_source_count, input, of);
    value = yk_graph_add(g, value, yk_graph_multiply(g, p->slope[2 * index], x));
    if (!s) {
        p->argument_rate[index] = x;
        return value;
    }
    YkRef w = p->argument_rate[index];
    return yk_graph_add(g, value, yk_graph_multiply(g, p->slope[2 * index + 1], yk_graph_multiply(g, w, w)));
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
