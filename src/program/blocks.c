// Computes one block's position: what all kinds share, and blocks that repeat constraints.
#include "program/blocks.h"

YkRef yk_block_branch(YkProgram *p, size_t block)
{
    return yk_graph_leaf(&p->graph, YK_LEAF_POSE, yk_graph_text(&p->graph, "c->%s", p->names.block[block]));
}

// Keeps the least margin; NaN once a block is not finite.
void yk_block_keep_margin(YkProgram *p, YkRef margin, YkRef result)
{
    YkGraph *g = &p->graph;
    bool is_first = yk_graph_is_number(g, p->margin, 1);
    YkRef least = is_first ? margin : yk_graph_binary(g, YK_VALUE_LEAST, margin, p->margin);
    p->margin = yk_graph_add(g, least, yk_graph_unary(g, YK_VALUE_WITNESS, result));
}

void yk_block_set_unit(YkProgram *p, int32_t slot, YkRefVec e)
{
    const char *name = yk_program_slot_name(p, slot);
    p->unit[slot] = e;
    yk_graph_name(&p->graph, e.x, "%s_c", name);
    yk_graph_name(&p->graph, e.y, "%s_s", name);
}

void yk_block_set_distance(YkProgram *p, int32_t distance, YkRef d)
{
    p->distance[distance] = yk_graph_name(&p->graph, d, "%s", yk_program_distance_name(p, distance));
}

void yk_block_name(YkProgram *p, YkRefVec v, const char *block, const char *what)
{
    yk_graph_name(&p->graph, v.x, "%s_%s_x", block, what);
    yk_graph_name(&p->graph, v.y, "%s_%s_y", block, what);
}

YkRefVec yk_block_line(YkProgram *p, const YkBlock *b, size_t column, size_t k)
{
    YkRefVec u = yk_program_line(p, b->column[column].index, b->line[k]);
    return yk_graph_vec_multiply(&p->graph, p->unit[b->line_slot[k]], u);
}

void yk_program_keep_gap(YkProgram *p, YkRef gap)
{
    YkGraph *g = &p->graph;
    YkRef largest = yk_graph_binary(g, YK_VALUE_LARGEST, gap, p->gap);
    p->gap = yk_graph_add(g, largest, yk_graph_unary(g, YK_VALUE_WITNESS, gap));
}

static void place_redundant(YkProgram *p, size_t index, YkPlaced *placed)
{
    YkGraph *g = &p->graph;
    const YkBlock *b = &p->mech->blocks[index];
    YkRefVec K = placed->known;
    YkRef length = yk_graph_vec_length(g, K);
    if (b->kind == YK_BLOCK_CHECK) {
        yk_program_keep_gap(p, length);
    } else if (b->column[0].is_distance) { // GUIDE
        placed->e[0] = yk_block_line(p, b, 0, 0);
        yk_block_set_distance(p, b->column[0].index, yk_graph_minus(g, yk_graph_dot(g, K, placed->e[0])));
        yk_program_keep_gap(p, yk_graph_unary(g, YK_VALUE_SIZE, yk_graph_cross(g, K, placed->e[0])));
    } else { // LINK
        YkRefVec U = yk_program_sum(p, &b->aside->arm[0]),
                 z = yk_graph_vec_multiply(g, K, yk_graph_vec_conjugate(g, U));
        YkRef per = yk_graph_minus(g, yk_graph_inverse(g, yk_graph_vec_length(g, z)));
        YkRef arm = yk_graph_vec_length(g, U);
        placed->e[0] = yk_graph_vec_scale(g, per, z);
        yk_block_set_unit(p, b->column[0].index, placed->e[0]);
        placed->p = yk_graph_vec_multiply(g, U, placed->e[0]);
        yk_program_keep_gap(p, yk_graph_unary(g, YK_VALUE_SIZE, yk_graph_subtract(g, length, arm)));
    }
}

void yk_program_place(YkProgram *p, size_t index)
{
    static const char *const what[] = {"two circles intersect",
                                       "a circle intersects a line",
                                       "a line turns about a pin through a point",
                                       "two lines intersect",
                                       "one unknown, checked",
                                       "checked",
                                       ""};
    const YkBlock *b = &p->mech->blocks[index];
    YkPlaced *placed = &p->placed[index];
    placed->name = p->names.block[index];
    if (b->kind == YK_BLOCK_GROUP) {
        yk_block_place_group(p, index, placed);
        return;
    }
    yk_graph_section(&p->graph, yk_graph_text(&p->graph, "%s: %s, %s. K: the known part of its loop.", b->label,
                                              yk_block_kind_name(b->kind), what[b->kind]));
    placed->known = yk_program_sum(p, &b->known);
    yk_block_name(p, placed->known, placed->name, "K");
    switch (b->kind) {
    case YK_BLOCK_RRR:
        yk_block_place_rrr(p, index, placed);
        break;
    case YK_BLOCK_RRP:
        yk_block_place_rrp(p, index, placed);
        break;
    case YK_BLOCK_RPR:
        yk_block_place_rpr(p, index, placed);
        break;
    case YK_BLOCK_PP:
        yk_block_place_pp(p, index, placed);
        break;
    default:
        place_redundant(p, index, placed);
        break;
    }
}
