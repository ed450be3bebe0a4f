// Computes the position of one block, of any kind; itself those of blocks that repeat constraints.
#include "program/blocks.h"

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
        yk_program_set_distance(p, b->column[0].index, yk_graph_minus(g, yk_graph_dot(g, K, placed->e[0])));
        yk_program_keep_gap(p, yk_graph_unary(g, YK_VALUE_SIZE, yk_graph_cross(g, K, placed->e[0])));
    } else { // LINK
        YkRefVec U = yk_program_sum(p, &b->aside->arm[0]),
                 z = yk_graph_vec_multiply(g, K, yk_graph_vec_conjugate(g, U));
        YkRef per = yk_graph_minus(g, yk_graph_inverse(g, yk_graph_vec_length(g, z)));
        YkRef arm = yk_graph_vec_length(g, U);
        placed->e[0] = yk_graph_vec_scale(g, per, z);
        yk_program_set_unit(p, b->column[0].index, placed->e[0]);
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
