// Computes positions: the compiled steps in order, as in solve/run.
#include "program/program.h"

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
    yk_program_set_unit(p, step->target, yk_graph_vec_multiply(g, p->unit[step->parent], e));
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
        yk_program_set_distance(p, r->target.index, value);
    } else {
        yk_program_set_unit(p, r->target.index, yk_graph_unit(g, value));
        keep_angle(p, r, p->unit[r->target.index].x);
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
        yk_program_set_unit(p, step->target, yk_graph_vec_multiply(g, p->unit[step->parent], p->unit[step->other]));
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
        if (p->mech->coordinates[p->mech->inputs[i]].is_distance) // an angle shows it by its sine
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
