// Creates the program of a mechanism, and makes its constants and texts.
#include "program/program.h"
#include "elementary/elementary.h"
#include <math.h>

bool yk_program_start(YkProgram *p, const YkMechanism *mech, const YkRecipe *recipe, YkArena *arena,
                      YkProblems *problems)
{
    const YkModel *m = mech->model;
    size_t relations = mech->relation_count + mech->derived_count + 1;
    *p = (YkProgram){.arena = arena, .model = m, .mech = mech, .recipe = recipe, .problems = problems};
    p->parameter = YK_NEW(arena, YkRef, m->parameter_count + 1);
    p->is_fixed = YK_NEW(arena, bool, m->parameter_count + 1);
    p->turn = YK_NEW(arena, YkRef, m->body_count);
    p->turn_unit = YK_NEW(arena, YkRefVec, m->body_count);
    p->unit = YK_NEW(arena, YkRefVec, mech->slot_count + 1);
    p->distance = YK_NEW(arena, YkRef, mech->distance_count + 1);
    p->node = YK_NEW(arena, YkRefVec, mech->node_count + 1);
    p->placed = YK_NEW(arena, YkPlaced, mech->block_count + 1);
    p->input = YK_NEW(arena, YkMotionRef, mech->input_count + 1);
    p->argument = YK_NEW(arena, YkRef, relations);
    p->argument_rate = YK_NEW(arena, YkRef, relations);
    p->slope = YK_NEW(arena, YkRef, 2 * relations);
    if (yk_arena_failed(arena) || !yk_graph_start(&p->graph, arena)) return false;
    p->time = yk_graph_leaf(&p->graph, YK_LEAF_POSE, "in->t");
    return true;
}

void yk_program_end(YkProgram *p)
{
    yk_graph_end(&p->graph);
}

double yk_program_size(const YkProgram *p)
{
    return yk_exp2(rint(yk_log2(p->mech->size)));
}

double yk_program_block_size(const YkProgram *p, const YkBlock *block)
{
    return yk_exp2(rint(yk_log2(yk_block_size(p->mech, block))));
}
