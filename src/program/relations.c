// Relations - gears, racks, belts, cams - and the laws in them: their values and rates.
#include "program/program.h"

// --- values

// unknown: the columns of the group in which the relation is solved, or NULL.
static YkRef source_value(YkProgram *p, const YkRelationSource *source, const YkRef *unknown)
{
    YkGraph *g = &p->graph;
    if (source->kind == YK_SOURCE_INPUT) return p->input[source->index].position;
    if (source->kind == YK_SOURCE_COLUMN) return unknown ? unknown[source->index] : yk_graph_number(g, 0);
    if (source->kind == YK_SOURCE_DISTANCE) return p->distance[source->index];
    YkRefVec e = p->unit[source->index];
    YkRef near = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "c->%s", p->names.near_slot[source->index]));
    return yk_graph_binary(g, YK_VALUE_NEAREST, yk_graph_binary(g, YK_VALUE_ANGLE, e.y, e.x), near);
}

static YkRef sources(YkProgram *p, uint32_t first, uint32_t count, double offset, const YkRef *unknown)
{
    YkGraph *g = &p->graph;
    YkRef sum = yk_graph_number(g, offset);
    for (uint32_t k = first; k < first + count; k++) {
        YkRef factor = yk_graph_number(g, p->mech->sources[k].factor);
        sum = yk_graph_add(g, sum, yk_graph_multiply(g, factor, source_value(p, &p->mech->sources[k], unknown)));
    }
    return sum;
}

int32_t yk_program_law(const YkProgram *p, const YkLaw *law)
{
    for (size_t k = 0; k < p->model->law_count; k++)
        if (p->model->laws[k].law == law) return (int32_t)k;
    return YK_NONE;
}

int32_t yk_program_call_law(YkProgram *p, int32_t law, YkRef argument)
{
    YkRef *arguments = YK_NEW(p->arena, YkRef, 1);
    if (!arguments) return 0;
    *arguments = argument;
    return yk_graph_call(&p->graph, (YkCall){.kind = YK_CALL_LAW,
                                             .index = law,
                                             .arguments = arguments,
                                             .argument_count = 1,
                                             .result_count = 3,
                                             .name = p->names.law[law]});
}

YkRef yk_program_relation(YkProgram *p, size_t index, const YkRef *unknown)
{
    YkGraph *g = &p->graph;
    const YkRelation *r = &p->mech->relations[index];
    YkRef value = sources(p, r->first_source, r->source_count, r->offset, unknown);
    if (!r->law) return value;
    p->argument[index] = sources(p, r->first_argument_source, r->argument_source_count, r->argument_offset, unknown);
    int32_t call = yk_program_call_law(p, yk_program_law(p, r->law), p->argument[index]);
    YkRef gain = yk_graph_number(g, r->gain);
    for (size_t k = 0; k < 2; k++)
        p->slope[2 * index + k] = yk_graph_multiply(g, gain, yk_graph_result(g, call, k + 1));
    return yk_graph_add(g, value, yk_graph_multiply(g, gain, yk_graph_result(g, call, 0)));
}

// --- rates

// Rates of a relation's sources.
static YkRef rate_of_sources(YkProgram *p, uint32_t first, uint32_t count, const YkRef *input, const YkRates *r)
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
    YkRef known = rate_of_sources(p, relation->first_argument_source, relation->argument_source_count, input, r);
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
    YkRef value = rate_of_sources(p, relation->first_source, relation->source_count, input, of);
    if (!relation->law) return value;
    YkRef x = rate_of_sources(p, relation->first_argument_source, relation->argument_source_count, input, of);
    value = yk_graph_add(g, value, yk_graph_multiply(g, p->slope[2 * index], x));
    if (!s) {
        p->argument_rate[index] = x;
        return value;
    }
    YkRef w = p->argument_rate[index];
    return yk_graph_add(g, value, yk_graph_multiply(g, p->slope[2 * index + 1], yk_graph_multiply(g, w, w)));
}
