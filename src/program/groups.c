// Computes a group: its loops and relations as residual and Jacobian, and the call of Newton's method.
#include "program/blocks.h"
#include "base/problems.h"

static int find_column(const YkProgram *p, const YkBlock *b, bool is_distance, int32_t index)
{
    for (uint32_t k = 0; k < b->column_count; k++) {
        const YkColumn *c = &p->mech->group_columns[b->first_column + k];
        if (c->is_distance == is_distance && c->index == index) return (int)k;
    }
    return -1;
}

// Adds the unknowns among some sources to a row of the Jacobian, times a factor.
static void enter_sources(YkProgram *p, uint32_t first, uint32_t count, YkRef factor, YkRef *row)
{
    YkGraph *g = &p->graph;
    for (uint32_t i = first; i < first + count; i++) {
        const YkRelationSource *source = &p->mech->sources[i];
        if (source->kind != YK_SOURCE_COLUMN) continue;
        YkRef part = yk_graph_multiply(g, yk_graph_number(g, source->factor), factor);
        row[source->index] = yk_graph_add(g, row[source->index], part);
    }
}

// Evaluates the rows of gears, racks, belts, cams and laws, which follow those of the loops.
static void evaluate_relations(YkProgram *p, const YkBlock *b, const YkRef *x, YkRef *residual, YkRef *jacobian)
{
    for (uint32_t k = 0; k < b->relation_count; k++) {
        size_t row = 2 * (size_t)b->loop_count + k, index = (size_t)p->mech->group_relations[b->first_relation + k];
        const YkRelation *r = &p->mech->relations[index];
        YkRef *entries = &jacobian[row * b->column_count];
        residual[row] = yk_program_relation(p, index, x);
        enter_sources(p, r->first_source, r->source_count, yk_graph_number(&p->graph, 1), entries);
        if (r->law) enter_sources(p, r->first_argument_source, r->argument_source_count, p->slope[2 * index], entries);
    }
}

// Evaluates residual and Jacobian of all loops of the group at unknowns x[column], as solve/group does.
static void evaluate(YkProgram *p, const YkBlock *b, const YkRef *x, YkRef *residual, YkRef *jacobian)
{
    YkGraph *g = &p->graph;
    size_t n = b->column_count;
    for (size_t k = 0; k < yk_block_rows(b) * n; k++) jacobian[k] = yk_graph_number(g, 0);
    evaluate_relations(p, b, x, residual, jacobian);
    for (uint32_t l = 0; l < b->loop_count; l++) {
        const YkSum *sum = &p->mech->group_loops[b->first_loop + l];
        YkRefVec total = yk_program_constant(p, sum);
        YkRef *rows = jacobian + 2 * l * n;
        if (sum->plus != YK_NONE) total = yk_graph_vec_add(g, total, p->node[sum->plus]);
        if (sum->minus != YK_NONE) total = yk_graph_vec_subtract(g, total, p->node[sum->minus]);
        for (uint32_t k = 0; k < sum->count; k++) {
            const YkTerm *term = &p->mech->terms[sum->first + k];
            int turn = find_column(p, b, false, p->mech->group_root[term->slot]), slide = -1;
            if (term->slot == 0) turn = -1;
            YkRefVec e = p->unit[turn < 0 ? term->slot : p->mech->relative_slot[term->slot]];
            if (turn >= 0) e = yk_graph_vec_multiply(g, e, yk_graph_unit(g, x[turn]));
            YkRefVec v = yk_graph_vec_multiply(g, e, yk_program_term(p, sum->first + k));
            if (term->distance != YK_NONE) {
                slide = find_column(p, b, true, term->distance);
                if (slide >= 0) {
                    rows[slide] = yk_graph_add(g, rows[slide], v.x);
                    rows[n + (size_t)slide] = yk_graph_add(g, rows[n + (size_t)slide], v.y);
                }
                v = yk_graph_vec_scale(g, slide >= 0 ? x[slide] : p->distance[term->distance], v);
            }
            total = yk_graph_vec_add(g, total, v);
            if (turn >= 0) {
                rows[turn] = yk_graph_subtract(g, rows[turn], v.y);
                rows[n + (size_t)turn] = yk_graph_add(g, rows[n + (size_t)turn], v.x);
            }
        }
        residual[2 * l] = total.x;
        residual[2 * l + 1] = total.y;
    }
}

void yk_block_place_group(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    size_t n = b->column_count, m = yk_block_rows(b);
    if (n != m) {
        yk_problem(p->problems, YK_CODE_NOT_PRINTABLE, (YkPlace){0},
                   "the group of %q repeats constraints: its position is found by least squares, which is not printed",
                   b->label);
        p->failed = true;
        return;
    }
    placed->unknown = YK_NEW(p->arena, YkRef, n);
    placed->residual = YK_NEW(p->arena, YkRef, m);
    placed->jacobian = YK_NEW(p->arena, YkRef, m * n);
    placed->solution = YK_NEW(p->arena, YkRef, n);
    placed->at = YK_NEW(p->arena, YkRef, m * n);
    YkRef *guess = YK_NEW(p->arena, YkRef, n), *unused = YK_NEW(p->arena, YkRef, m);
    if (yk_arena_failed(p->arena)) {
        g->failed = p->failed = true;
        return;
    }
    for (size_t k = 0; k < n; k++) {
        placed->unknown[k] =
            yk_graph_leaf(g, YK_LEAF_UNKNOWN, yk_graph_text(&p->graph, "x_%s[%d]", placed->name, (int)k));
        guess[k] = yk_graph_leaf(g, YK_LEAF_POSE, yk_graph_text(&p->graph, "c->%s_guess[%d]", placed->name, (int)k));
    }
    evaluate(p, b, placed->unknown, placed->residual, placed->jacobian);
    for (size_t k = 0; k < m; k++) yk_graph_minus(g, placed->residual[k]); // with the sign that Newton's method needs
    yk_graph_section(
        g, yk_graph_text(&p->graph, "%s: a group of %d loops, by Newton's method.", b->label, (int)b->loop_count));
    placed->call = yk_graph_call(g, (YkCall){.kind = YK_CALL_GROUP,
                                             .index = (int32_t)index,
                                             .n = (int32_t)n,
                                             .arguments = guess,
                                             .argument_count = n,
                                             .result_count = n + 2,
                                             .name = placed->name});
    for (size_t k = 0; k < n; k++) {
        const YkColumn *c = &p->mech->group_columns[b->first_column + k];
        placed->solution[k] = yk_graph_result(g, placed->call, k);
        if (c->is_distance)
            yk_program_set_distance(p, c->index, placed->solution[k]);
        else
            yk_program_set_unit(p, c->index, yk_graph_unit(g, placed->solution[k]));
    }
    evaluate(p, b, placed->solution, unused, placed->at);
    // The sign of the determinant is the branch; its square is the margin.
    YkRef miss = yk_graph_result(g, placed->call, n), det = yk_graph_result(g, placed->call, n + 1);
    YkRef on_branch = yk_graph_multiply(g, det, yk_block_branch(p, index));
    p->missed = yk_graph_binary(g, YK_VALUE_LARGEST, p->missed, miss);
    YkRef minus_one = yk_graph_number(g, -1), square = yk_graph_multiply(g, det, det);
    yk_block_keep_margin(p, yk_graph_choose(g, on_branch, minus_one, square), miss);
}
