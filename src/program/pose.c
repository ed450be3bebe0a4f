// Computes positions: the compiled steps in order, as in solve/run.
#include "program/program.h"

// Returns a term's vector in the world without its distance, and that distance (-1: none).
static YkRefVec turned(YkProgram *p, size_t index)
{
    const YkTerm *term = &p->mech->terms[index];
    return yk_graph_vec_multiply(&p->graph, p->unit[term->slot], yk_program_term(p, index));
}

YkRefVec yk_program_sum(YkProgram *p, const YkSum *sum)
{
    YkGraph *g = &p->graph;
    YkRefVec total = yk_program_constant(p, sum); // the constant comes after the terms
    if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, p->node[sum->plus]);
    if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, p->node[sum->minus]);
    for (uint32_t k = 0; k < sum->count; k++) {
        int32_t distance = p->mech->terms[sum->first + k].distance;
        YkRefVec u = turned(p, sum->first + k);
        total = yk_graph_vec_add(g, total, distance == YK_NONE ? u : yk_graph_vec_scale(g, p->distance[distance], u));
    }
    return total;
}

static void name_unit(YkProgram *p, int32_t slot)
{
    const char *name = yk_program_slot_name(p, slot);
    yk_graph_name(&p->graph, p->unit[slot].x, "%s_c", name);
    yk_graph_name(&p->graph, p->unit[slot].y, "%s_s", name);
}

// Turns by sign (q + offset); the offset is minus the joint's.
YkRefVec yk_program_turn(YkProgram *p, const YkStep *step)
{
    YkGraph *g = &p->graph;
    int32_t joint = p->mech->coordinates[p->mech->inputs[step->input]].joint;
    YkRef angle = yk_graph_subtract(g, p->input[step->input].position, yk_program_joint_offset(p, joint));
    return yk_graph_unit(g, step->sign < 0 ? yk_graph_minus(g, angle) : angle);
}

// Sets slot = parent turned.
static void run_turn(YkProgram *p, const YkStep *step)
{
    YkGraph *g = &p->graph;
    const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[step->input]];
    yk_graph_section(g, yk_graph_text(&p->graph, "%s turns by %s.", yk_program_slot_name(p, step->target), c->name));
    YkRefVec e = yk_program_turn(p, step);
    p->witness = yk_graph_add(g, p->witness, yk_graph_unary(g, YK_VALUE_WITNESS, e.x)); // NaN if it is too large
    p->unit[step->target] = yk_graph_vec_multiply(g, p->unit[step->parent], e);
    name_unit(p, step->target);
}

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

static bool are_inputs(const YkProgram *p, uint32_t first, uint32_t count)
{
    for (uint32_t k = first; k < first + count; k++)
        if (p->mech->sources[k].kind != YK_SOURCE_INPUT) return false;
    return true;
}

// An angle that is too large has no sine; the inputs are at fault if it depends only on them.
static void keep_angle(YkProgram *p, const YkRelation *r, YkRef sine)
{
    YkGraph *g = &p->graph;
    bool by_inputs = are_inputs(p, r->first_source, r->source_count) &&
                     (!r->law || are_inputs(p, r->first_argument_source, r->argument_source_count));
    YkRef *kept = by_inputs ? &p->witness : &p->angles;
    *kept = yk_graph_add(g, *kept, yk_graph_unary(g, YK_VALUE_WITNESS, sine));
}

static void run_relation(YkProgram *p, size_t index)
{
    YkGraph *g = &p->graph;
    const YkRelation *r = &p->mech->relations[index];
    static const char *const kinds[] = {"gears", "rack", "belt", "cam", "law"};
    yk_graph_section(g, yk_graph_text(&p->graph, "%s (%s) ties what it joins.", r->name, kinds[r->kind]));
    YkRef value = yk_program_relation(p, index, NULL);
    if (r->target.is_distance) {
        p->distance[r->target.index] = yk_graph_name(g, value, "%s", yk_program_distance_name(p, r->target.index));
    } else {
        p->unit[r->target.index] = yk_graph_unit(g, value);
        keep_angle(p, r, p->unit[r->target.index].x);
        name_unit(p, r->target.index);
    }
}

static void run_step(YkProgram *p, const YkStep *step)
{
    YkGraph *g = &p->graph;
    switch (step->kind) {
    case YK_STEP_TURN:
        run_turn(p, step);
        break;
    case YK_STEP_COMPOSE:
        yk_graph_section(g, yk_graph_text(&p->graph, "%s turns with the body that it is tied to.",
                                          yk_program_slot_name(p, step->target)));
        p->unit[step->target] = yk_graph_vec_multiply(g, p->unit[step->parent], p->unit[step->other]);
        name_unit(p, step->target);
        break;
    case YK_STEP_DISTANCE:
        p->distance[step->target] = p->input[step->input].position;
        break;
    case YK_STEP_NODE:
        yk_graph_section(g, "A place to which several bodies are attached.");
        p->node[step->target] = yk_program_sum(p, &p->mech->node_sums[step->target]);
        yk_graph_name(g, p->node[step->target].x, "place%d_x", (int)step->target + 1);
        yk_graph_name(g, p->node[step->target].y, "place%d_y", (int)step->target + 1);
        break;
    case YK_STEP_BLOCK:
        yk_program_place(p, (size_t)step->target);
        break;
    case YK_STEP_RELATION:
        run_relation(p, (size_t)step->target);
        break;
    case YK_STEP_CHECK:
        yk_program_keep_gap(p, yk_graph_unary(g, YK_VALUE_SIZE, yk_program_relation(p, (size_t)step->target, NULL)));
        break;
    }
}

static void start_inputs(YkProgram *p)
{
    YkGraph *g = &p->graph;
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const char *name = p->names.coordinate[p->mech->inputs[i]];
        p->input[i].position = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "in->%s", name));
        p->input[i].velocity = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "in->%s_rate", name));
        p->input[i].acceleration = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "in->%s_accel", name));
        if (p->mech->coordinates[p->mech->inputs[i]].is_distance) // an angle's sine tells
            p->witness = yk_graph_add(g, p->witness, yk_graph_unary(g, YK_VALUE_WITNESS, p->input[i].position));
    }
}

void yk_program_pose(YkProgram *p)
{
    YkGraph *g = &p->graph;
    p->unit[0] = yk_graph_vec_number(g, 1, 0);
    p->margin = yk_graph_number(g, 1);
    p->gap = p->missed = p->witness = p->angles = yk_graph_number(g, 0);
    start_inputs(p);
    for (size_t k = 0; k < p->mech->step_count && !p->failed; k++) run_step(p, &p->mech->steps[k]);
}
