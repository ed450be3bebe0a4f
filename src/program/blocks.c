// The position of a block: what all kinds share.
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
